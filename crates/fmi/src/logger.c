/* fmi2CallbackLogger: formats the message and hands it on. */
#include <stdarg.h>
#include <stdio.h>

void cordon_fmi_log(void *environment, int status, const char *message);

void cordon_fmi2_logger(void *environment, const char *instance, int status, const char *category,
                        const char *message, ...) {
    char text[2048];
    va_list arguments;
    (void)instance;
    (void)category;
    if (message == NULL) {
        cordon_fmi_log(environment, status, "a message without text");
        return;
    }
    va_start(arguments, message);
    vsnprintf(text, sizeof text, message, arguments);
    va_end(arguments);
    cordon_fmi_log(environment, status, text);
}

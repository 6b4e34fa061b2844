/* A plant for tests of the import: 4 inputs (value references 0 to 3), 12 outputs (4 to 15), the
   parameters x0, y0, z0 (100 to 102), an integer (103), a Boolean (104) and a text (105); x grows by the step each step. FAULT says what goes wrong in
   step 20; FMI is the version of the standard. CORDON_TEST_TRACE names a file for the calls. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum fault {
    NONE, ERROR, DISCARD, NOT_A_NUMBER, SEGFAULT, NULL_CATEGORY, NULL_MESSAGE, NO_INSTANCE, ABORT,
    EXIT, HANG, PENDING, WARNING, FATAL, LATE_LOG, EARLY_ONLY, LATE_ONLY, SPAM, FORGETFUL, ONCE
};

typedef void (*logger2)(void *, const char *, int, const char *, const char *, ...);
typedef void (*logger3)(void *, int, const char *, const char *);
typedef struct {
    logger2 logger;
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*finished)(void *, int);
    void *environment;
} callbacks;

typedef struct {
    double in[4], out[12], start[3];
    int whole, flag;
    char label[32];
    const callbacks *callbacks;
    logger3 logger3;
    void *environment;
    int steps;
    bool set_up, initialising, running;
} plant;

static int instances = 0;

static void trace(const char *text, double x) {
    const char *name = getenv("CORDON_TEST_TRACE");
    FILE *file = name ? fopen(name, "a") : NULL;
    if (file) {
        fprintf(file, "%s %.17g\n", text, x);
        fclose(file);
    }
}

static void say(plant *p, int status, const char *category, const char *message) {
#if FMI == 2
    p->callbacks->logger(p->callbacks->environment, "plant", status, category, message, 42, 2.5);
#else
    p->logger3(p->environment, status, category, message);
#endif
}

static plant *made(void) {
    if (FAULT == NO_INSTANCE || (FAULT == ONCE && instances++ > 0)) return NULL;
    return calloc(1, sizeof(plant));
}

static int set(plant *p, const unsigned *references, size_t count, const double *values) {
    for (size_t k = 0; k < count; k++) {
        unsigned r = references[k];
        if (r < 4) p->in[r] = values[k];
        if (r >= 100 && r < 103) {
            trace(p->initialising ? "parameter late" : "parameter early", values[k]);
            if (FAULT == FORGETFUL) continue;
            /* As a tool that reads its parameters when the experiment is set up, and one that
               takes them in the initialisation only. */
            if (FAULT == EARLY_ONLY && p->initialising) continue;
            if (FAULT == LATE_ONLY && !p->initialising) continue;
            p->start[r - 100] = values[k];
        }
    }
    return 0;
}

static int get(plant *p, const unsigned *references, size_t count, double *values) {
    for (size_t k = 0; k < count; k++) {
        unsigned r = references[k];
        values[k] = r < 4 ? p->in[r] : r < 16 ? p->out[r - 4] : r < 103 ? p->start[r - 100] : 0;
    }
    return 0;
}

static int set_whole(plant *p, long value) {
    trace("integer", value);
    if (FAULT != FORGETFUL) p->whole = value;
    return 0;
}

static int set_flag(plant *p, bool value) {
    trace("boolean", value);
    if (FAULT != FORGETFUL) p->flag = value;
    return 0;
}

static int set_label(plant *p, const char *value) {
    trace(value, strlen(value));
    if (FAULT != FORGETFUL) snprintf(p->label, sizeof p->label, "%s", value);
    return 0;
}

static int enter(plant *p) {
    trace("enter", 0);
    p->initialising = true;
    return 0;
}

static int leave(plant *p) {
    trace("leave", 0);
    memcpy(p->out, p->start, sizeof p->start);
    p->initialising = false;
    p->running = true;
    return 0;
}

static int step(plant *p, double from, double size) {
    p->out[0] += size;
    if (++p->steps != 20) return 0;
    switch (FAULT) {
    case ERROR: say(p, 3, "logStatusError", "engine number %d is cold, %.1f%%"); return 3;
    case DISCARD: return 2;
    case NOT_A_NUMBER: p->out[0] = NAN; return 0;
    case SEGFAULT: *(volatile int *)0 = 1; return 0;
    case NULL_CATEGORY: say(p, 1, NULL, "no category"); return 0;
    case NULL_MESSAGE: say(p, 1, "w", NULL); return 0;
    case ABORT: abort();
    case EXIT: exit(0);
    case HANG: for (;;) sleep(1000);
    case PENDING: say(p, 5, "w", "still at it"); return FMI == 2 ? 5 : 0;
    case WARNING: say(p, 1, "w", "low battery"); return 1;
    case FATAL: say(p, 4, "f", "out of fuel"); return 4;
    case SPAM: for (int k = 0; k < 100000; k++) say(p, 1, "w", "again"); return 0;
    default: return 0;
    }
}

static void released(plant *p) {
    trace("free", 0);
    if (FAULT == LATE_LOG) say(p, 1, "w", "goodbye");
    free(p);
}

#if FMI == 2
void *fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                      const callbacks *callbacks, int visible, int logging) {
    plant *p = made();
    trace(strncmp(resources, "file:///", 8) ? "resources wrong" : "resources right", 0);
    if (p) p->callbacks = callbacks;
    else callbacks->logger(callbacks->environment, name, 3, "e", "no licence for `%s`", guid);
    return p;
}
int fmi2SetupExperiment(plant *p, int tolerance, double t, double start, int stops, double stop) {
    trace("set up", stop);
    p->set_up = true;
    memset(p->start, 0, sizeof p->start);
    return 0;
}
int fmi2EnterInitializationMode(plant *p) { return enter(p); }
#ifndef INCOMPLETE
int fmi2ExitInitializationMode(plant *p) { return leave(p); }
#endif
int fmi2Terminate(plant *p) { trace("terminate", p->steps); return 0; }
void fmi2FreeInstance(plant *p) { released(p); }
int fmi2GetReal(plant *p, const unsigned *r, size_t n, double *v) { return get(p, r, n, v); }
int fmi2SetReal(plant *p, const unsigned *r, size_t n, const double *v) { return set(p, r, n, v); }
int fmi2DoStep(plant *p, double from, double size, int prior) { return step(p, from, size); }
int fmi2GetInteger(plant *p, const unsigned *r, size_t n, int *v) { *v = p->whole; return 0; }
int fmi2SetInteger(plant *p, const unsigned *r, size_t n, const int *v) { return set_whole(p, *v); }
int fmi2GetBoolean(plant *p, const unsigned *r, size_t n, int *v) { *v = p->flag; return 0; }
int fmi2SetBoolean(plant *p, const unsigned *r, size_t n, const int *v) { return set_flag(p, *v); }
int fmi2GetString(plant *p, const unsigned *r, size_t n, const char **v) { *v = p->label; return 0; }
int fmi2SetString(plant *p, const unsigned *r, size_t n, const char *const *v) { return set_label(p, *v); }
int fmi2GetStatus(plant *p, int kind, int *status) { *status = 0; return 0; }
#else
void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources,
                                  bool visible, bool logging, bool events, bool early,
                                  const unsigned *variables, size_t count, void *environment,
                                  logger3 logger, void (*update)(void)) {
    plant *p = made();
    size_t length = strlen(resources);
    trace(length && resources[length - 1] == '/' ? "resources right" : "resources wrong", 0);
    if (p) { p->logger3 = logger; p->environment = environment; }
    return p;
}
int fmi3EnterInitializationMode(plant *p, bool t, double tolerance, double start, bool s, double e) {
    return enter(p);
}
int fmi3ExitInitializationMode(plant *p) { return leave(p); }
int fmi3Terminate(plant *p) { trace("terminate", p->steps); return 0; }
void fmi3FreeInstance(plant *p) { released(p); }
int fmi3GetFloat64(plant *p, const unsigned *r, size_t n, double *v, size_t m) {
    return get(p, r, n, v);
}
int fmi3SetFloat64(plant *p, const unsigned *r, size_t n, const double *v, size_t m) {
    return set(p, r, n, v);
}
int fmi3GetInt8(plant *p, const unsigned *r, size_t n, int8_t *v, size_t m) { *v = p->whole; return 0; }
int fmi3SetInt8(plant *p, const unsigned *r, size_t n, const int8_t *v, size_t m) { return set_whole(p, *v); }
int fmi3GetUInt64(plant *p, const unsigned *r, size_t n, uint64_t *v, size_t m) { *v = p->whole; return 0; }
int fmi3SetUInt64(plant *p, const unsigned *r, size_t n, const uint64_t *v, size_t m) { return set_whole(p, *v); }
int fmi3GetBoolean(plant *p, const unsigned *r, size_t n, bool *v, size_t m) { *v = p->flag; return 0; }
int fmi3SetBoolean(plant *p, const unsigned *r, size_t n, const bool *v, size_t m) { return set_flag(p, *v); }
int fmi3GetString(plant *p, const unsigned *r, size_t n, const char **v, size_t m) { *v = p->label; return 0; }
int fmi3SetString(plant *p, const unsigned *r, size_t n, const char *const *v, size_t m) { return set_label(p, *v); }
int fmi3DoStep(plant *p, double from, double size, bool prior, bool *event, bool *end, bool *early,
               double *last) {
    *event = *end = *early = false;
    *last = from + size;
    return step(p, from, size);
}
#endif

/* The sweep of theorem 7.2 in C, for comparison with `cordon sweep`: every strictly ordered integer
 * start of N = 5 drones on a segment of LENGTH grid units, eps = P/Q, steps k = 0 .. K, integers
 * over the common denominator (of the type NUMBER, which has to hold them); of two starts that are mirror images only the smaller. LANES starts
 * at once, which the compiler turns into vector instructions. Arguments LENGTH P Q K; prints drone
 * updates and violations. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef NUMBER
#define NUMBER int64_t
#endif
typedef NUMBER number;

enum { N = 5, LANES = 32 };
static number P, Q;
static int K;

static number x[N][LANES];
static int filled;
static uint64_t updates, violations;

static void run(void) {
    number wrong[LANES] = {0};
    for (int k = 0; k <= K; k++) {
        if (k > 0) {
            number before[LANES];
            for (int l = 0; l < LANES; l++) before[l] = x[0][l], x[0][l] *= Q;
            for (int i = 1; i < N - 1; i++)
                for (int l = 0; l < LANES; l++) {
                    number own = x[i][l];
                    x[i][l] = P * before[l] + (Q - 2 * P) * own + P * x[i + 1][l];
                    before[l] = own;
                }
            for (int l = 0; l < LANES; l++) x[N - 1][l] *= Q;
        }
        number crossed[LANES] = {0};
        for (int i = 0; i + 1 < N; i++)
            for (int l = 0; l < LANES; l++) crossed[l] |= x[i][l] >= x[i + 1][l];
        for (int l = 0; l < LANES; l++) wrong[l] += crossed[l];
    }
    for (int l = 0; l < filled; l++) violations += wrong[l];
    updates += (uint64_t)filled * N * K;
    filled = 0;
}

int main(int argc, char **argv) {
    if (argc < 5) return 2;
    /* Not known to the compiler, as they are not to Cordon. */
    int64_t length = atoll(argv[1]);
    P = atoll(argv[2]), Q = atoll(argv[3]), K = atoi(argv[4]);
    for (int64_t a = 1; a < length; a++)
        for (int64_t b = a + 1; b < length; b++)
            for (int64_t c = b + 1; c < length; c++) {
                /* The mirror image is (0, length - c, length - b, length - a, length). */
                if (length - c < a || (length - c == a && length - b < b)) continue;
                int64_t start[N] = {0, a, b, c, length};
                for (int i = 0; i < N; i++) x[i][filled] = start[i];
                if (++filled == LANES) run();
            }
    run();
    printf("%" PRIu64 " drone updates, %" PRIu64 " violations\n", updates, violations);
}

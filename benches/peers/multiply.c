/* A product of two random integers of BITS bits, by GMP, or by FLINT's fft_small where FFT_SMALL is
   defined: the unit that a jump is measured in. Prints seconds, the best of several. Argument: BITS. */
#ifdef FFT_SMALL
#include <flint/fft_small.h>
#endif
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static void multiply(mp_limb_t *c, const mp_limb_t *a, const mp_limb_t *b, long n)
{
#ifdef FFT_SMALL
    mpn_mul_default_mpn_ctx(c, a, n, b, n);
#else
    mpn_mul_n(c, a, b, n);
#endif
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "expected BITS\n");
        return 2;
    }
    long n = (atol(argv[1]) + 63) / 64;
    mp_limb_t *a = malloc(n * sizeof *a), *b = malloc(n * sizeof *b), *c = malloc(2 * n * sizeof *c);
    mpn_random(a, n);
    mpn_random(b, n);
    double best = 1e9, all = 0;
    for (int round = 0; round < 5 || all < 0.3; round++) {
        struct timespec t, u;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        multiply(c, a, b, n);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &u);
        double seconds = u.tv_sec - t.tv_sec + (u.tv_nsec - t.tv_nsec) * 1e-9;
        all += seconds;
        if (seconds < best)
            best = seconds;
    }
    printf("%.6f\n", best);
    return 0;
}

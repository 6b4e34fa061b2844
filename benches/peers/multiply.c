/* One GMP multiplication of two random integers of BITS bits: the unit that a jump is measured
   in. Prints seconds, the best of a few. Argument: BITS. */
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "expected BITS\n");
        return 2;
    }
    gmp_randstate_t random;
    mpz_t a, b, c;
    double best = 1e9;
    gmp_randinit_default(random);
    mpz_inits(a, b, c, NULL);
    mpz_urandomb(a, random, atol(argv[1]));
    mpz_urandomb(b, random, atol(argv[1]));
    for (int round = 0; round < 5; round++) {
        struct timespec t, u;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        mpz_mul(c, a, b);
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &u);
        double seconds = u.tv_sec - t.tv_sec + (u.tv_nsec - t.tv_nsec) * 1e-9;
        if (seconds < best)
            best = seconds;
    }
    printf("%.6f\n", best);
    return 0;
}

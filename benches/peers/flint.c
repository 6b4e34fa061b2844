/* kth_step with FLINT, three ways. Arguments: N K step | matrix | rational.
   step:     integers over the common denominator (N-1)*5^k, every step
   matrix:   the k-th power of the integer matrix 5*A, then one product with the start
   rational: the k-th power of the rational matrix A by repeated squaring */
#include <flint/flint.h>
#include <flint/fmpz.h>
#include <flint/fmpz_vec.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + t.tv_nsec * 1e-9;
}

static void fold(fmpz_t h, const fmpz_t num, const fmpz_t den, const fmpz_t p)
{
    fmpz_t r;
    fmpz_init(r);
    fmpz_mod(r, den, p);
    fmpz_invmod(r, r, p);
    fmpz_mul(r, r, num);
    fmpz_mul_ui(h, h, 1000003);
    fmpz_add(h, h, r);
    fmpz_mod(h, h, p);
    fmpz_clear(r);
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "expected N K step|matrix|rational\n");
        return 2;
    }
    slong n = atol(argv[1]), k = atol(argv[2]), i;
    double begun, seconds;
    fmpz_t den, h, p;
    fmpz *x = _fmpz_vec_init(n), *y = _fmpz_vec_init(n);
    fmpz_init(den);
    fmpz_init(h);
    fmpz_init_set_ui(p, 1);
    fmpz_mul_2exp(p, p, 61);
    fmpz_sub_ui(p, p, 1);
    for (i = 0; i < n; i++)
        fmpz_set_si(x + i, i == n - 1 ? 100 * (n - 1) : 40 * i);

    if (!strcmp(argv[3], "step")) {
        begun = now();
        for (slong s = 0; s < k; s++) {
            fmpz_mul_ui(y, x, 5);
            fmpz_mul_ui(y + n - 1, x + n - 1, 5);
            for (i = 1; i < n - 1; i++) {
                fmpz_add(y + i, x + i - 1, x + i + 1);
                fmpz_addmul_ui(y + i, x + i, 3);
            }
            fmpz *t = x;
            x = y;
            y = t;
        }
        seconds = now() - begun;
        fmpz_set_ui(den, 5);
        fmpz_pow_ui(den, den, k);
        fmpz_mul_ui(den, den, n - 1);
    } else if (!strcmp(argv[3], "matrix")) {
        fmpz_mat_t a, v, w;
        fmpz_mat_init(a, n, n);
        fmpz_mat_init(v, n, 1);
        fmpz_mat_init(w, n, 1);
        for (i = 0; i < n; i++) {
            fmpz_set(fmpz_mat_entry(v, i, 0), x + i);
            if (i == 0 || i == n - 1) {
                fmpz_set_ui(fmpz_mat_entry(a, i, i), 5);
            } else {
                fmpz_set_ui(fmpz_mat_entry(a, i, i - 1), 1);
                fmpz_set_ui(fmpz_mat_entry(a, i, i), 3);
                fmpz_set_ui(fmpz_mat_entry(a, i, i + 1), 1);
            }
        }
        begun = now();
        fmpz_mat_pow(a, a, k);
        fmpz_mat_mul(w, a, v);
        seconds = now() - begun;
        for (i = 0; i < n; i++)
            fmpz_set(x + i, fmpz_mat_entry(w, i, 0));
        fmpz_set_ui(den, 5);
        fmpz_pow_ui(den, den, k);
        fmpz_mul_ui(den, den, n - 1);
    } else {
        fmpq_mat_t a, v, w;
        fmpq_mat_init(a, n, n);
        fmpq_mat_init(v, n, 1);
        fmpq_mat_init(w, n, 1);
        for (i = 0; i < n; i++) {
            fmpq_set_si(fmpq_mat_entry(v, i, 0), i == n - 1 ? 100 * (n - 1) : 40 * i, n - 1);
            if (i == 0 || i == n - 1) {
                fmpq_set_si(fmpq_mat_entry(a, i, i), 1, 1);
            } else {
                fmpq_set_si(fmpq_mat_entry(a, i, i - 1), 1, 5);
                fmpq_set_si(fmpq_mat_entry(a, i, i), 3, 5);
                fmpq_set_si(fmpq_mat_entry(a, i, i + 1), 1, 5);
            }
        }
        begun = now();
        for (slong e = k; e > 0; e >>= 1) {
            if (e & 1) {
                fmpq_mat_mul(w, a, v);
                fmpq_mat_swap(v, w);
            }
            if (e > 1) {
                fmpq_mat_t b;
                fmpq_mat_init(b, n, n);
                fmpq_mat_mul(b, a, a);
                fmpq_mat_swap(a, b);
                fmpq_mat_clear(b);
            }
        }
        seconds = now() - begun;
        for (i = 0; i < n; i++)
            fold(h, fmpq_mat_entry_num(v, i, 0), fmpq_mat_entry_den(v, i, 0), p);
    }
    if (strcmp(argv[3], "rational"))
        for (i = 0; i < n; i++)
            fold(h, x + i, den, p);
    printf("%.6f ", seconds);
    char *s = fmpz_get_str(NULL, 16, h);
    for (i = strlen(s); i < 15; i++)
        putchar('0');
    printf("%s\n", s);
    return 0;
}

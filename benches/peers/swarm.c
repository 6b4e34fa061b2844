/* A co-simulated swarm as a plain loop over doubles: N drones from 0 to 40 m, the last at 100 m,
 * eps = 1/5, an update every 4 steps of 0.05 s, Euler plants, a Jacobi exchange.
 * swarm N SECONDS [FILE]: the last row, or the whole run as CSV into FILE. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { X, Y, Z, VX, VY, VZ, PHI, THETA, PSI, VPHI, VTHETA, VPSI, STATE };

static const double g = 9.81, arm = 0.3, inertia = 0.001, lp = 0.4, la = 4, tau = 0.05, z_d = 1;

struct drone { double state[STATE], rotors[4]; };

static double attitude(double angle, double wanted, double speed, double c) {
    return -speed * 2 * la / c - (angle - wanted) * la * la / c;
}

static void control(const double *s, double x_d, double *w) {
    double hover = sqrt(g), climb = 2 * sqrt(g), c = arm * hover / inertia, turn = hover / inertia;
    double u_x = 2 * lp * s[VX] + lp * lp * (s[X] - x_d), u_y = 2 * lp * s[VY] + lp * lp * s[Y];
    double w_z = -s[VZ] * 2 * lp / climb - (s[Z] - z_d) * lp * lp / climb;
    double w_phi = attitude(s[PHI], u_y / g, s[VPHI], c);
    double w_theta = attitude(s[THETA], -u_x / g, s[VTHETA], c);
    double w_psi = attitude(s[PSI], 0, s[VPSI], turn);
    w[0] = w_z / 4 - w_theta / 2 + w_psi / 4;
    w[1] = w_z / 4 + w_phi / 2 - w_psi / 4;
    w[2] = w_z / 4 + w_theta / 2 + w_psi / 4;
    w[3] = w_z / 4 - w_phi / 2 - w_psi / 4;
}

static void plant(double *s, const double *w) {
    double hover = sqrt(g), lift = 2 * sqrt(g);
    double rates[STATE] = {
        s[VX], s[VY], s[VZ], g * s[THETA], -g * s[PHI], lift * (w[0] + w[1] + w[2] + w[3]),
        s[VPHI], s[VTHETA], s[VPSI], arm * hover * (w[1] - w[3]) / inertia,
        arm * hover * (w[2] - w[0]) / inertia, hover * (w[0] + w[2] - w[1] - w[3]) / inertia };
    for (int k = 0; k < STATE; k++) s[k] += rates[k] * tau;
}

static void row(FILE *out, double t, const double *x_d, const struct drone *d, int n) {
    fprintf(out, "%.17g", t);
    for (int i = 0; i < n; i++) fprintf(out, ",%.17g", x_d[i]);
    for (int i = 0; i < n; i++) fprintf(out, ",%.17g", d[i].state[X]);
    fputc('\n', out);
}

int main(int argc, char **argv) {
    int n = argc > 1 ? atoi(argv[1]) : 1000, steps = (int)(20 * (argc > 2 ? atof(argv[2]) : 100));
    FILE *out = argc > 3 ? fopen(argv[3], "w") : NULL;
    struct drone *d = calloc(n, sizeof *d);
    double *x_d = calloc(n, sizeof *x_d), *next = calloc(n, sizeof *next);
    if (n < 3 || !d || !x_d || !next || (argc > 3 && !out)) return 1;
    for (int i = 0; i < n; i++) d[i].state[X] = x_d[i] = i == n - 1 ? 100 : 40.0 * i / (n - 1);
    for (int k = 0; k <= steps; k++) {
        if (out) row(out, k * tau, x_d, d, n);
        if (k == steps) break;
        for (int i = 0; i < n; i++) {
            double rotors[4];
            control(d[i].state, x_d[i], rotors);
            plant(d[i].state, d[i].rotors);
            memcpy(d[i].rotors, rotors, sizeof rotors);
        }
        if (k % 4 == 0) {
            memcpy(next, x_d, n * sizeof *next);
            for (int i = 1; i + 1 < n; i++) next[i] = x_d[i] + 0.2 * (x_d[i - 1] + x_d[i + 1] - 2 * x_d[i]);
            /* The ends look half a gap beyond themselves: they are at their places. */
            memcpy(x_d, next, n * sizeof *next);
        }
    }
    if (!out) row(stdout, steps * tau, x_d, d, n);
    return out ? fclose(out) != 0 : 0;
}

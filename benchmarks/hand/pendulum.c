/* N point masses on massless rods in a row under a cart, by hand.
   y = (x, theta1..thetaN, x', theta1'..thetaN'), p = (M, m, l, g).

   The unknowns are the tensions T_i per mass m.  That rod i keeps its length couples T_{i-1}, T_i, T_{i+1} only, through
   the cosines of the angles between neighbours: a symmetric tridiagonal system, one sweep down and one up.  Newton's
   law across each rod then gives theta_i''. */
#include <math.h>

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double M = p[0], m = p[1], l = p[2], g = p[3], r = 1 / l, mu = m / M;
    const double *q = y + 1, *u = y + N + 2;
    const double s1 = sin(q[0]), c1 = cos(q[0]);
    double s[N + 1], k[N + 1], T[N + 1]; /* s[i]: sin of the angle between rods i and i+1; k[i]: eliminated coefficient */
    double pivot = 1 + mu * s1 * s1;
    (void)t;
    T[0] = l * u[0] * u[0] + g * c1;
    for (int i = 0; i + 1 < N; i++) {
        const double d = q[i + 1] - q[i];
        const double c = cos(d);
        s[i] = sin(d);
        k[i] = c / pivot;
        T[i + 1] = l * u[i + 1] * u[i + 1] + k[i] * T[i];
        T[i] = T[i] / pivot;
        pivot = 2 - c * k[i];
    }
    T[N - 1] = T[N - 1] / pivot;
    for (int i = N - 2; i >= 0; i--)
        T[i] += k[i] * T[i + 1];
    {
        const double ddx = mu * T[0] * s1;
        dydt[0] = y[N + 1];
        dydt[N + 1] = ddx;
        for (int i = 0; i < N; i++) {
            double across = i == 0 ? -g * s1 - ddx * c1 : -T[i - 1] * s[i - 1];
            if (i + 1 < N)
                across += T[i + 1] * s[i];
            dydt[1 + i] = u[i];
            dydt[N + 2 + i] = across * r;
        }
    }
    return 0;
}

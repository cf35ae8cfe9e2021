/* Chaplygin's sleigh by hand.  y = (x, y, theta, v, w), p = (m, J, a).  Newton's law along the edge and for the spin
   about the edge: v' = a w^2, (J + m a^2) w' = -m a v w. */
#include <math.h>

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double m = p[0], J = p[1], a = p[2];
    const double v = y[3], w = y[4];
    const double ma = m * a;
    (void)t;
    dydt[0] = v * cos(y[2]);
    dydt[1] = v * sin(y[2]);
    dydt[2] = w;
    dydt[3] = a * w * w;
    dydt[4] = -ma * v * w / (J + ma * a);
    return 0;
}

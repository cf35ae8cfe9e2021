/* A disk that rolls on a plane, by hand.  y = (x, y, phi, theta, psi, w_t, w_u, w_n), p = (m, R, A, C, g).
   Euler's equations about the centre with the reaction eliminated, in the frame that turns with phi and theta only:
   angular rates along the horizontal diameter (w_t), the line of steepest descent (w_u) and the axis (w_n). */
#include <math.h>

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double m = p[0], R = p[1], A = p[2], C = p[3], g = p[4];
    const double wt = y[5], wu = y[6], wn = y[7];
    const double sp = sin(y[2]), cp = cos(y[2]), s = sin(y[3]), c = cos(y[3]);
    const double rate = wu / s;  /* phi' */
    const double drag = rate * c; /* turn of the frame about the axis */
    const double mR = m * R, mR2 = mR * R, spin = C + mR2;
    const double Rn = R * wn, Rt = R * s * wt;
    (void)t;
    dydt[0] = Rt * sp - Rn * cp;
    dydt[1] = -Rt * cp - Rn * sp;
    dydt[2] = rate;
    dydt[3] = wt;
    dydt[4] = wn - drag;
    dydt[5] = ((A * drag - spin * wn) * wu - mR * g * c) / (A + mR2);
    dydt[6] = (C / A * wn - drag) * wt;
    dydt[7] = mR2 / spin * wt * wu;
    return 0;
}

/* A steered car with N trailers hitched axle to axle, by hand.
   y = (x, y, theta0, phi, theta1..thetaN, v, w = phi'), p = (m0, J0, Js, m, J, L).

   One pass down the train.  With d_i = theta_{i-1} - theta_i, axle i runs at S_i v, S_i = S_{i-1} cos d_i, and turns at
   K_i v / L, K_i = S_{i-1} sin d_i.  No axle has a sideways velocity, so that the reduced mass is
   m0 + m sum S^2 + J/L^2 sum K^2 and its convective term m sum S S' + J/L^2 sum K K'. */
#include <math.h>

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double m0 = p[0], J0 = p[1], Js = p[2], m = p[3], J = p[4], L = p[5];
    const double v = y[N + 4], w = y[N + 5];
    const double r = 1 / L, vr = v * r;
    const double cphi = cos(y[3]);
    const double K0 = sin(y[3]) / cphi;       /* tan phi: the car turns at K0 v / L */
    const double dK0 = w * (1 + K0 * K0);
    double S = 1, K = K0, dS = 0;
    double SS = 0, SdS = 0, KK = 0, KdK = 0;
    double theta = y[2];
    (void)t;
    dydt[0] = v * cos(theta);
    dydt[1] = v * sin(theta);
    dydt[2] = K0 * vr;
    dydt[3] = w;
    for (int i = 0; i < N; i++) {
        const double d = theta - y[4 + i];
        const double s = sin(d), c = cos(d);
        const double k = S * s;
        const double dd = (K - k) * vr;
        double dk;
        theta = y[4 + i];
        dydt[4 + i] = k * vr;
        S = S * c;
        dk = dS * s + S * dd;
        dS = dS * c - k * dd;
        SS += S * S;
        SdS += S * dS;
        KK += k * k;
        KdK += k * dk;
        K = k;
    }
    {
        /* car and steered axle: (J0 + Js) theta0' theta0'' + Js phi'' of theta0' = K0 v / L */
        const double j = J * r * r, k0 = K0 * r, dk0 = dK0 * r;
        const double M = m0 + m * SS + j * KK + J0 * k0 * k0;
        const double f = (m * SdS + j * KdK + J0 * k0 * dk0) * v;
        /* Js (theta0'' + phi'') = 0 on the steering axis, so that it drops out of the equation of v */
        const double dv = -f / M;
        dydt[N + 4] = dv;
        dydt[N + 5] = -(k0 * dv + dk0 * v);
    }
    (void)Js;
    return 0;
}

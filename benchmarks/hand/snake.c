/* N links hinged in a row with a knife edge under the middle of each, by hand.
   y = (x, y, theta1..thetaN, v, w = theta1'), p = (m, J, a).

   One pass down the chain.  With d = theta_{i-1} - theta_i, speed v_i along link i and b_i = a theta_i', the hinge and
   the edge give v_i = v_{i-1} cos d + b_{i-1} sin d, b_i = v_{i-1} sin d - b_{i-1} cos d: the same for the two partial
   velocities (V1, B1), (V2, B2) of v and a w, and for their convective rates (e, h) with two more terms. */
#include <math.h>

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double m = p[0], a = p[2], r = 1 / a, j = p[1] * r * r;
    const double v0 = y[N + 2], b0 = a * y[N + 3];
    double v = v0, b = b0, V1 = 1, B1 = 0, V2 = 0, B2 = 1, e = 0, h = 0;
    double vv11 = 1, vv12 = 0, vv22 = 0, bb11 = 0, bb12 = 0, bb22 = 1;
    double ve1 = 0, ve2 = 0, bh1 = 0, bh2 = 0;
    double theta = y[2];
    (void)t;
    dydt[0] = v0 * cos(theta);
    dydt[1] = v0 * sin(theta);
    dydt[2] = y[N + 3];
    for (int i = 1; i < N; i++) {
        const double d = theta - y[2 + i];
        const double s = sin(d), c = cos(d);
        const double vi = v * c + b * s, bi = v * s - b * c;
        const double dd = (b - bi) * r;
        const double p1 = V1 * c + B1 * s, q1 = V1 * s - B1 * c;
        const double p2 = V2 * c + B2 * s, q2 = V2 * s - B2 * c;
        const double ei = e * c + h * s - bi * dd, hi = e * s - h * c + vi * dd;
        theta = y[2 + i];
        dydt[2 + i] = bi * r;
        v = vi; b = bi; V1 = p1; B1 = q1; V2 = p2; B2 = q2; e = ei; h = hi;
        vv11 += V1 * V1; vv12 += V1 * V2; vv22 += V2 * V2;
        bb11 += B1 * B1; bb12 += B1 * B2; bb22 += B2 * B2;
        ve1 += V1 * e; ve2 += V2 * e;
        bh1 += B1 * h; bh2 += B2 * h;
    }
    {
        const double M11 = m * vv11 + j * bb11, M12 = m * vv12 + j * bb12, M22 = m * vv22 + j * bb22;
        const double f1 = m * ve1 + j * bh1, f2 = m * ve2 + j * bh2;
        const double k = 1 / (M11 * M22 - M12 * M12);
        dydt[N + 2] = (M12 * f2 - M22 * f1) * k;
        dydt[N + 3] = (M12 * f1 - M11 * f2) * k * r;
    }
    return 0;
}

/* Whipple's bicycle by hand, in the coordinates, parameters and free velocities of specs/bicycle.yaml:
   y = (x, y, z, yaw, roll, pitch, steer, thR, thF, roll', steer', thR'), cos(roll) > 0.

   Kane's form in two body frames, both tilted so that their third axis is the steering axis: G on the rear frame, F on the
   front frame, one turn by the steering angle apart; second axis: the axle.  Rear frame and wheel are one rigid body about
   the rear hub, front frame and wheel one about the foot S of the steering axis, but for the spins of the wheels.  That
   both wheels roll leaves two equations E1, E2 for yaw' and pitch'. */
#include <math.h>

typedef struct { double x, y, z; } vec;
/* mass, first moment (x, 0, z), inertia about the reference point without the wheel's axial part, axial part */
typedef struct { double m, x, z, xx, xz, yy, zz, spin; } body;
typedef struct { vec v, w; double s; } motion; /* velocity of the reference point, turn, spin of the wheel */

static inline vec cross(vec a, vec b)
{
    return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline vec add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/* w x (x, 0, z) */
static inline vec swing(vec w, double x, double z) { return (vec){w.y * z, w.z * x - w.x * z, -w.y * x}; }
/* from G to F */
static inline vec steer(vec a, double s, double c) { return (vec){c * a.x + s * a.y, c * a.y - s * a.x, a.z}; }
/* velocity of the rear hub when the wheel rolls; R is the point of contact from the hub */
static inline vec hub(vec w, double spin, double Rx, double Rz)
{
    return (vec){-spin * Rz, w.x * Rz - w.z * Rx, spin * Rx};
}

static inline vec momentum(const body *b, const motion *a)
{
    const vec s = swing(a->w, b->x, b->z);
    return (vec){b->m * a->v.x + s.x, b->m * a->v.y + s.y, b->m * a->v.z + s.z};
}
static inline vec spin_momentum(const body *b, const motion *a)
{
    return (vec){
        b->xx * a->w.x + b->xz * a->w.z - b->z * a->v.y,
        b->yy * a->w.y + b->z * a->v.x - b->x * a->v.z,
        b->xz * a->w.x + b->zz * a->w.z + b->x * a->v.y,
    };
}
static inline double pair(vec p, vec l, double s, const motion *a) { return dot(p, a->v) + dot(l, a->w) + s * a->s; }

/* adds a body's part of M u' = f; e: columns of u, now: its motion, rate: the components' rates at u' = 0, k: down */
static inline void add_body(const body *b, const motion e[3], const motion *now, const motion *rate, vec k, double g,
                            double M[6], double f[3])
{
    for (int i = 0, n = 0; i < 3; i++) {
        const vec p = momentum(b, &e[i]), l = spin_momentum(b, &e[i]);
        const double s = b->spin * e[i].s;
        for (int j = 0; j <= i; j++)
            M[n++] += pair(p, l, s, &e[j]);
    }
    {
        const vec p = momentum(b, now), r = momentum(b, rate), c = cross(now->w, p);
        const double mg = b->m * g;
        const vec force = {r.x + c.x - mg * k.x, r.y + c.y - mg * k.y, r.z + c.z - mg * k.z};
        const double axial = b->spin * now->s;
        vec l = spin_momentum(b, now), t = spin_momentum(b, rate), turn;
        l.y += axial;
        turn = cross(now->w, l);
        t = add(add(t, turn), cross(now->v, p));
        /* the wheel's axial part turns no moment about the axle: there its own rate stands alone */
        {
            const double gx = b->x * g, gz = b->z * g; /* weight: (x, 0, z) cross k */
            t.x += gz * k.y;
            t.y -= gz * k.x - gx * k.z;
            t.z -= gx * k.y;
        }
        for (int i = 0; i < 3; i++)
            f[i] -= pair(force, t, b->spin * rate->s, &e[i]);
    }
}

int hand_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double wb = p[0], c = p[1], g = p[3], rR = p[4], mR = p[5], Rxx = p[6], Ryy = p[7];
    const double xB = p[8], zB = p[9], mB = p[10], Bxx = p[11], Bxz = p[12], Byy = p[13], Bzz = p[14];
    const double xH = p[15], zH = p[16], mH = p[17], Hxx = p[18], Hxz = p[19], Hyy = p[20], Hzz = p[21];
    const double rF = p[22], mF = p[23], Fxx = p[24], Fyy = p[25];
    const double sl = sin(p[2]), cl = cos(p[2]), ss = sl * sl, cc = cl * cl, sc = sl * cl;
    const double sr = sin(y[4]), cr = cos(y[4]), sp = sin(y[5] + p[2]), cp = cos(y[5] + p[2]);
    const double sd = sin(y[6]), cd = cos(y[6]);
    const double roll = y[9], turn = y[10], wheel = y[11];
    /* places on the tilted axes: B from the hub, S from the hub, H and the front hub from S */
    const double bx = cl * xB - sl * (zB + rR), bz = sl * xB + cl * (zB + rR);
    const double fx = cl * (wb + c) - sl * rR, fz = sl * (wb + c) + cl * rR;
    const double hx = cl * (xH - wb - c) - sl * zH, hz = sl * (xH - wb - c) + cl * zH;
    const double dx = sl * rF - cl * c, dz = -sl * c - cl * rF;
    const double Bg = cc * Bxx - 2 * sc * Bxz + ss * Bzz, Hg = cc * Hxx - 2 * sc * Hxz + ss * Hzz;
    const body rear = {
        mR + mB, mB * bx, mB * bz,
        Bg + mB * bz * bz + Rxx,
        sc * (Bxx - Bzz) + (cc - ss) * Bxz - mB * bx * bz,
        Byy + mB * (bx * bx + bz * bz),
        Bxx + Bzz - Bg + mB * bx * bx + Rxx, Ryy,
    };
    const body front = {
        mH + mF, mH * hx + mF * dx, mH * hz + mF * dz,
        Hg + mH * hz * hz + mF * dz * dz + Fxx,
        sc * (Hxx - Hzz) + (cc - ss) * Hxz - mH * hx * hz - mF * dx * dz,
        Hyy + mH * (hx * hx + hz * hz) + mF * (dx * dx + dz * dz),
        Hxx + Hzz - Hg + mH * hx * hx + mF * dx * dx + Fxx, Fyy,
    };
    /* down in G and in F, contacts from the hubs */
    const vec k = {-cr * sp, sr, cr * cp}, kf = steer(k, sd, cd);
    const double Rx = -rR * sp, Rz = rR * cp;
    const double rho = 1 / sqrt(kf.x * kf.x + kf.z * kf.z), scale = rF * rho, Fx = scale * kf.x, Fz = scale * kf.z;
    /* E1 = v_F.x Fx + v_F.z Fz and E2 = v_F.y + o.z Fx - o.x Fz: coefficients of the turn and the spin of the rear */
    const double nx = cd * Fx, ny = sd * Fx, nz = Fz, kappa = dz * Fx - dx * Fz, ax = dx + Fx, az = dz + Fz;
    const vec E1 = {ny * (Rz - fz) - sd * kappa, fz * nx - fx * nz + cd * kappa, ny * (fx - Rx)};
    const vec E2 = {cd * (Rz - fz - az), -sd * (fz + az), cd * (fx - Rx) + ax};
    const double S1 = nz * Rx - nx * Rz, S2 = sd * Rz;
    /* columns: yaw, pitch; roll, steer, wheel */
    const double A11 = dot(E1, k) + S1 * k.y, A12 = E1.y + S1, A21 = dot(E2, k) + S2 * k.y, A22 = E2.y + S2;
    const double det = 1 / (A11 * A22 - A12 * A21);
    const double r1 = E1.x * cp + E1.z * sp, r2 = E2.x * cp + E2.z * sp;
    const double yaw_of[3] = {(A12 * r2 - A22 * r1) * det, A12 * ax * det, (A12 * S2 - A22 * S1) * det};
    const double pitch_of[3] = {(A21 * r1 - A11 * r2) * det, -A11 * ax * det, (A21 * S1 - A11 * S2) * det};
    const double yaw = yaw_of[0] * roll + yaw_of[1] * turn + yaw_of[2] * wheel;
    const double pitch = pitch_of[0] * roll + pitch_of[1] * turn + pitch_of[2] * wheel;
    const double irF2 = 1 / (rF * rF), Gx = Fx * irF2, Gz = Fz * irF2;
    motion eR[3], eF[3], nR, nF, aR, aF;
    double M[6] = {0}, f[3] = {0};
    (void)t;
    for (int i = 0; i < 3; i++) {
        eR[i].w = (vec){yaw_of[i] * k.x, yaw_of[i] * k.y + pitch_of[i], yaw_of[i] * k.z};
        if (i == 0) {
            eR[i].w.x += cp;
            eR[i].w.z += sp;
        }
        eR[i].s = i == 2 ? eR[i].w.y + 1 : eR[i].w.y;
        eR[i].v = hub(eR[i].w, eR[i].s, Rx, Rz);
        eF[i].w = steer(eR[i].w, sd, cd);
        if (i == 1)
            eF[i].w.z += 1;
        eF[i].v = steer(add(eR[i].v, swing(eR[i].w, fx, fz)), sd, cd);
        eF[i].s = (eF[i].v.z - eF[i].w.y * dx) * Gx - (eF[i].v.x + eF[i].w.y * dz) * Gz;
    }
    /* the motion itself */
    nR.w = (vec){yaw * k.x + cp * roll, yaw * k.y + pitch, yaw * k.z + sp * roll};
    nR.s = nR.w.y + wheel;
    nR.v = hub(nR.w, nR.s, Rx, Rz);
    nF.w = steer(nR.w, sd, cd);
    nF.v = steer(add(nR.v, swing(nR.w, fx, fz)), sd, cd);
    nF.w.z += turn;
    {
        /* rates of the components while roll', steer', thR' stand still: first with yaw' and pitch' standing too */
        const double dRx = -Rz * pitch, dRz = Rx * pitch;
        const vec dk = {sr * sp * roll - cr * cp * pitch, cr * roll, -sr * cp * roll - cr * sp * pitch};
        const vec dkf = add(steer(dk, sd, cd), (vec){turn * kf.y, -turn * kf.x, 0});
        const double drho = (kf.x * dkf.x + kf.z * dkf.z) * rho * rho;
        const double dFx = scale * dkf.x - Fx * drho, dFz = scale * dkf.z - Fz * drho;
        const vec rest = hub(nR.w, nR.s, dRx, dRz);
        const double vx = nF.v.x + nF.w.y * dz, vz = nF.v.z - nF.w.y * dx; /* of the front hub */
        vec dw = {dk.x * yaw - sp * pitch * roll, dk.y * yaw, dk.z * yaw + cp * pitch * roll};
        const double e1 = dot(E1, dw) + S1 * dw.y + nx * rest.x + ny * rest.y + nz * rest.z
                          + turn * (nF.v.y * Fx - nF.w.x * kappa) + vx * dFx + vz * dFz;
        const double e2 = dot(E2, dw) + S2 * dw.y + cd * rest.y - sd * rest.x - turn * (nF.v.x + nF.w.y * az)
                          + nF.w.z * dFx - nF.w.x * dFz;
        const double yaw2 = (A12 * e2 - A22 * e1) * det, pitch2 = (A21 * e1 - A11 * e2) * det;
        dw = (vec){dw.x + k.x * yaw2, dw.y + k.y * yaw2 + pitch2, dw.z + k.z * yaw2};
        nF.s = vz * Gx - vx * Gz;
        aR.w = dw;
        aR.s = dw.y;
        aR.v = add(hub(dw, dw.y, Rx, Rz), rest);
        aF.w = add(steer(dw, sd, cd), (vec){turn * nF.w.y, -turn * nF.w.x, 0});
        aF.v = add(steer(add(aR.v, swing(dw, fx, fz)), sd, cd), (vec){turn * nF.v.y, -turn * nF.v.x, 0});
        aF.s = (aF.v.z - aF.w.y * dx) * Gx - (aF.v.x + aF.w.y * dz) * Gz + (vz * dFx - vx * dFz) * irF2;
    }
    add_body(&rear, eR, &nR, &aR, k, g, M, f);
    add_body(&front, eF, &nF, &aF, kf, g, M, f);
    {
        /* LDL^T of the symmetric 3 x 3 system */
        const double i0 = 1 / M[0], l1 = M[1] * i0, l3 = M[3] * i0;
        const double i1 = 1 / (M[2] - M[1] * l1), m4 = M[4] - M[3] * l1, l4 = m4 * i1;
        const double b1 = f[1] - l1 * f[0], b2 = f[2] - l3 * f[0] - l4 * b1;
        const double u2 = b2 / (M[5] - M[3] * l3 - m4 * l4), u1 = b1 * i1 - l4 * u2;
        const double sy = sin(y[3]), cy = cos(y[3]);
        /* the hub's velocity in space: back through pitch, roll and yaw */
        const double a = cp * nR.v.x + sp * nR.v.z, b = cp * nR.v.z - sp * nR.v.x, h = cr * nR.v.y - sr * b;
        dydt[0] = cy * a - sy * h;
        dydt[1] = sy * a + cy * h;
        dydt[2] = sr * nR.v.y + cr * b;
        dydt[3] = yaw;
        dydt[4] = roll;
        dydt[5] = pitch;
        dydt[6] = turn;
        dydt[7] = wheel;
        dydt[8] = nF.s - nF.w.y;
        dydt[9] = f[0] * i0 - l1 * u1 - l3 * u2;
        dydt[10] = u1;
        dydt[11] = u2;
    }
    return 0;
}

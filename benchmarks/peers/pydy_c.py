"""PyDy's C for a system: mass matrix and forcing from its CMatrixGenerator, and an LU solve in C.

PyDy itself hands the solve to numpy or SciPy, call by call; a plain LU loop with pivoting in C spares it that.
"""

from __future__ import annotations

from benchmarks.models import Sources
from benchmarks.peers.kane import derive
from benchmarks.systems import split_name

_WRAPPER = """\
#include <math.h>
{prototype}
#define NQ {coordinates}
#define NU {speeds}
int pydy_rhs(double t, const double *y, const double *p, double *dydt)
{{
    double A[NU * NU], b[NU];
    (void)t;
    evaluate((double *)y, (double *)y + NQ, (double *)p, dydt, A, b);
    for (int k = 0; k < NU; k++) {{
        int best = k;
        for (int i = k + 1; i < NU; i++)
            if (fabs(A[i * NU + k]) > fabs(A[best * NU + k]))
                best = i;
        if (best != k) {{
            for (int j = k; j < NU; j++) {{
                const double swap = A[k * NU + j];
                A[k * NU + j] = A[best * NU + j];
                A[best * NU + j] = swap;
            }}
            const double swap = b[k];
            b[k] = b[best];
            b[best] = swap;
        }}
        for (int i = k + 1; i < NU; i++) {{
            const double factor = A[i * NU + k] / A[k * NU + k];
            for (int j = k + 1; j < NU; j++)
                A[i * NU + j] -= factor * A[k * NU + j];
            b[i] -= factor * b[k];
        }}
    }}
    for (int i = NU - 1; i >= 0; i--) {{
        for (int j = i + 1; j < NU; j++)
            b[i] -= A[i * NU + j] * b[j];
        b[i] /= A[i * NU + i];
        dydt[NQ + i] = b[i];
    }}
    return 0;
}}
"""


def pydy_sources(name: str) -> tuple[Sources, int, int]:
    """The C files, the number of coordinates and of speeds (dependent ones included)."""
    from pydy.codegen.c_code import CMatrixGenerator

    made = derive(name)
    arguments = [made.coordinates, made.speeds, made.parameters]
    generator = CMatrixGenerator(arguments, [made.rates, made.mass_matrix, made.forcing])
    header, source = generator.doprint()
    wrapper = _WRAPPER.format(prototype=header, coordinates=len(made.coordinates), speeds=len(made.speeds))
    family, _ = split_name(name)
    files = {f"pydy_{family}.c": source, f"pydy_{family}_rhs.c": wrapper}
    return Sources("pydy_rhs", files), len(made.coordinates), len(made.speeds)

"""Which names C does not leave to a spec."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.names import Scope, list_bound_names
from nhc.program.ir import Argument, Program, Statement

LONGEST = 63  # C99 5.2.4.1: significant characters of an internal identifier

KEYWORDS = """
alignas alignof auto bool break case char const constexpr continue default do double else enum extern false
float for goto if inline int long nullptr register restrict return short signed sizeof static static_assert
struct switch thread_local true typedef typeof typeof_unqual union unsigned void volatile while asm fortran
_Alignas _Alignof _Atomic _BitInt _Bool _Complex _Decimal128 _Decimal32 _Decimal64 _Generic _Imaginary
_Noreturn _Static_assert _Thread_local
"""

# functions and macros of <math.h>, <float.h>, <stddef.h>; `linux`, `unix` and the like are macros of GNU dialects
LIBRARY = """
acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh drem erf erfc exp exp10 exp2 expm1 fabs
fdim finite floor fma fmax fmin fmod fpclassify frexp gamma hypot ilogb isfinite isgreater isgreaterequal
isinf isless islessequal islessgreater isnan isnormal isunordered j0 j1 jn ldexp lgamma llrint llround log
log10 log1p log2 logb lrint lround modf nan nearbyint nextafter nexttoward pow pow10 remainder remquo rint
round scalb scalbln scalbn signbit signgam significand sin sincos sinh sqrt tan tanh tgamma trunc y0 y1 yn abs
div labs DOMAIN HUGE_VAL HUGE_VALF HUGE_VALL INFINITY MAXFLOAT NAN OVERFLOW PLOSS SING TLOSS UNDERFLOW X_TLOSS
NULL EDOM ERANGE EILSEQ double_t float_t size_t ptrdiff_t wchar_t offsetof max_align_t errno math_errhandling
matherr main i386 linux unix
"""

# what a standard header may define, now or in a later edition of C
PREFIXES = ("M_", "FP_", "FLT_", "DBL_", "LDBL_", "DECIMAL_", "MATH_", "SNAN", "__")

RESERVED = frozenset((KEYWORDS + LIBRARY).split())


def print_singular(prefix: str, code: int) -> str:
    """The enumerator of a singular block."""
    return f"{prefix.upper()}_SINGULAR_{code}"


def make_scope(
    program: Program, arguments: Iterable[Argument], body: Iterable[Statement], own: tuple[str, ...]
) -> Scope:
    """The names of one function: its arguments and ``own`` are taken, and so is everything that the file declares."""
    bound = list_bound_names(body)
    prefixes = (*PREFIXES, program.system + "_", program.system.upper() + "_")
    taken = {name for name in bound if name.startswith(prefixes)}
    scope = Scope(RESERVED | taken | {argument.name for argument in arguments} | set(own), LONGEST)
    scope.bind_all(bound)
    return scope

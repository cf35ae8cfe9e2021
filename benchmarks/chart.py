"""The log-log chart of derivation time against size, as SVG without a library."""

from __future__ import annotations

import math
from collections.abc import Callable

Place = Callable[[float, float], tuple[float, float]]
_WIDTH, _HEIGHT, _LEFT, _BOTTOM, _TOP, _RIGHT = 640, 400, 90, 50, 20, 120
_LINE = 15  # between names, in the units of the drawing
_ABOUT = "Time of a derivation over the number of trailers or links, both logarithmic, beside a line of linear growth"
_STYLES = ("#1b6ca8", "#c8553d")


def draw_scaling(times: dict[str, dict[int, float]]) -> str:
    """Seconds by size for each family, with a line of slope 1 through the first family's first point."""
    sizes = sorted({n for found in times.values() for n in found})
    values = [seconds * 1e3 for found in times.values() for seconds in found.values()]
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    left, right = math.log10(sizes[0]), math.log10(sizes[-1])

    def place(n: float, milliseconds: float) -> tuple[float, float]:
        x = _LEFT + (math.log10(n) - left) / (right - left) * (_WIDTH - _LEFT - _RIGHT)
        y = _HEIGHT - _BOTTOM - (math.log10(milliseconds) - low) / (high - low) * (_HEIGHT - _BOTTOM - _TOP)
        return round(x, 1), round(y, 1)

    size = f'viewBox="0 0 {_WIDTH} {_HEIGHT}" width="{_WIDTH}" height="{_HEIGHT}"'
    look = f'role="img" aria-label="{_ABOUT}" font-family="sans-serif" font-size="13"'
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} {look}>'
    lines = [head, f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="#ffffff"/>']
    middle = (_HEIGHT - _BOTTOM + _TOP) / 2
    lines.append(
        f'<text x="16" y="{middle}" text-anchor="middle" transform="rotate(-90 16 {middle})">time of a derivation</text>'
    )
    for power in range(low, high + 1):
        x, y = place(sizes[0], 10.0**power)
        lines.append(f'<line x1="{x}" y1="{y}" x2="{_WIDTH - _RIGHT}" y2="{y}" stroke="#dddddd"/>')
        lines.append(f'<text x="{x - 8}" y="{y + 4}" text-anchor="end">{10.0**power:g} ms</text>')
    for n in sizes:
        x, y = place(n, 10.0**low)
        lines.append(f'<text x="{x}" y="{y + 20}" text-anchor="middle">{n}</text>')
    x, y = place(math.sqrt(sizes[0] * sizes[-1]), 10.0**low)
    lines.append(f'<text x="{x}" y="{y + 40}" text-anchor="middle">number of trailers or links</text>')
    dashed, end = _draw_linear(place, sizes, next(iter(times.values())), high)
    lines.append(dashed)
    names = [(*end, "linear", "#888888")]
    for (family, found), colour in zip(times.items(), _STYLES, strict=False):
        points = [place(n, seconds * 1e3) for n, seconds in sorted(found.items())]
        path = " ".join(f"{x},{y}" for x, y in points)
        lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        lines += [f'<circle cx="{x}" cy="{y}" r="3.5" fill="{colour}"/>' for x, y in points]
        names.append((*points[-1], family, colour))
    lines += _draw_names(names)
    return "\n".join([*lines, "</svg>"]) + "\n"


def _draw_names(ends: list[tuple[float, float, str, str]]) -> list[str]:
    """Each line's name beside its end, and below the name before it where they would meet."""
    found, before = list[str](), -math.inf
    for x, y, name, colour in sorted(ends, key=lambda end: end[1]):
        before = round(max(y + 4, before + _LINE), 1)
        found.append(f'<text x="{x + 10}" y="{before}" fill="{colour}">{name}</text>')
    return found


def _draw_linear(place: Place, sizes: list[int], found: dict[int, float], high: int) -> tuple[str, tuple[float, float]]:
    """The dashed line of linear cost, as far as it stays in the frame, and its end."""
    first = found[sizes[0]] * 1e3
    last = min(sizes[-1], sizes[0] * 10.0**high / first)
    (x1, y1), (x2, y2) = place(sizes[0], first), place(last, first * last / sizes[0])
    return f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="#888888" stroke-dasharray="5 4"/>', (x2, y2)

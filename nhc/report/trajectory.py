"""A trajectory as CSV, NPZ, SVG or HTML."""

from __future__ import annotations

import io
import struct
import zipfile
from collections.abc import Sequence

from nhc.simulate.ensemble import Ensemble
from nhc.simulate.run import Trajectory


def csv_text(found: Trajectory) -> str:
    """A header, then one row for each time; decimals that read back as the same doubles."""
    lines = [",".join(("t", *found.headings))]
    for t, row in zip(found.times, found.rows, strict=True):
        lines.append(",".join(map(repr, (t, *row))))
    return "\n".join(lines) + "\n"


def ensemble_text(found: Ensemble) -> str:
    """``start,t,<names>``: the rows of each start that came to its end, starts counted from 1.

    Where a name of the spec is ``start``, the first column is ``start_``: each has a name of its own.
    """
    headings = tuple(column.heading for column in found.job.columns)
    count = "start"
    while count in headings:
        count += "_"
    lines = [",".join((count, "t", *headings))]
    for number, member in enumerate(found.members, 1):
        if member.ended == "done":
            rows = zip(member.times, member.rows, strict=True)
            lines += [",".join((str(number), *map(repr, (t, *row)))) for t, row in rows]
    return "\n".join(lines) + "\n"


def npz_bytes(found: Trajectory) -> bytes:
    """A NumPy archive: ``t`` and one array for each column, without NumPy and the same bytes each time."""
    columns = {"t": found.times}
    columns.update((name, tuple(row[k] for row in found.rows)) for k, name in enumerate(found.headings))
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, values in columns.items():
            archive.writestr(zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0)), _npy(values))
    return buffer.getvalue()


def _npy(values: Sequence[float]) -> bytes:
    """NumPy's own format, version 1.0."""
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({len(values)},), }}"
    header += " " * (-(len(header) + 11) % 64) + "\n"
    return (
        b"\x93NUMPY\x01\x00"
        + struct.pack("<H", len(header))
        + header.encode()
        + struct.pack(f"<{len(values)}d", *values)
    )


def make_file(found: Trajectory, suffix: str) -> bytes:
    """The content of a file of that kind."""
    if suffix == ".csv":
        return csv_text(found).encode()
    if suffix == ".npz":
        return npz_bytes(found)
    from nhc.report.page import make_page, make_picture

    return (make_picture(found) if suffix == ".svg" else make_page(found)).encode()

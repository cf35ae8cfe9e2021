"""What the driver's ``main`` is told: the scenes and where each quantity that they need comes from."""

from __future__ import annotations

from nhc.emit.c.literals import print_comment, print_float, print_string
from nhc.emit.options import EmitError
from nhc.emit.statements import Status, list_statuses
from nhc.language.spec import reaction_name
from nhc.program.ir import Program, SceneData
from nhc.program.runs.limits import LIMITS
from nhc.records import record
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

POINTS = 201  # rows unless the user asks for another number
SOURCES = {  # the function that a kind of column comes from
    "STATE": "",
    "VELOCITY": "velocities",
    "OUTPUT": "outputs",
    "REACTION": "reactions",
    "ENERGY": "energy",
    "NEEDED": "",  # of the driver itself
}


@record
class Method:
    """What the templates that runs and drivers share call the driver's method."""

    name: str = "dop853"


@record
class Column:
    """One column of the CSV: its heading, its kind and its place in the array of that kind."""

    heading: str
    kind: str
    index: int


@record
class Scene:
    """A scene as C literals; ``first`` and ``count`` select its columns, the last two its stops."""

    name: str
    y: str
    p: str
    start: str
    end: str
    tolerance: str
    first: int
    count: int
    first_stop: int
    stop_count: int


def find_columns(program: Program, need: str) -> tuple[Column, ...]:
    """The columns that a needed name stands for: one, or one for each constraint (`reactions`)."""
    for index, quantity in enumerate(program.state):
        if quantity.name == need:
            return (Column(need, "STATE", index),)
    for index, quantity in enumerate(program.outputs):
        if quantity.name == need:
            return (Column(need, "OUTPUT", index),)
    for index, quantity in enumerate(program.coordinates):
        if need == f"{quantity.name}'":
            return (Column(need, "VELOCITY", index),)
    if program.driving.needed is not None and need in program.driving.needed.names:
        return (Column(need, "NEEDED", program.driving.needed.names.index(need)),)
    if need == "energy":
        return (Column(need, "ENERGY", 0),)
    reactions = tuple(Column(reaction_name(q.name), "REACTION", i) for i, q in enumerate(program.constraints))
    if need == "reactions":
        return reactions
    single = tuple(column for column in reactions if column.heading == need)
    if single:
        return single
    message = f"the driver cannot compute `{need}`: the {program.formulation} equations do not keep it"
    raise EmitError(message, "leave it out of the scene's `need:`, or choose another formulation")


def list_columns(program: Program, scene: SceneData) -> tuple[Column, ...]:
    """The columns of a scene, after the time."""
    needs = scene.need or tuple(quantity.name for quantity in program.coordinates)
    return tuple(column for need in needs for column in find_columns(program, need))


def print_doubles(values: tuple[float, ...]) -> str:
    """An initialiser; C99 has no empty one."""
    return "{" + ", ".join(print_float(value) for value in values or (0.0,)) + "}"


def make_driver(program: Program, scene_name: str) -> dict[str, object]:
    """The context of ``model_main.c.jinja``.  Raises EmitError without a scene, or for a need that nothing computes."""
    chosen = tuple(scene for scene in program.scenes if scene_name in ("", scene.name))
    if not chosen:
        raise EmitError("a driver integrates a scene, and this program has none", "write one under `scenes:`")
    columns: list[Column] = []
    scenes: list[Scene] = []
    stops: list[str] = []
    for scene in chosen:
        own = list_columns(program, scene)
        start, end = (print_float(time) for time in scene.time)
        tolerance, name = print_float(scene.tolerance), print_string(scene.name)
        y, p = print_doubles(scene.y), print_doubles(scene.p)
        scenes.append(Scene(name, y, p, start, end, tolerance, len(columns), len(own), len(stops), len(scene.stops)))
        columns += own
        stops += map(print_doubles, scene.stops)
    kinds = {column.kind for column in columns}
    used = tuple(kind for kind in SOURCES if kind in kinds)
    check_functions(program, used)
    return {
        "name": program.system,
        "capitals": program.system.upper(),
        "head": f"{program.system}_main.c: integrates {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})",
        "scenes": tuple(scenes),
        "columns": tuple(Column(print_string(c.heading), c.kind, c.index) for c in columns)
        or (Column('""', "STATE", 0),),
        "stops": tuple(stops),
        "kinds": tuple(kind for kind in SOURCES if kind != "NEEDED" or kind in kinds),
        "used": used,
        "parameters": max(len(program.parameters), 1),
        "statuses": tuple(Status(s.code, print_string(print_comment(s.what))) for s in list_statuses(program)),
        "points": POINTS,
        "limits": LIMITS,
        "adaptive": True,
        "allowed": True,
        "counted": False,
    }


def check_functions(program: Program, kinds: tuple[str, ...]) -> None:
    """Raise EmitError unless the program has the functions that the columns come from."""
    present = {function.name for function in program.functions}
    for needed in ("rhs", *(SOURCES[kind] for kind in kinds)):
        if needed and needed not in present:
            message = f"the driver needs the function `{needed}`, which this program does not have"
            raise EmitError(message, "leave `--only` out")


def list_driver_functions(driver: dict[str, object]) -> tuple[str, ...]:
    """The functions that the driver calls."""
    used = driver["used"]
    assert isinstance(used, tuple)
    return ("rhs", *(SOURCES[kind] for kind in used if SOURCES[kind]))

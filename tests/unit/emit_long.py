"""A long program made by hand: bodies that C gets in parts, a Jacobian in sweeps, a function that calls another."""

from __future__ import annotations

from nhc.program.ir import Evaluate, Function, Guard, Let, Load, Program, Statement, Store, Sweep
from tests.unit.emit_cases import E, call, function, let, loads, quantities, ref, store

LINKS = 150
"""Lets of the chain."""

STATE = ("x", "v", "z")
SIZES = (3, 1)
BOUND = 1e-9  # the guard in the last part holds |c_149| against it


def _chain() -> tuple[Statement, ...]:
    """c_k = (c_{k-1} + k/7) cos-like mixing of the state; each depends on the two before it and on one far back."""
    links: list[Statement] = [
        let("a", ref("k") * 0.5),
        let("s", call("sin", ref("x"))),
        let("c_0", ref("s") * ref("a")),
    ]
    for k in range(1, LINKS):
        links.append(let(f"c_{k}", _next(k)))
    links.append(Guard(ref(f"c_{LINKS - 1}").node, E(ref("a").node).node, BOUND, 1, "the chain has come to rest"))
    return tuple(links)


def _next(k: int) -> E:
    far = f"c_{k // 3}"
    return (ref(f"c_{k - 1}") * 0.75 + ref("v") * ref(far) * 0.125) - ref("z") * 0.0625


def _slopes(weights: dict[str, str]) -> tuple[Let | Store, ...]:
    """The chain's derivative along the direction whose components have these names."""
    d: dict[str, E] = {"c_0": ref("cosine") * ref("a") * ref(weights["x"])}
    lets: list[Let | Store] = [let("d_0", d["c_0"])]
    for k in range(1, LINKS):
        far = k // 3
        value = ref(f"d_{k - 1}") * 0.75 + ref("v") * ref(f"d_{far}") * 0.125
        value = value + ref(f"c_{far}") * 0.125 * ref(weights["v"]) - ref(weights["z"]) * 0.0625
        lets.append(let(f"d_{k}", value))
    lets.append(store("J", 3, ref(f"d_{LINKS - 1}") - ref(weights["v"])))
    lets.append(store("J", 6, ref("d_40") * ref("k")))
    return tuple(lets)


def make_long() -> Program:
    """x' = v, v' = c_149 - v, z' = k c_40."""
    read = (*loads("y", *STATE), *loads("p", "k"))
    chain, last = _chain(), ref(f"c_{LINKS - 1}")
    rhs = function(
        "rhs",
        (
            *read,
            *chain,
            store("dydt", 0, ref("v")),
            store("dydt", 1, last - ref("v")),
            store("dydt", 2, ref("c_40") * ref("k")),
        ),
        SIZES,
        ("dydt", 3),
    )
    rates = tuple(Load(f"rate_{name}", "dydt", k) for k, name in enumerate(STATE))
    calls: tuple[Statement, ...] = (Evaluate("rhs", "dydt", 3), *loads("y", "x"), *rates)
    after: list[Statement] = [let("b_0", ref("rate_v") * ref("x") + ref("rate_z"))]
    after += [let(f"b_{k}", ref(f"b_{k - 1}") * 0.5 + ref(f"b_{k // 2}") + ref("rate_x")) for k in range(1, LINKS)]
    end = store("qddot", 0, ref(f"b_{LINKS - 1}"))
    accelerations = function("accelerations", (*calls, *after, end), SIZES, ("qddot", 1))
    seeds = {"x": "e_x", "v": "e_v", "z": "e_z"}
    sweep = Sweep("one direction in each pass", tuple(seeds.values()), (0, 1, 2), _slopes(seeds))
    jacobian = function(
        "jacobian", (*read, *chain, let("cosine", call("cos", ref("x"))), store("J", 1, 1.0), sweep), SIZES, ("J", 9)
    )
    short = function("velocities", (*loads("y", "x", "v"), store("qdot", 0, ref("v"))), SIZES, ("qdot", 1))
    functions: tuple[Function, ...] = (rhs, short, accelerations, jacobian)
    return Program(
        "long_chain", "", "newton", "", "", quantities("x"), quantities(*STATE), quantities("k"), (),
        (), functions,
    )  # fmt: skip

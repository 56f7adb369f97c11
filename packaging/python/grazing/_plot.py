"""Plots of results with matplotlib."""

from __future__ import annotations

from itertools import groupby
from typing import Any

from . import _grazing


def _named(of: Any, name: str) -> Any:
    """The table with a name; tables of the paper's figures have a prefix."""
    return next((of[table] for table in of if table == name or table.endswith(f"_{name}") and table.startswith("fig")), None)


def _pieces(table: Any, by: list[str], columns: list[str]) -> Any:
    """Consecutive rows with the same values in some columns: these values, and lists of other columns."""
    rows = zip(zip(*(table[name] for name in by)), zip(*(table[name] for name in columns)))
    for key, group in groupby(rows, key=lambda row: row[0]):
        yield key, [list(column) for column in zip(*(row[1] for row in group))]


def _colour(rgb: Any) -> tuple[float, ...]:
    return tuple(part / 255 for part in rgb)


def _round(ring: list[Any], hole: bool) -> list[Any]:
    """The ring in anticlockwise order, or clockwise for a hole."""
    area = sum(x * b - a * y for (x, y), (a, b) in zip(ring, ring[1:] + ring[:1]))
    return ring if (area > 0) != hole else ring[::-1]


def plot(of: Any, ax: Any) -> Any:
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.gca()
    for name, draw in (("curves", _plane), ("branches", _line), ("diagram_branches", _line), ("place_motion", _portrait), ("simulated_motion", _portrait)):
        table = _named(of, name)
        if table is not None:
            draw(of, table, ax)
            return ax
    raise ValueError(f"there is nothing to plot in the tables {', '.join(of)}")


def _plane(of: Any, curves: Any, ax: Any) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    looks, inks = _grazing.looks()
    across, up = of.names
    regions, points = _named(of, "regions"), _named(of, "points")
    for (_, kind), group in groupby(_pieces(regions, ["region", "kind", "ring"], [across, up]) if regions else [], key=lambda piece: piece[0][:2]):
        # The first ring is the outer boundary; the others bound holes, which matplotlib omits if their direction is opposite.
        rings = [_round(list(zip(*columns)), hole=number > 0) for number, (_, columns) in enumerate(group)]
        path = Path.make_compound_path(*(Path(ring + ring[:1], closed=True) for ring in rings))
        colour, opacity = inks[kind]
        ax.add_patch(PathPatch(path, facecolor=_colour(colour), alpha=opacity, linewidth=0, zorder=0))
    seen = set()
    for (kind, *_), columns in _pieces(curves, ["kind", "p", "n", "arc"], [across, up]):
        meaning, colour, width, _ = looks[kind]
        ax.plot(*columns, color=_colour(colour), linewidth=width, label=None if kind in seen else f"{kind}: {meaning}", zorder=1)
        seen.add(kind)
    if points:
        for kind, marker in (("resonance", "^"), ("other", "o")):
            shown = [(x, y) for x, y, k in zip(points[across], points[up], points["kind"]) if (k == "resonance") == (kind == "resonance")]
            if shown:
                ax.plot(*zip(*shown), marker, color="black", markersize=4, linestyle="none", zorder=2)
    ax.margins(0)
    ax.set_xlabel(across)
    ax.set_ylabel(up)


def _line(of: Any, branches: Any, ax: Any) -> None:
    # The fixed parameter has one value, but for rounding.
    across = max(of.names, key=lambda name: len(set(branches[name])))
    for (*_, stable, admissible), columns in _pieces(branches, ["p", "branch", "loop", "stable", "admissible"], [across, "x"]):
        if admissible:
            ax.plot(*columns, color="black", linewidth={True: 1.6, "neutral": 1.0}.get(stable, 0.5))
    dots = next((of[table] for table in of if table.endswith("attractor")), None)
    if dots:
        ax.plot(dots[across], dots["x"], ",", color="tab:blue", zorder=0)
    ax.set_xlabel(across)
    ax.set_ylabel("x")


def _portrait(of: Any, motion: Any, ax: Any) -> None:
    by = ["attractor", "flight"] if "attractor" in motion else ["flight"]
    for key, columns in _pieces(motion, by, ["x", "y"]):
        ax.plot(*columns, linewidth=0.8, color=f"C{(key[0] - 1) % 10}" if len(by) > 1 else "C0")
    ax.axvline(0, color="black", linewidth=2)
    ax.set_xlabel("x")
    ax.set_ylabel("v")

"""Resonant grazing bifurcations of impact oscillators.

An oscillator moves as x'' = F(x, v, t) with v = x'. At its wall, x = 0 by default, velocity and phase z = omega*t
of an impact change as y -> -Phi(y, z)*y, z -> z + Psi(y, z)*y. Its motion is forced with frequency omega and depends on two
parameters: the primary one, mu, brings it to the wall, and the secondary one, eta, is varied along the curve of grazing
bifurcations. A maximal periodic solution (MPS) with p loops hits the wall once in p forcing periods.

>>> import grazing
>>> diagram = grazing.Oscillator.paper(zeta=0.02, epsilon=0.9).diagram(primary=(0, 1.2), secondary=(0.3, 1.1))
>>> curves = diagram["curves"].to_polars()      # or .to_pandas(), pyarrow.table(...), polars.DataFrame(...)
>>> diagram.plot(matplotlib.pyplot.gca())       # a notebook displays the diagram by itself

All results are bit for bit those of the command line `grazing`, and errors have its wording.
"""

from __future__ import annotations

import contextlib
import json
import os
import warnings
from typing import Any, Callable, Iterator, Mapping, Sequence, Union

from . import _grazing, _plot
from ._grazing import Table
from ._trace import expression

__all__ = ["Figure", "Oscillator", "Results", "Table", "outputs", "reproduce"]

Range = tuple[float, float]
#: Text, a number, or a function to trace: see :class:`Oscillator`.
Expression = Union[str, float, Callable[..., Any]]
#: Called as progress(what, done, all) while a computation runs; True shows tqdm progress bars.
Progress = Union[Callable[[str, int, int], None], bool, None]


class Figure(str):
    """A figure as SVG, displayed by notebooks."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the SVG to a file."""
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self)


class Results(Mapping[str, Table]):
    """Tables by name (``results["curves"]`` or ``results.curves``) and figures (``results.figures``).

    ``print(results)`` prints what the command line does. ``results.missing`` lists what was not found or not finished, or
    contradicts the theorems; each entry is also issued as a warning.
    """

    def __init__(self, found: _grazing.Results) -> None:
        self._tables = {table.name: table for table in found.tables}
        #: Names of the primary and secondary parameter, and of their columns.
        self.names: tuple[str, str] = tuple(found.names)  # type: ignore[assignment]
        self.listing: str = found.listing
        self.missing: list[str] = list(found.missing)
        self.figures: dict[str, Figure] = {name: Figure(svg) for name, svg in found.figures}
        if self.missing:
            warnings.warn("; ".join(self.missing), RuntimeWarning, stacklevel=3)

    def __getitem__(self, name: str) -> Table:
        if name not in self._tables:
            raise KeyError(f"{name}: the tables are {', '.join(self._tables)}")
        return self._tables[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)

    def __getattr__(self, name: str) -> Table:
        if name.startswith("_") or name not in self._tables:
            raise AttributeError(name)
        return self._tables[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._tables]

    def __repr__(self) -> str:
        return f"<grazing.Results: tables {', '.join(self._tables)}; figures {', '.join(self.figures) or 'none'}>"

    def __str__(self) -> str:
        return self.listing or repr(self)

    def _repr_svg_(self) -> str | None:
        wanted = self.figures.get("diagram") or next(iter(self.figures.values()), None)
        return None if wanted is None else str(wanted)

    def plot(self, ax: Any = None) -> Any:
        """Draws the diagram, one-parameter diagram or motion into matplotlib axes, and returns these.

        Curves are coloured by kind; grey: an MPS is stable; triangles: resonances. The axes are in
        the oscillator's units.
        """
        return _plot.plot(self, ax)


class Oscillator:
    """An impact oscillator: expressions, constants, ranges of the two parameters, numbers of loops p.

    >>> Oscillator(force="-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)", frequency="omega", restitution="0.9",
    ...            primary=("A", 0, 1.5), secondary=("omega", 0.4, 1.1), loops=(1, 2, 3), zeta=0.02, kappa=0.1)

    force        F(x, v, t), acceleration: x'' = F
    frequency    omega, the forcing frequency in radians per time
    restitution  Phi(y, z) > 0: after an impact with velocity y at phase z the velocity is -Phi*y
    duration     Psi(y, z), in radians per velocity: z -> z + Psi*y
    wall, side   position of the wall, which may depend on t, and whether motion is "below" or "above" it
    mass         mass that hits the wall, for impulses, forces and power

    Each is text, a number, or a function whose arguments have the names that the text would use. A function is called once, with
    symbols, to obtain the text. It may use numpy functions (numpy.sin, not math.sin); what has no text form raises TypeError.
    """

    def __init__(
        self,
        force: Expression,
        *,
        frequency: Expression,
        restitution: Expression,
        primary: tuple[str, float, float],
        secondary: tuple[str, float, float],
        loops: Sequence[int],
        duration: Expression = "0",
        wall: Expression = "0",
        side: str = "below",
        mass: Expression | None = None,
        name: str = "Oscillator",
        **constants: float,
    ) -> None:
        def written(table: str, **values: Expression) -> list[str]:
            return [f"[{table}]"] + [f"{key} = {json.dumps(expression(value, key), ensure_ascii=False)}" for key, value in values.items()]

        def axis(table: str, of: tuple[str, float, float]) -> list[str]:
            return [f"[{table}]", f"name = {json.dumps(of[0])}", f"range = [{float(of[1])!r}, {float(of[2])!r}]"]

        lines = [f"name = {json.dumps(name, ensure_ascii=False)}", "[parameters]"]
        lines += [f"{key} = {float(value)!r}" for key, value in constants.items()]
        lines += axis("primary", primary) + axis("secondary", secondary)
        lines += written("motion", force=force, frequency=frequency)
        lines += written("wall", position=wall) + [f"side = {json.dumps(side)}"]
        lines += written("impact", restitution=restitution, duration=duration, **({} if mass is None else {"mass": mass}))
        lines += ["[analysis]", f"loops = {[int(p) for p in loops]}"]
        self._set("\n".join(lines) + "\n", "oscillator.toml", {})

    @classmethod
    def from_toml(cls, source: str | os.PathLike[str], **constants: float) -> Oscillator:
        """The oscillator from a text file, or from such a text, with other values for constants."""
        text = source if isinstance(source, str) and ("=" in source or "\n" in source) else None
        if text is not None:
            return cls.__new__(cls)._set(text, "oscillator.toml", constants)
        return cls.__new__(cls)._set(_grazing.read(os.fspath(source)), os.fspath(source), constants)

    @classmethod
    def paper(cls, zeta: float, epsilon: float) -> Oscillator:
        """The paper's oscillator, x'' = -2*zeta*x' - x - 1 + amplitude*cos(omega*t), whose motion is known in closed form.

        zeta: damping ratio, 0 < zeta < 1. epsilon: coefficient of restitution, epsilon > 0. Everything is dimensionless.
        """
        return cls.__new__(cls)._set(None, "the paper's oscillator", {"zeta": zeta, "epsilon": epsilon})

    def _set(self, text: str | None, file: str, constants: Mapping[str, float]) -> Oscillator:
        self._text, self._file = text, file
        self._constants = {name: float(value) for name, value in constants.items()}
        self._listing, self._axes = self._model(None).checked()
        return self

    def _model(self, loops: Sequence[int] | None) -> _grazing.Model:
        return _grazing.Model(self._text, self._file, self._constants, None if loops is None else list(loops))

    @property
    def text(self) -> str | None:
        """The text of its file; None for the paper's oscillator."""
        return self._text

    def __repr__(self) -> str:
        return self._listing

    def diagram(
        self,
        *,
        primary: Range | None = None,
        secondary: Range | None = None,
        loops: Sequence[int] | None = None,
        progress: Progress = None,
    ) -> Results:
        """The two-parameter diagram in these ranges, with everything that ``grazing unfold`` computes.

        Tables, among others: ``curves`` of bifurcations (SN, PD, GZ, NS, PF; graz: of the non-impacting solution), ``points``,
        ``regions`` where an MPS is stable, ``coefficients`` (mu = mu_graz(eta) + c_SN*(eta - eta*)^2 + ...), ``hypotheses`` of
        Theorems 2.4 and 2.5 at all resonances, ``grazing`` and ``magnifications``.
        """
        view = None
        if primary is not None or secondary is not None:
            view = [[float(end) for end in given or own] for given, (_, own) in zip((primary, secondary), self._axes)]
        with _heard(progress) as heard:
            return Results(self._model(loops).diagram(view, heard))

    def resonances(self, *, loops: Sequence[int] | None = None, progress: Progress = None) -> Table:
        """The resonances at which Theorem 2.4 (p = 1) or 2.5 holds, with c_SN and c_PD by the theorem and as measured.

        This is the table ``coefficients`` of :meth:`diagram`; hypotheses that fail elsewhere are in its table ``hypotheses``.
        """
        return self.diagram(loops=loops, progress=progress)["coefficients"]

    def cut(
        self,
        *,
        primary: float | None = None,
        secondary: float | None = None,
        range: Range | None = None,
        ordinate: str = "x",
        loops: Sequence[int] | None = None,
        progress: Progress = None,
    ) -> Results:
        """The one-parameter diagram with one parameter fixed and the other in a range.

        ordinate: "x" (on the Poincare section), "impact velocity", "peak to peak"; "impulse", "mean force" or "power" with a mass.
        """
        if (primary is None) == (secondary is None):
            raise ValueError("give a value for exactly one of primary and secondary; the other one varies")
        held, at = ("primary", primary) if secondary is None else ("secondary", secondary)
        across = range or self._axes[held == "primary"][1]
        line = {"fixed": held, "at": float(at), "range": [float(end) for end in across], "ordinate": ordinate}  # type: ignore[arg-type]
        return self._seen({"cut": line}, loops, progress)

    def at(self, place: Range, *, loops: Sequence[int] | None = None, progress: Progress = None) -> Results:
        """Long-term behaviour at (primary, secondary): attractors, periodic solutions, basins of attraction."""
        return self._seen({"place": [float(value) for value in place]}, loops, progress)

    def straightened(self, near: Range, *, loops: Sequence[int] | None = None, progress: Progress = None) -> Results:
        """The curves that leave the resonance nearest to a place, as (mu - mu_graz)/eta^2 as a function of eta."""
        return self._seen({"straightened": [float(value) for value in near]}, loops, progress)

    def _seen(self, wanted: Mapping[str, Any], loops: Sequence[int] | None, progress: Progress) -> Results:
        with _heard(progress) as heard:
            return Results(self._model(loops).seen(json.dumps(wanted), heard))

    def simulate(self, place: Range, *, x: float, v: float, t: float = 0.0, periods: float = 50.0) -> Results:
        """Motion at (primary, secondary) from position x and velocity v at time t, for a number of forcing periods.

        As in all tables, x is measured from the wall, x <= 0. Tables: ``simulated_motion`` (t, x, y = x') and ``simulated_impacts``.
        """
        at, start = [float(value) for value in place], [float(x), float(v), float(t)]
        return Results(self._model(None).simulated(at, start, float(periods)))

    def family(self, *, loops: Sequence[int] | None = None, progress: Progress = None, **vary: tuple[float, float, int]) -> Results:
        """Resonances and coefficients as constants vary: ``family(zeta=(0.01, 0.05, 5))`` for five values from 0.01 to 0.05."""
        written = [f"{name}={float(low)!r}:{float(high)!r}:{count}" for name, (low, high, count) in vary.items()]
        with _heard(progress) as heard:
            return Results(self._model(loops).family(written, heard))


def reproduce(name: str, settings: Mapping[str, Any] | None = None, *, progress: Progress = None) -> Results:
    """A figure or table of the paper, or beyond it, as in the folder ``figures/``: ``reproduce("fig07")``.

    settings: values for keys of ``figures/parameters.toml``, as ``{"oscillator.zeta": 0.05}``. :func:`outputs` lists all names.
    """
    written = [f"{key}={json.dumps(value)}" for key, value in (settings or {}).items()]
    with _heard(progress) as heard:
        return Results(_grazing.reproduce(name, written, heard))


def outputs() -> dict[str, str]:
    """The outputs of :func:`reproduce`: their names and what they show."""
    return dict(_grazing.outputs())


@contextlib.contextmanager
def _heard(progress: Progress) -> Iterator[Callable[[str, int, int], None] | None]:
    if progress is not True:
        yield progress or None
        return
    from tqdm.auto import tqdm

    bars: dict[str, Any] = {}

    def heard(what: str, done: int, all: int) -> None:
        bar = bars.setdefault(what, None) or tqdm(total=all, desc=what)
        bars[what] = bar
        bar.update(done - bar.n)

    try:
        yield heard
    finally:
        for bar in bars.values():
            bar.close()

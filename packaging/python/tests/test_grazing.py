"""The package against the command line, and what it adds for people who use Python."""

import csv
import math
import os
import re
import signal
import subprocess
import warnings
from pathlib import Path

import numpy
import pandas
import polars
import pyarrow
import pyarrow.parquet
import pytest

import grazing

try:
    import tomllib
except ImportError:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[3]
#: The Duffing oscillator without its one-parameter diagram, and in smaller ranges, to save time.
TEXT = (ROOT / "examples" / "duffing.toml").read_text().split("[[diagrams]]")[0]
for _usual, _smaller in [("[0.0, 1.5]", "[0.25, 1.0]"), ("[0.4, 1.1]", "[0.6, 0.95]"), ("[1, 2, 3]", "[1, 2]")]:
    assert TEXT.count(_usual) == 1
    TEXT = TEXT.replace(_usual, _smaller)
PARAMETERS = tomllib.loads((ROOT / "figures" / "parameters.toml").read_text())
FORCE = "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)"
#: That oscillator in expressions.
WRITTEN = dict(frequency="omega", restitution="0.9", primary=("A", 0.25, 1.0), secondary=("omega", 0.6, 0.95), loops=[1, 2])


def program(*arguments):
    """What the command line says; it fails where it should not."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    return subprocess.run([target / "debug" / "grazing", *map(str, arguments)], capture_output=True, text=True)


def same(table, path):
    """The table is the CSV, number for number to the last bit."""
    header, *rows = csv.reader(path.open(newline=""))
    assert table.columns == header and len(table) == len(rows), path

    def equal(value, text):
        if isinstance(value, bool):
            return text == str(value).lower()
        if isinstance(value, float):
            return value == float(text) if text else math.isnan(value)
        return text == str(value)

    for place, name in enumerate(header):
        wrong = [(value, row[place]) for value, row in zip(table[name], rows) if not equal(value, row[place])]
        assert not wrong, (path, name, wrong[:3])


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("oscillator") / "duffing.toml"
    path.write_text(TEXT)
    return path


@pytest.fixture(scope="module")
def duffing(file):
    return grazing.Oscillator.from_toml(file)


@pytest.fixture(scope="module")
def diagram(duffing):
    return duffing.diagram()


@pytest.fixture(scope="module")
def block():
    return grazing.Oscillator.paper(PARAMETERS["oscillator"]["zeta"], PARAMETERS["oscillator"]["epsilon"])


@pytest.fixture(scope="module")
def paper(block):
    window = PARAMETERS["fig07"]
    return block.diagram(primary=window["amplitude"], secondary=window["frequency"], loops=window["loops"])


@pytest.mark.parametrize("name", ["fig02", "fig07", "fig08", "coefficients"])
def test_figures_of_the_paper_are_those_of_the_repository(name):
    found = grazing.reproduce(name)
    assert len(found) > 0
    for table in found:
        same(found[table], ROOT / "figures" / "data" / f"{table}.csv")
    for figure, svg in found.figures.items():
        assert svg == (ROOT / "figures" / f"{figure}.svg").read_text()


@pytest.mark.parametrize("table", ["curves", "points", "regions"])
def test_the_diagram_of_the_papers_oscillator_is_figure_7(paper, table):
    same(paper[table], ROOT / "figures" / "data" / f"fig07_{table}.csv")


def test_coefficients_measured_on_the_curves_are_those_of_the_closed_form(paper):
    closed, measured = grazing.reproduce("coefficients")["coefficients"], paper.coefficients
    # Of another table, in another order.
    for p, n, c in zip(closed["p"], closed["n"], closed["c_sn_closed_form"]):
        (found,) = [c for q, m, c in zip(measured["p"], measured["n"], measured["c_sn_fit"]) if (q, m) == (p, n)]
        assert found == pytest.approx(c, rel=1e-6)


def test_results_are_those_of_the_command_line(file, duffing, diagram, tmp_path):
    ran = program("unfold", file, "--at", "0.9,0.8", "--format", "svg,parquet", "--output", tmp_path)
    assert ran.returncode == 0, ran.stderr
    place = duffing.at((0.9, 0.8))
    for results in (diagram, place):
        for name in results:
            same(results[name], tmp_path / "data" / f"{name}.csv")
            read = pyarrow.parquet.read_table(tmp_path / "data" / f"{name}.parquet")
            assert read.equals(pyarrow.table(results[name]), check_metadata=True), name
        for name, figure in results.figures.items():
            assert figure == (tmp_path / f"{name}.svg").read_text()
    # Nothing that it writes is missing here.
    assert {path.stem for path in (tmp_path / "data").glob("*.csv")} == {*diagram, *place}
    assert str(diagram).splitlines()[1:] == ran.stdout.splitlines()[1 : len(str(diagram).splitlines())]


@pytest.mark.filterwarnings("ignore:something is missing")
def test_a_family_is_that_of_the_command_line(file, duffing, tmp_path):
    ran = program("unfold", file, "--vary", "zeta=0.02:0.05:2", "--loops", "1,2", "--output", tmp_path)
    family = duffing.family(zeta=(0.02, 0.05, 2), loops=[1, 2])
    # What is missing is told by a warning, as by an exit code there.
    assert ran.returncode == (3 if family.missing else 0), ran.stderr
    assert {path.stem for path in (tmp_path / "data").glob("*.csv")} == set(family)
    for name in family:
        same(family[name], tmp_path / "data" / f"{name}.csv")


def test_frames_have_the_columns_without_a_copy(diagram):
    table = diagram["curves"]
    for frame in (table.to_polars(), polars.DataFrame(table), table.to_pandas(), pyarrow.table(table)):
        assert frame.shape == (len(table), len(table.columns))
    assert list(table.to_pandas()["omega"]) == table["omega"] == table.to_polars()["omega"].to_list()
    assert isinstance(table.to_pandas(), pandas.DataFrame)
    arrow = pyarrow.table(table)
    [one, other] = [pyarrow.table(table)["omega"].chunk(0).buffers()[1].address for _ in range(2)]
    assert one == other
    told = arrow.schema.field("impact_velocity").metadata
    assert told[b"meaning"].decode() == table.about("impact_velocity")[2] != ""
    with pytest.raises(KeyError, match="the columns are"):
        table["Omega"]


def test_figures_show_themselves_and_results_plot(block, diagram, paper):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    assert diagram._repr_svg_().startswith("<?xml") or diagram._repr_svg_().startswith("<svg")
    cut, other = block.cut(secondary=0.8, range=(0.3, 0.9)), block.cut(primary=0.6, range=(0.5, 0.9))
    motion = block.simulate((0.9, 0.8), x=-1, v=0, periods=3)
    for results in (diagram, paper, cut, other, block.at((0.9, 0.8)), motion, grazing.reproduce("fig02")):
        figure, ax = pyplot.subplots()
        assert results.plot(ax) is ax and len(ax.lines) > 0
        if results in (cut, other):
            assert ax.get_xlabel() == results.names[results is other]
        pyplot.close(figure)


@pytest.mark.parametrize("held", [{"secondary": 0.8, "range": (0.3, 0.9)}, {"primary": 0.5, "range": (0.6, 0.9)}])
def test_a_cut_crosses_the_curves_of_the_diagram(duffing, diagram, held):
    results = duffing.cut(**held)
    found, curves = results.diagram_bifurcations, diagram["curves"].to_polars()
    for kind, p, impacts, A, omega in zip(found["kind"], found["p"], found["impacts"], found["A"], found["omega"]):
        # The curves of the diagram are those of solutions with one impact.
        if kind in ("SN", "PD") and impacts == 1:
            near = curves.filter((polars.col("kind") == kind) & (polars.col("p") == p))
            assert ((near["A"] - A).abs() + (near["omega"] - omega).abs()).min() < 0.02
    # The listing has the parameter that varies.
    across = found["A" if "secondary" in held else "omega"]
    lines = [line.split() for line in str(results).splitlines()]
    listed = [float(line[2]) for line in lines if len(line) == 5 and line[0] in found["kind"]]
    assert listed == pytest.approx(list(across), rel=1e-7)


def test_simulated_motion_comes_to_what_is_at_the_place(block):
    place = (0.8, 0.5)
    hits = block.simulate(place, x=-1, v=0, periods=400)["simulated_impacts"]
    # Between its impacts motion is x = A_h e^{-zeta t} cos(...) + forced: the law of impacts alone is seen in the flights.
    motion = block.simulate(place, x=-1, v=0, periods=20)["simulated_motion"].to_polars()
    ends = motion.group_by("flight", maintain_order=True).agg(polars.col("y").first().alias("from"), polars.col("y").last().alias("to"))
    after, before = ends["from"][1:].to_numpy(), ends["to"][:-1].to_numpy()
    assert numpy.allclose(after, -0.9 * before, rtol=0, atol=1e-9)
    found = block.at(place)["place_impacts"]
    for velocity in hits["impact_velocity"][-5:]:
        assert min(abs(velocity - other) for other in found["impact_velocity"]) < 1e-3


def test_expressions_and_functions_are_the_file(duffing):
    constants = dict(zeta=0.02, kappa=0.1)

    def force(x, v, t, A, omega, zeta, kappa):
        return -2 * zeta * v - x - kappa * x**3 - 1 + A * numpy.cos(omega * t)

    start = dict(x=-1.0, v=0.1, t=0.2, periods=5)
    wanted = duffing.simulate((0.9, 0.8), **start)["simulated_motion"]
    def otherwise(x, v, t, A, omega, zeta, kappa=0.1, one=numpy.float64(1)):
        return -(one - A * numpy.sin(omega * t + numpy.pi / 2)) - (x - (-zeta) * (v * 2)) - kappa * (x * x**2) / 1

    for given in (FORCE, force, otherwise):
        of = grazing.Oscillator(given, **WRITTEN, **constants)
        found = of.simulate((0.9, 0.8), **start)["simulated_motion"]
        assert numpy.allclose(found["x"], wanted["x"], rtol=0, atol=1e-9)
    changed = grazing.Oscillator.from_toml(TEXT, kappa=0.3)
    assert changed.simulate((0.9, 0.8), **start)["simulated_motion"]["x"] != wanted["x"]


@pytest.mark.parametrize(
    "force, reason",
    [
        (lambda x, v, t, A, omega: -x + A * math.cos(omega * t), "use numpy's function"),
        (lambda x, v, t, A, omega: -x if x < 0 else A * numpy.cos(omega * t), "a comparison"),
        (lambda *arguments: 0, "must name its arguments"),
    ],
)
def test_a_function_that_cannot_become_text_is_refused_with_the_way_out(force, reason):
    with pytest.raises(TypeError, match=reason) as raised:
        grazing.Oscillator(force, **WRITTEN)
    assert str(raised.value).startswith("force: ") and "write it as text" in str(raised.value)


def test_errors_have_the_words_of_the_command_line(block, tmp_path):
    for number, (right, wrong) in enumerate([("kappa*x^3", "kapa*x^3"), ("[0.25, 1.0]", "[1.0, 0.25]"), ("cos(omega*t)", "abs(x)")]):
        wrong_file = tmp_path / f"{number}.toml"
        wrong_file.write_text(TEXT.replace(right, wrong))
        with pytest.raises(ValueError) as raised:
            grazing.Oscillator.from_toml(wrong_file)
        assert program("unfold", wrong_file, "--output", tmp_path / "out").stderr.endswith(f"error: {raised.value}\n")
    with pytest.raises(OSError):
        grazing.Oscillator.from_toml(tmp_path / "none.toml")
    with pytest.raises(RuntimeError, match="no grazing"):
        block.diagram(primary=(0.0, 0.01))
    with pytest.raises(ValueError, match="fig07"):
        grazing.reproduce("fig7")


def test_an_interruption_ends_the_analysis_and_so_does_an_error_in_the_callback(duffing):
    # The environment of the tests may ignore Ctrl-C.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    heard = []

    def interrupt(what, done, all):
        heard.append((what, done, all))
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        duffing.diagram(progress=interrupt)
    assert len(heard) == 1

    def fail(what, done, all):
        raise LookupError(what)

    with pytest.raises(LookupError):
        duffing.diagram(progress=fail)


def test_progress_ends_where_it_says(block):
    last = {}
    block.at((0.9, 0.8), progress=lambda what, done, all: last.update({what: (done, all)}))
    assert last and all(done == whole for done, whole in last.values())
    block.at((0.9, 0.8), progress=True)


def test_what_is_missing_is_warned_of(block):
    text = TEXT.replace("loops = [1, 2]", "loops = [1, 2]\nstep_limit = 2e5")
    with pytest.warns(RuntimeWarning, match="integration steps"):
        found = grazing.Oscillator.from_toml(text).diagram()
    assert any("not finished" in line for line in found.missing)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert block.diagram(loops=[1]).missing == []


def test_the_gallery_is_what_its_lines_make(tmp_path, monkeypatch):
    gallery = (ROOT / "packaging" / "python" / "README.md").read_text().split("## Gallery")[1]
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    exec(gallery.split("```python\n")[1].split("```")[0], {"grazing": grazing})
    pictures = [ROOT / "packaging" / "python" / path for path in re.findall(r"!\[[^]]*\]\(([^)]+)\)", gallery)]
    assert len(pictures) == 4
    for picture in pictures:
        assert (tmp_path / picture.name).read_text() == picture.read_text(), picture.name


def test_the_notebook_runs():
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(ROOT / "packaging" / "python" / "notebooks" / "paper.ipynb", as_version=4)
    NotebookClient(notebook, timeout=None, kernel_name="python3").execute()
    shown = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs if "data" in output]
    pictures = [output for output in shown if {"image/svg+xml", "image/png"} & set(output["data"])]
    # Figures 7, 8, 2, a place, an oscillator and its family; two by matplotlib.
    assert len(pictures) == 8

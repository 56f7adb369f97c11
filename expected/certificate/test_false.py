#!/usr/bin/env python3
"""False certificates, more than two hundred, each of which check.py must refuse for its own reason. Their checksums are right.

They are parts of the certificate in a folder: a line of each kind with the two beside it, in a window that ends inside of these.
"""
import collections, pathlib, re, sys
from fractions import Fraction
import check

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
whole = {name: (folder / name).read_text() for name in check.FILES}
STATEMENT, RESONANCES, ROWS = check.FILES
texts, numbers = check.statement(whole[STATEMENT])
oscillator = check.Oscillator(*(check.exact(numbers[name]) for name in ("zeta", "epsilon")))


def text(heading, lines):
    return "".join(",".join(line) + "\n" for line in (heading, *lines))


def with_checksum(files):
    """The files with a checksum that is right, on the last line of the statement's numbers."""
    stated = files[STATEMENT].partition("checksum,")
    digits = re.match("[0-9]*", stated[2]).group()
    total = check.checksum(stated[0] + files[RESONANCES] + files[ROWS])
    return {**files, STATEMENT: f"{stated[0]}{stated[1]}{total}{stated[2][len(digits):]}"}


def certificate(rows):
    """A small certificate of consecutive lines, whose window ends in the middle of the first and the last interval."""
    first, *_, last = lines = [check.Line(oscillator, row) for row in rows]
    ends = [(line.left + line.right) / 2 for line in (last, first)]
    lowest, highest = (f"{float((oscillator.omega_1 / check.exact(nu)).mid()):.15f}" for nu in ends)
    place = lambda p, n: Fraction(n, 2) if p == 1 else n + Fraction(1, 2 * p)
    here = [row for row in all_resonances if row["p"] == rows[0]["p"] and ends[1] < place(int(row["p"]), int(row["n"])) < ends[0]]
    window = [[check.exact(Fraction(lowest)), check.exact(Fraction(highest))], amplitudes]
    points = sum(line.verdict in check.POINTS and line.is_in_window(width, *window) for line in lines)
    stated = {**texts, "omega_lowest": lowest, "omega_highest": highest, "loops": rows[0]["p"], "points": str(points)}
    return with_checksum({STATEMENT: text(check.COLUMNS[0], stated.items()),
                          RESONANCES: text(check.COLUMNS[1], (row.values() for row in here)),
                          ROWS: text(check.COLUMNS[2], (row.values() for row in rows))})


def table(files, name):
    return check.table(name, files[name], check.COLUMNS[check.FILES.index(name)])


def stated(**changes):
    """Other numbers in the statement."""
    return lambda files: {**files, STATEMENT: "".join(
        ",".join((name, changes.get(name, value))) + "\n" for name, value in (line.split(",") for line in files[STATEMENT].splitlines()))}


def cells(file, which=0, **changes):
    """Other cells in a row of a table."""
    def change(files):
        rows = table(files, file)
        rows[which] = {**rows[which], **changes}
        return {**files, file: text(rows[0], (row.values() for row in rows))}
    return change


def replaced(file, pattern, by):
    """The text with one place changed."""
    def change(files):
        changed, count = re.subn(pattern, by, files[file], count=1)
        assert count, pattern
        return {**files, file: changed}
    return change


tried = 0


def refused(files, reason, change, then=lambda files: files):
    """That the certificate is refused for a reason: once changed, its checksum made anew, and changed again."""
    global tried
    false = then(with_checksum(change(files)))
    assert false != files, f"not changed: {reason}"
    try:
        check.check(false)
    except check.FAILURES as why:
        assert re.search(reason, str(why)), f"refused for another reason than {reason}: {why}"
        tried += 1
        return
    sys.exit(f"accepted, instead of refused: {reason}\n{false[STATEMENT]}{false[ROWS]}")


def kind(row):
    return row["verdict"], row["upper_0"] != "", row["touch_0"] != "", row["base"]


rows = table(whole, ROWS)
all_resonances = table(whole, RESONANCES)
width, low, high = (check.exact(numbers[name]) for name in ("width", "amplitude_lowest", "amplitude"))
amplitudes, small = [low, high], {}
for before, row, after in zip(rows, rows[1:], rows[2:]):
    if kind(row) not in small and before["p"] == after["p"] and not {before["verdict"], after["verdict"]} & {*check.POINTS}:
        small[kind(row)] = files = certificate([before, row, after])
        check.check(files)
print(f"the parts with these {len(small)} kinds of lines are accepted:", *(" ".join(map(str, which)) for which in small), sep="\n  ")

# The statement. Any part serves, as nothing else is wrong.
plain = small["stable", True, True, "1"]
for name in check.KEYS:
    value = dict(line.split(",") for line in plain[STATEMENT].splitlines())[name]
    again = name if name != "checksum" else "points"
    refused(plain, f"{again} is given 2 times", replaced(STATEMENT, r"\Z", f"{again},{value}\n"))
    if name != "checksum":
        refused(plain, f"{name} is given 2 times", replaced(STATEMENT, "checksum", f"{name},{value}\nchecksum"))
        refused(plain, f"{name} is given 0 times", replaced(STATEMENT, f"\n{name},.*", ""))
refused(plain, "no number is called height", replaced(STATEMENT, "points", "height,2\npoints"))
refused(plain, "no number is called note", replaced(STATEMENT, r"\Z", "note,true\n"))
refused(plain, "line 12: 1 cells", replaced(STATEMENT, r"\Z", "\n"))
refused(plain, "line 6: 3 cells", replaced(STATEMENT, "amplitude_lowest,", "amplitude_lowest,0,"))
refused(plain, "not in the order", replaced(STATEMENT, "(zeta,.*\n)(epsilon,.*\n)", r"\2\1"))
refused(plain, "not in the order", replaced(STATEMENT, "(points,.*\n)((?s:.*))", r"\2\1"))
refused(plain, "the columns are not name,value", replaced(STATEMENT, "name,value", "value,name"))
refused(plain, "the columns are not name,value", replaced(STATEMENT, "name,value", "name,value\r"))
for file in check.FILES:
    refused(plain, f"{file}: not lines of ASCII", replaced(file, r"\n\Z", ""))
    refused(plain, f"{file}: not lines of ASCII", replaced(file, r"\n", "\xa0\n"))
decimals = "0.3/7", "1/50", "0x1", "1_0", "+1", " 1", "1 ", "nan", "inf", "", ".5", "1e999999999", "1e-999999999", "1e100", "0." + 50 * "1"
for i, wrong in enumerate(decimals):
    name = check.KEYS[i % 7]
    refused(plain, f"{name} = .*not a decimal number", stated(**{name: wrong}))
for wrong in ("1e3", "1.0", "", " 1", "-", "1_0", 50 * "1"):
    refused(plain, "points = .*not an integer", stated(points=wrong))
    refused(plain, "loops = .*not an integer", stated(loops=wrong.replace(" ", "  ")))
for reason, change in [
    ("zeta: not between", dict(zeta="0")), ("zeta: not between", dict(zeta="1")), ("zeta: not between", dict(zeta="-0.02")),
    ("epsilon: not positive", dict(epsilon="0")), ("epsilon: not positive", dict(epsilon="-0.9")),
    ("epsilon: not positive", dict(epsilon="1.0000000001")),
    ("omega_lowest, omega_highest: not", dict(omega_lowest="0")), ("omega_lowest, omega_highest: not", dict(omega_lowest="-0.3")),
    ("omega_lowest, omega_highest: not", dict(omega_lowest="200")), ("omega_lowest, omega_highest: not", dict(omega_highest="-1")),
    ("amplitude_lowest, amplitude: not", dict(amplitude="0")), ("amplitude_lowest, amplitude: not", dict(amplitude="-1.3")),
    ("amplitude_lowest, amplitude: not", dict(amplitude_lowest="-0.1")), ("amplitude_lowest, amplitude: not", dict(amplitude_lowest="99")),
    ("width: not positive", dict(width="0")), ("width: not positive", dict(width="-1")), ("width: not positive", dict(width="-1e-6")),
    ("width: not positive", dict(width="1000")), ("width: not positive", dict(width="0.5")),
    ("loops = 0: not from 1", dict(loops="0")), ("loops = -1: not from 1", dict(loops="-1")), ("loops = 999: not", dict(loops="1 999")),
    ("loops: not increasing", dict(loops="1 1")), ("loops: not increasing", dict(loops="3 1 2")),
    ("points = -1: not from 0", dict(points="-1")),
]:
    refused(plain, reason, stated(**change))
one = small[next(which for which in small if which[0] in check.POINTS)]
right = dict(line.split(",") for line in one[STATEMENT].splitlines())["points"]
for wrong in {"0", "1", "2", "1000"} - {right}:
    refused(one, f"points: {right} are in the window, not {wrong}", stated(points=wrong))
refused(plain, "points: 0 are in the window, not 1", stated(points="1"))
ours = dict(line.split(",") for line in plain[STATEMENT].splitlines())
for name, factor in (("omega_lowest", 0.95), ("omega_highest", 1.05)):
    refused(plain, "the intervals do not cover the window|resonance p, n = .* listed 0 times", stated(**{name: f"{factor * float(ours[name]):.15f}"}))
refused(plain, "resonance p, n = .* listed 0 times", stated(omega_highest="99"))
refused(plain, "with so many resonances", stated(omega_lowest="0.001"))
refused(plain, "p: not those that the statement", stated(loops=ours["loops"] + " 99"))
refused(plain, "checksum: a file is not what it was taken of", lambda files: files, lambda files: {**files, ROWS: files[ROWS].replace("stable", "none", 1)})

# Resonances.
which = all_resonances[0]
at = check.exact(Fraction(int(which["n"]), 2) if which["p"] == "1" else int(which["n"]) + Fraction(1, 2 * int(which["p"])))
lines = [row for row in rows if row["p"] == which["p"]]
index = next(i for i, row in enumerate(lines) if at < check.exact(check.Line(oscillator, row).right))
resonant = certificate(lines[index - 2:index + 3])
check.check(resonant)
called = f"resonance p, n = .{which['p']}, {which['n']}.: "
listed = resonant[RESONANCES].splitlines()[1]
refused(resonant, called + "listed 2 times, not 1", replaced(RESONANCES, r"\Z", listed + "\n"))
refused(resonant, called + "listed 0 times, not 1", replaced(RESONANCES, listed + "\n", ""))
refused(resonant, "resonance p, n = .*listed (1 times, not 0|0 times, not 1)", cells(RESONANCES, n=str(int(which["n"]) + 7)))
refused(resonant, "n = 200: not from 0 to 199", cells(RESONANCES, n="200"))
refused(resonant, "p = 0: not from 1", cells(RESONANCES, p="0"))
refused(resonant, "line 3: 1 cells", replaced(RESONANCES, r"\Z", "\n"))
refused(resonant, "line 2: 11 cells", replaced(RESONANCES, r",\n\Z", ",,\n"))
refused(resonant, "the columns are not p,n", replaced(RESONANCES, "omega_star,amplitude_graz", "amplitude_graz,omega_star"))
refused(resonant, "the columns are not p,n", replaced(RESONANCES, "not_shown", "not_shown,not_shown"))
for name in check.NUMBERS:
    value = which[name]
    digit = lambda i: value[:i] + str((int(value[i]) + 1) % 10) + value[i + 1:]
    refused(resonant, f"{called}{name}: a digit is wrong", cells(RESONANCES, **{name: digit(len(value) - 1)}))
    refused(resonant, f"{called}{name}: a digit is wrong", cells(RESONANCES, **{name: digit(len(value) // 2), "not_shown": "a hypothesis"}))
    refused(resonant, f"{called}{name}: a digit is wrong", cells(RESONANCES, **{name: value[1:] if value[0] == "-" else "-" + value}))
    refused(resonant, f"{called}{name} = .*not a decimal number", cells(RESONANCES, **{name: "?"}))
refused(resonant, f"{called}omega_star: a digit is wrong", cells(RESONANCES, omega_star=which["omega_star"] + "e0"))
refused(resonant, f"{called}c_sn = .*not a decimal number", cells(RESONANCES, c_sn="-1e999999999"))

# The form of rows.
middle = lambda files, **changes: cells(ROWS, 1, **changes)
first, line, last = plain[ROWS].splitlines()[1:]
refused(plain, "the columns are not p,left", replaced(ROWS, "verdict", "verdict,verdict"))
refused(plain, "the columns are not p,left", replaced(ROWS, "reason", "verdict"))
refused(plain, "the columns are not p,left", replaced(ROWS, "lower_0,lower_1", "lower_1,lower_0"))
refused(plain, "line 3: 19 cells", replaced(ROWS, f"\n{line}", f"\n{line},"))
refused(plain, "line 3: 17 cells", replaced(ROWS, f"\n{line}", f"\n{line[:-1]}"))
refused(plain, "line 5: 1 cells", replaced(ROWS, r"\Z", "\n"))
refused(plain, "overlap or leave a gap", replaced(ROWS, f"\n{line}", ""))
refused(plain, "overlap or leave a gap", replaced(ROWS, f"\n{line}", f"\n{line}\n{line}"))
refused(plain, "overlap or leave a gap", replaced(ROWS, f"\n{line}\n{last}", f"\n{last}\n{line}"))
refused(plain, "do not cover the window", replaced(ROWS, f"\n{first}", ""))
refused(plain, "do not cover the window", replaced(ROWS, f"\n{last}", ""))
refused(plain, "p: not those", lambda files: {**files, ROWS: text(check.COLUMNS[2], ())})
empty = {name: "" for name in check.COLUMNS[2][5:]}
undecided = lambda number: cells(ROWS, number, **{**empty, "verdict": "undecided", "reason": "not known"})
refused(plain, "nothing is stated", lambda files: undecided(0)(undecided(1)(undecided(2)(files))))
for reason, change in [
    ("verdict: none of those", dict(verdict="perhaps")), ("verdict: none of those", dict(verdict="")),
    ("reason: only of a line that is undecided", dict(reason="beautiful")),
    ("reason: only of a line that is undecided", {**empty, "verdict": "undecided"}),
    ("lower: serves no purpose here", dict(verdict="undecided", reason="not known")),
    ("lower: serves no purpose here", dict(verdict="none")), ("lower: not given", {f"lower_{i}": "" for i in range(3)}),
    ("touch: serves no purpose here", {f"upper_{i}": "" for i in range(3)}), ("touch: not given", {f"touch_{i}": "" for i in range(2)}),
    ("cells: not given", dict(cells="", start="", end="", blocks="")), ("start = : not an integer", dict(start="")),
    ("lower_1 = : not an integer", dict(lower_1="")), ("upper_2 = 1.5: not an integer", dict(upper_2="1.5")),
    ("touch_1 = 1e5: not an integer", dict(touch_1="1e5")), ("lower_0 = .*not an integer", dict(lower_0=60 * "1")),
    ("base = 3: not from 0 to 2", dict(base="3")), ("base: no resonance of one loop is there", dict(base="0")),
    ("level = 1000000000: not from 0 to 64", dict(level="1000000000")), ("level = -1: not from 0", dict(level="-1")),
    ("left = -5: not from 0", dict(left="-5")), ("overlap or leave a gap", dict(left="5")), ("p: not", dict(p="77")),
    ("cells = 0: not from 1", dict(cells="0")), ("cells = 1000000000000: not from 1 to 4096", dict(cells="1000000000000")),
    ("start = 0: not from 1", dict(start="0")), ("end = 1000000: not from 1", dict(end="1000000")), ("start: not before end", dict(start="40", end="40")),
    ("blocks: not four numbers each", dict(blocks="1:2:3")), ("blocks = x: not an integer", dict(blocks="x:2:3:4")),
    ("blocks: not from start to end", dict(blocks="1:999999:3:4")), ("blocks: not from start to end", dict(blocks="30:29:3:4")),
    ("may touch the wall outside of the blocks", dict(blocks="")),
]:
    refused(plain, reason, cells(ROWS, 1, **change))
block = line.split(",")[16].split(";")[0]
refused(plain, "blocks: two have cells in common", cells(ROWS, 1, blocks=f"{block};{block}"))

# Lines that claim something else than their inequalities prove.
def side(row, to, of, factor=1):
    """The coefficients of a witness, the leading one multiplied, in place of another's."""
    leading = 0 if row["base"] == "1" else 1
    return {f"{to}_{i}": str(int(row[f"{of}_{i}"]) * (factor if i == leading else 1)) for i in range(3)}


wrong_width = stated(width="1e-12")
for (verdict, upper, touch, base), files in small.items():
    row = table(files, ROWS)[1]
    claims = {"stable", "none", *check.POINTS} - {verdict}
    for claim in sorted(claims):
        refused(files, f"{claim}: (?!reason)", cells(ROWS, 1, verdict=claim))
    if row["lower_0"] and upper:
        refused(files, "in a block|outside of the blocks|not be stable|may not change", cells(ROWS, 1, **side(row, "lower", "upper")))
        refused(files, "may not be beyond the wall", cells(ROWS, 1, **side(row, "upper", "lower")))
        refused(files, "the tube is wider than stated", cells(ROWS, 1, **side(row, "upper", "upper", 1000)))
        refused(files, "`lower` may not be positive", cells(ROWS, 1, **side(row, "lower", "lower", -1)))
        refused(files, "the tube is wider than stated", wrong_width)
    elif row["lower_0"]:
        refused(files, "may not become stable below `lower`", cells(ROWS, 1, lower_0="1", lower_1="0", lower_2="0"))
        refused(files, "may neither end below `lower`", stated(amplitude="1000"))
    elif upper:
        refused(files, "may not be beyond the wall|may be stable|may not vanish at the resonance", cells(ROWS, 1, upper_0="1", upper_1="0", upper_2="0"))
    else:
        refused(files, "`touch` is not a whole turn", cells(ROWS, 1, touch_0=str(int(row["touch_0"]) + 1)))
        refused(files, "may not be beyond the wall", cells(ROWS, 1, touch_0="0"))
refused(plain, ".", stated(zeta=str(float(texts["zeta"]) + 0.01)))
refused(plain, ".", stated(epsilon=str(float(texts["epsilon"]) - 0.1)))

# The checker does not know the lemma, by which P v > b holds at `upper` if it holds at `lower`.
row, signs, conditions = check.Line(oscillator, table(plain, ROWS)[1]), iter((1, 1, -1)), check.Line.conditions
check.Line.conditions = lambda self, velocity: (lambda low, high: (next(signs) * low, high))(*conditions(self, velocity))
try:
    row.check(width, high)
    sys.exit("accepted, though P v < b at `upper`")
except check.Refused as why:
    assert "a multiplier may be 1" in str(why), why
print(f"all of {tried} false certificates are refused, each for its reason")

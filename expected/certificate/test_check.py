#!/usr/bin/env python3
"""Certificates with one digit changed, a hundred and at least three in every column, none of which check.py may accept; how many
changes of rows.csv it refuses for their inequalities alone, the checksum left aside; and rows that claim something else than
they prove."""
import csv, pathlib, random, sys
import check

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
files = {name: (folder / name).read_text() for name in check.FILES}
_, numbers = check.statement(files["statement.csv"])
zeta, epsilon, *window, _, amplitude, width = (check.exact(numbers[name]) for name in check.KEYS[:7])
oscillator, loops = check.Oscillator(zeta, epsilon), numbers["loops"]
random.seed(1)


def refused(attempt):
    try:
        attempt()
    except check.FAILURES:
        return True
    return False


def changes(name):
    """Places of digits: three in every column that has any, and random ones to a hundred."""
    columns, place = {}, 0
    for row, line in enumerate(files[name].splitlines(keepends=True)):
        for column, cell in enumerate(line.rstrip("\n").split(",")):
            columns.setdefault(column, []).extend(place + i for i, c in enumerate(cell) if row and c.isdigit())
            place += len(cell) + 1
    chosen = [place for places in columns.values() if places for place in random.sample(places, min(3, len(places)))]
    return chosen + random.choices([place for places in columns.values() for place in places], k=max(0, 100 - len(chosen)))


for name, text in files.items():
    by_inequality, places = 0, changes(name)
    for place in places:
        digit = random.choice([d for d in "0123456789" if d != text[place]])
        changed = text[:place] + digit + text[place + 1:]
        assert refused(lambda: check.check({**files, name: changed})), (name, place, digit)
        if name == "rows.csv":
            number = text[:place].count("\n")
            rows = [dict(zip(*(x.splitlines()[line].split(",") for line in (0, number)))) for x in (text, changed)]
            same = all(rows[0][x] == rows[1][x] for x in ("p", "left", "level"))
            by_inequality += not same or refused(lambda: check.Line(oscillator, rows[1]).check(width, amplitude))
        elif name == "resonances.csv":
            assert refused(lambda: check.resonances(oscillator, changed, loops, *window)), (place, digit)
            by_inequality += 1
    print(f"{name}: all of {len(places)} changed digits are refused, {by_inequality} for their inequalities alone")

rows, seen, tried = list(csv.DictReader(files["rows.csv"].splitlines())), {}, 0
for row in rows:
    kind = row["verdict"], row["upper_0"] != "", row["base"]
    seen[kind] = row
for (verdict, has_upper, _), row in seen.items():
    side = lambda to, of: {f"{to}_{i}": row[f"{of}_{i}"] if of else "" for i in range(3)}
    wrong = [{"verdict": other} for other in ("stable", "none", *check.POINTS) if other != verdict]
    if row["lower_0"] and has_upper:
        wrong += [side("lower", "upper"), side("upper", "lower"), side("lower", None), side("upper", None), {"blocks": ""}]
    for change in wrong:
        assert refused(lambda: check.Line(oscillator, {**row, **change}).check(width, amplitude)), (row, change)
        tried += 1
print(f"rows.csv: all of {tried} rows of {len(seen)} kinds that claim something else are refused")

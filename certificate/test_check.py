#!/usr/bin/env python3
"""A hundred certificates with one digit changed, none of which check.py may accept; and how many it refuses for their
inequalities alone, the checksum left aside."""
import csv, pathlib, random
import check

folder = pathlib.Path(__file__).parent
text = (folder / "rows.csv").read_text()
statement = dict(csv.reader(open(folder / "statement.csv")))
oscillator = check.Oscillator(check.exact(statement["zeta"]), check.exact(statement["epsilon"]))
width, amplitude = check.exact(statement["width"]), check.exact(statement["amplitude"])
body = text.index("\n") + 1
places = [place for place in range(body, len(text)) if text[place].isdigit()]
random.seed(1)
by_checksum = by_inequality = 0
for place in random.sample(places, 100):
    digit = random.choice([d for d in "0123456789" if d != text[place]])
    changed = text[:place] + digit + text[place + 1:]
    by_checksum += check.checksum(changed) != int(statement["checksum"])
    line = changed[changed.rindex("\n", 0, place) + 1:changed.index("\n", place)]
    before = text[text.rindex("\n", 0, place) + 1:text.index("\n", place)]
    header = text[:body - 1].split(",")
    row, old = (dict(zip(header, cells.split(","))) for cells in (line, before))
    try:
        check.require(all(row[x] == old[x] for x in ("p", "left", "level")), "does not tile the window")
        check.Line(oscillator, row).check(width, amplitude)
    except (check.Refused, ValueError, IndexError, KeyError, ZeroDivisionError):
        by_inequality += 1
print(f"of 100 changed certificates {by_checksum} are refused, {by_inequality} for their inequalities alone")
assert by_checksum == 100 and by_inequality > 0

#!/usr/bin/env python3
"""Checks the certificate of Figure 7 without searching: every line is a few inequalities between balls of python-flint.

    pip install python-flint && python3 check.py [FOLDER] [--expect zeta=0.02,epsilon=0.9,...]

It prints the statement that was checked. With --expect, any of the numbers of statement.csv must be these.

../../docs/proof.md says what each verdict states and why these inequalities prove it. Nothing here is taken from the program that
writes the certificate: motion is the real part of two complex exponentials, its stability that of the saltation matrix.
"""
import argparse, collections, pathlib, re, sys
from fractions import Fraction
from flint import acb, acb_series, arb, arb_series, ctx

ctx.prec, ctx.cap = 140, 4
I, PI, UNIT = acb(0, 1), arb.pi(), arb(2) ** -64
FILES = ("statement.csv", "resonances.csv", "rows.csv")
KEYS = ("zeta", "epsilon", "omega_lowest", "omega_highest", "amplitude_lowest", "amplitude", "width", "loops", "points", "checksum")
NUMBERS = ("omega_star", "amplitude_graz", "s_plus", "s_minus", "c_sn", "c_pd", "criticality")
# The numbers of coefficients of the witnesses.
WITNESSES = {"lower": 3, "upper": 3, "touch": 2}
COLUMNS = (("name", "value"), ("p", "n", *NUMBERS, "not_shown"),
           ("p", "left", "level", "base", "verdict", *(f"{name}_{i}" for name, terms in WITNESSES.items() for i in range(terms)),
            "cells", "start", "end", "blocks", "reason"))
# At how many times motion touches the wall, at which of the two conditions its stability begins or ends, and which.
POINTS = {"SN-GZ": (1, 0, "begins"), "PD-GZ": (1, 1, "begins"), "GZ-PD": (1, 1, "ends"), "GZ-GZ": (2, None, None)}
Block = collections.namedtuple("Block", "first last time curvature cells")


class Refused(Exception):
    pass


FAILURES = (Refused, ArithmeticError, ValueError)


def require(condition, what):
    if not condition:
        raise Refused(what)


def table(name, text, columns):
    """The rows of a file that has exactly these columns."""
    require(text.isascii() and text.endswith("\n"), f"{name}: not lines of ASCII characters, each with its end")
    heading, *lines = (line.split(",") for line in text[:-1].split("\n"))
    require(heading == list(columns), f"{name}: the columns are not {','.join(columns)}")
    for number, cells in enumerate(lines, 2):
        require(len(cells) == len(columns), f"{name}, line {number}: {len(cells)} cells, not {len(columns)}")
    return [dict(zip(columns, cells)) for cells in lines]


def integer(name, text, least=-10**39, most=10**39):
    require(re.fullmatch("-?[0-9]{1,39}", text), f"{name} = {text[:60]}: not an integer of at most 39 digits")
    require(least <= int(text) <= most, f"{name} = {text}: not from {least} to {most}")
    return int(text)


def decimal(name, text):
    """A decimal number, exactly. Its digits and its exponent are few, so that it fits into memory."""
    form = r"-?[0-9]{1,40}(\.[0-9]{1,40})?(e-?[0-9]{1,2})?"
    require(re.fullmatch(form, text), f"{name} = {text[:60]}: not a decimal number with few digits and an exponent from -99 to 99")
    return Fraction(text)


def exact(value):
    return arb(value.numerator) / value.denominator


def real(x):
    return arb_series([c.real for c in acb_series(x).coeffs()])


def imag(x):
    return real(-I * x)


def norm(x):
    return real(x) ** 2 + imag(x) ** 2


class Oscillator:
    """Functions of nu, a Taylor series, of times in turns of the forcing, and of the velocity v at impact."""

    def __init__(self, zeta, epsilon):
        self.zeta, self.e, self.omega_1 = zeta, epsilon, (1 - zeta**2).sqrt()
        self.mode = acb(-zeta / self.omega_1, 1)

    def free(self, nu, turns):
        """exp(mode nu theta), the factor of a free oscillation."""
        sine, cosine = (2 * nu * turns).sin_cos_pi()
        return (2 * PI * self.mode.real * nu * turns).exp() * (cosine + I * sine)

    def motion(self, p, nu, v):
        """F and H, such that x = -1 + Re(F exp(i theta) + H exp(mode nu theta)) is 0 at impacts, and x' is -e v after and v before."""
        h = I * (1 + self.e) * v / (nu * (1 - self.free(nu, arb(p))))
        return 1 - real(h) + I * (self.e * v + real(self.mode * nu * h)), h

    def distance(self, nu, motion, turns, derivative=0):
        """-x, or a derivative of it in theta."""
        sine, cosine = (2 * turns).sin_cos_pi()
        forced = motion[0] * I**derivative * (cosine + I * sine)
        return (derivative == 0) - real(forced + motion[1] * (self.mode * nu) ** derivative * self.free(nu, turns))

    def conditions(self, p, nu, v):
        """v (1 + D - T) and v (1 + D + T), linear in v: determinant D and trace T of the derivative, from the saltation matrix."""
        (f, h), whole = self.motion(p, nu, v), self.free(nu, arb(p))
        force = real((self.mode * nu) ** 2 * h - f) + 2 * self.mode.real * nu * self.e * v
        trace = (1 + self.e) * imag(whole) / nu * force - 2 * self.e * v * real(whole)
        total = v + v * self.e**2 * norm(whole)
        return total - trace, total + trace

    def limit(self, p, nu, which):
        """The velocity at which one of the conditions is zero: a multiplier is 1, or -1."""
        at_0, at_1 = (self.conditions(p, nu, v + 0 * nu)[which] for v in (0, 1))
        return at_0 / (at_0 - at_1)

    def amplitude_square(self, nu, f):
        omega = self.omega_1 / nu
        return norm(1 - omega * omega + 2 * I * self.zeta * omega) * norm(f)


class Line:
    """A line of the certificate. Functions of nu hold on its whole interval by Taylor's theorem."""

    def __init__(self, oscillator, row):
        number = lambda name, least=-10**39, most=10**39: integer(name, row[name], least, most)
        self.o, self.verdict, self.reason = oscillator, row["verdict"], row["reason"]
        self.p, left, level, self.base = number("p", 1, 99), number("left", 0), number("level", 0, 64), number("base", 0, 2)
        self.left, self.right, origin = (Fraction(2 * left + i, 2 * 2**level) for i in (0, 2, self.base))
        require(self.base == 1 or self.p > 1 and (2 * origin).denominator == 1, "base: no resonance of one loop is there")
        self.origin, self.all = exact(origin), exact(self.left).union(exact(self.right))
        self.witnesses = {}
        for name, terms in WITNESSES.items():
            cells = [f"{name}_{i}" for i in range(terms)]
            present = any(row[cell] for cell in cells)
            self.witnesses[name] = [number(cell) for cell in cells] if present else None
        self.cells = None
        if any(row[name] for name in ("cells", "start", "end", "blocks")):
            self.cells = number("cells", 1, 4096)
            self.start, self.end = number("start", 1, self.p * self.cells), number("end", 1, self.p * self.cells - 1)
            parts = [block.split(":") for block in row["blocks"].split(";")] if row["blocks"] else []
            require(all(len(part) == 4 for part in parts), "blocks: not four numbers each")
            self.stated_blocks = [[integer("blocks", x) for x in part] for part in parts]
            spans = sorted(block[:2] for block in self.stated_blocks)
            require(self.start < self.end, "start: not before end")
            require(all(self.start <= first <= last < self.end for first, last in spans), "blocks: not from start to end")
            require(all(a[1] < b[0] for a, b in zip(spans, spans[1:])), "blocks: two have cells in common")

    def has(self, *names):
        """That the line has these witnesses and no others, and a reason only if it is undecided."""
        require(bool(self.reason) == (self.verdict == "undecided"), "reason: only of a line that is undecided, and of each of them")
        for name, present in {**self.witnesses, "cells": self.cells}.items():
            require((present is not None) == (name in names), f"{name}: {'not given' if name in names else 'serves no purpose here'}")

    def range(self, functions, orders):
        """At a resonance divided by |nu - base| to the power of each order, as often as a function vanishes there."""
        near_and_far = zip(*(functions(arb_series([nu, 1])) for nu in (self.origin, self.all)))
        for (near, far), order in zip(near_and_far, orders):
            near, far = (list(x.coeffs()) + [arb(0)] * 4 for x in (near, far))
            order = 0 if self.base == 1 else order
            require(all(c == 0 and c.is_exact() for c in near[:order]), "a function may not vanish at the resonance")
            total = far[3]
            for c in reversed(near[order:3]):
                total = c + (self.all - self.origin) * total
            yield -total if self.base == 2 and order % 2 else total

    def polynomial(self, coefficients):
        return lambda nu: sum((c * UNIT * (nu - self.origin) ** i for i, c in enumerate(coefficients)), 0 * nu)

    def motion(self, nu, velocity):
        return self.o.motion(self.p, nu, velocity(nu))

    def conditions(self, velocity):
        return tuple(self.range(lambda nu: self.o.conditions(self.p, nu, velocity(nu)), (1, 1)))

    def beyond(self, velocity, time, order=2):
        functions = lambda nu: (self.o.distance(nu, self.motion(nu, velocity), time(nu)), velocity(nu), time(nu))
        distance, v, time = self.range(functions, (order, order - 1, 0))
        require(distance < 0 and v > 0 and 0 < time < self.p, "motion with velocity `upper` may not be beyond the wall at `touch`")

    def blocks(self, lower, upper, touching, closely):
        """That motion with velocities between these touches the wall in none but the first blocks of cells, so many, once in each
        at most, and with `lower` in none. Bounds in a cell follow from ranges of F and H; `closely`, where these are not enough, from
        those of the distance as a function of nu."""
        n, start, end, blocks = self.cells, self.start, self.end, self.stated_blocks
        parts = lambda v: self.range(lambda nu: [part(x) for x in self.motion(nu, v) for part in (real, imag)], (0,) * 4)
        f, f_imag, h, h_imag = (x.union(y) for x, y in zip(parts(lower), parts(upper)))
        motion, r, curvatures = (acb(f, f_imag), acb(h, h_imag)), arb(0, PI / n), []

        def in_cell(near, third):
            return [near[0] + r * (near[1] + r * (near[2] + r * third / 3) / 2), near[1] + r * (near[2] + r * third / 2), near[2] + r * third]
        for cell in range(self.p * n):
            middle = exact(Fraction(2 * cell + 1, 2 * n))
            near = [self.o.distance(self.all, motion, middle, order)[0] for order in range(3)]
            third = self.o.distance(self.all, motion, middle + arb(0, arb(1) / (2 * n)), 3)[0]
            distance, slope, curvature = in_cell(near, third)
            if closely and not distance > 0:
                orders = lambda v: self.range(lambda nu: [self.o.distance(nu, self.motion(nu, v), middle, i) for i in range(3)], (0,) * 3)
                distance, slope, curvature = in_cell([x.union(y) for x, y in zip(orders(lower), orders(upper))], third)
            curvatures.append(curvature.lower())
            if cell < start:
                require(slope > 0 or (cell == 0 and curvature > 0), "motion may not leave the wall before `start`")
            elif cell >= end:
                require(slope < 0 or (cell == self.p * n - 1 and curvature > 0), "motion may not return to the wall from `end` on")
            elif not any(b[0] <= cell <= b[1] for b in blocks):
                require(distance > 0, "motion may touch the wall outside of the blocks")
        blocks = [Block(b[0], b[1], self.polynomial(b[2:]), min(curvatures[b[0]:b[1] + 1]), n) for b in blocks]
        require(len(blocks) >= touching and all(self.minimum(lower, b)[0] > 0 for b in blocks), "motion with velocity `lower` may touch the wall in a block, or too few blocks are open")
        require(all(self.minimum(upper, b)[0] > 0 for b in blocks[touching:]), "motion with velocity `upper` may touch the wall in a block that is not open")
        return blocks[:touching]

    def minimum(self, velocity, block, end=None):
        """The least distance in a block is at least f - g^2/(2 mu), at a time no farther than |g|/mu away."""
        def functions(nu):
            motion, time = self.motion(nu, velocity), block.time(nu)
            return self.o.distance(nu, motion, time), self.o.distance(nu, motion, time, 1), velocity(nu), time
        at_end = () if end is None else (x[0] for x in functions(arb_series([exact(end), 1])))
        f, g, v, time = at_end or self.range(functions, (2, 1, 1, 0))
        require(v > 0 and block.curvature > 0 and block.first <= time * block.cells <= block.last + 1, "the time of a block may be outside of it, or the curvature not positive")
        return (f - g.abs_upper() ** 2 / (2 * block.curvature)).lower(), time + arb(0, g.abs_upper() / (2 * PI * block.curvature))

    def contact(self, nu, time):
        """(1 - cos)/psi: the velocity at which motion touches the wall at a time."""
        rise, distance = (self.o.distance(nu, self.motion(nu, lambda nu: v + 0 * nu), time) for v in (0, 1))
        return 2 * (PI * time).sin() ** 2 / (rise - distance)

    def changes_order_once(self, events, lower, upper, which):
        """That at exactly one nu two events come at the same velocity: that stability begins or ends (None), and contact in blocks,
        whose curvatures are those of motion with velocities up to `upper`."""
        limit = lambda nu: self.o.limit(self.p, nu, which)
        at = lambda nu, event, time: limit(nu) if event is None else self.contact(nu, time)
        rates = []
        for event in events:
            time = event and self.minimum(lower, event)[1].union(self.minimum(upper, event)[1])
            rates.append(at(arb_series([self.all, 1]), event, arb_series([time]) if event else None)[1])
        require(rates[0] < rates[1] or rates[0] > rates[1], "the two events may coincide more than once")

        def comes_first(one, two, end):
            nu = arb_series([exact(end), 1])
            if two:
                velocity = lambda nu: at(nu, one, one and one.time(nu))
                return (upper(nu) - velocity(nu))[0] > 0 and self.minimum(velocity, two, end)[0] > 0
            return self.o.distance(nu, self.motion(nu, limit), one.time(nu))[0] < 0 and limit(nu)[0] > 0
        orders = [[comes_first(*pair, end) for pair in (events, events[::-1])] for end in (self.left, self.right)]
        require(sorted(orders) == [[False, True], [True, False]], "the two events may not coincide")

    def leaves(self, velocity, amplitude):
        """That motion with this velocity, and with any greater one, is beyond the window: the amplitude is, and its square, which is
        a convex function of the velocity, increases."""
        def functions(nu):
            f = self.motion(nu, velocity)[0]
            return self.o.amplitude_square(nu, f), norm(f) - real(f), velocity(nu)
        square, growth, v = self.range(functions, (0, 1, 1))
        return square > amplitude**2 and growth > 0 and v > 0

    def is_narrow(self, difference, width):
        """That the amplitude changes by less than the width of a tube where the velocity changes by no more than this."""
        wide = lambda nu: (self.o.amplitude_square(nu, self.motion(nu, self.polynomial(difference))[0] - 1),)
        require(next(self.range(wide, (0,))) < width**2, "the tube is wider than stated")

    def positive_slope(self):
        """That v (1 + D - T) increases with v: a multiplier is greater than 1 at small velocities alone."""
        slope = lambda nu: (self.o.conditions(self.p, nu, 1 + 0 * nu)[0] - self.o.conditions(self.p, nu, 0 * nu)[0],)
        return next(self.range(slope, (0,))) > 0

    def is_in_window(self, width, omegas, amplitudes):
        """Whether the point of this line is in the window. Its velocity is between `lower` and `upper`, and so its amplitude within
        `width` of that for `lower`."""
        lower = self.polynomial(self.witnesses["lower"])
        square = next(self.range(lambda nu: (self.o.amplitude_square(nu, self.motion(nu, lower)[0]),), (0,)))
        places = ((self.o.omega_1 / self.all, omegas), (square.sqrt() + arb(0, width), amplitudes))
        inside = all(low <= x <= high for x, (low, high) in places)
        require(inside or any(x < low or x > high for x, (low, high) in places), "the point may be in the window or beyond it")
        return inside

    def check(self, width, amplitude):
        verdict = self.verdict
        require(verdict in ("stable", "none", "thin", "undecided", *POINTS), "verdict: none of those that there are")
        if verdict == "undecided":
            return self.has()
        lower, upper, touch = (numbers and self.polynomial(numbers) for numbers in self.witnesses.values())
        if verdict in ("none", "thin"):
            self.has(*(["upper", "touch"] if verdict == "thin" else ["upper"] if upper else ["touch"]), *(["touch"] if touch else []))
        else:
            self.has("lower", "cells", *(["upper", "touch"] if upper or verdict != "stable" else []))
            require(next(self.range(lambda nu: (lower(nu),), (1,))) > 0, "`lower` may not be positive")
        if self.base != 1:
            motion = self.o.motion(self.p, self.origin, arb(1))
            require(self.o.distance(self.origin, motion, arb_series([1]), 1)[0] != 0, "motion may be admissible at the resonance itself")
        if upper and touch:
            self.beyond(upper, touch)
        if verdict == "thin":
            return self.is_narrow(self.witnesses["upper"], width)
        at_0 = self.conditions(lambda nu: 0 * nu)
        if verdict == "none":
            if upper:
                at_upper = self.conditions(upper)
                require(any(x < 0 and y < 0 for x, y in zip(at_upper, at_0)), "motion with a velocity up to `upper` may be stable")
                require(touch or self.leaves(upper, amplitude), "motion with a velocity from `upper` on may be in the window")
            else:
                require(self.witnesses["touch"][0] % 2**64 == 0 == self.witnesses["touch"][1], "`touch` is not a whole turn")
                self.beyond(lambda nu: 1 + 0 * nu, touch, 1)
            return
        touching, which, change = POINTS[verdict] if verdict != "stable" else (1 if upper else 0, None, None)
        low, high = self.conditions(lower)
        if upper:
            low_at_upper, high_at_upper = self.conditions(upper)
            require(change == "begins" or (low > 0 and high > 0), "motion with velocity `lower` may not be stable")
            require(low_at_upper > 0 if verdict != "SN-GZ" else self.positive_slope(), "a multiplier may be 1 between `lower` and `upper`")
            require(verdict in ("PD-GZ", "GZ-PD") or high_at_upper > 0, "a multiplier may be -1 between `lower` and `upper`")
            require(not change or (at_0[which] < 0 if change == "begins" else at_0[which] > 0), "stability may not change as the verdict says")
            self.is_narrow([a - b for a, b in zip(self.witnesses["upper"], self.witnesses["lower"])], width)
        else:
            # From where the first condition holds on to where the second fails, or to amplitudes beyond the window.
            require(low > 0 and (high > 0 or at_0[0] < 0), "motion may not become stable below `lower`")
            require((high < 0 and at_0[0] < 0) or self.leaves(lower, amplitude), "stable motion may neither end below `lower` nor leave the window there")
        for closely in (False, True):
            try:
                blocks = self.blocks(lower, upper or lower, touching, closely)
                if verdict != "stable":
                    self.changes_order_once(blocks if which is None else [None, *blocks], lower, upper, which)
                return
            except Refused:
                if closely:
                    raise


def resonances(oscillator, text, loops, lowest, highest):
    """That, where nothing is said not to be shown, every digit of these resonances is right, the hypotheses of Theorems 2.4 and
    2.5 hold, and none is left out. Coefficients are those of (omega - omega*)^2 in A - A_graz, along the motion at which a
    multiplier is 1 or -1."""
    rows = [((integer("p", row["p"], 1, 99), integer("n", row["n"], 0, 199)), row) for row in table(FILES[1], text, COLUMNS[1])]
    places = {(p, n): exact(Fraction(n, 2) if p == 1 else n + Fraction(1, 2 * p)) for p in loops for n in range(p == 1, 200)}
    omegas = {which: oscillator.omega_1 / nu for which, nu in places.items()}
    require(all(omega < lowest for (p, n), omega in omegas.items() if n == 199), "a window with so many resonances")
    within = {which for which, omega in omegas.items() if not (omega < lowest or omega > highest)}
    listed = collections.Counter(which for which, _ in rows)
    for which in sorted({*listed, *within}):
        require(listed[which] == (which in within), f"resonance p, n = {which}: listed {listed[which]} times, not {int(which in within)}")
    for (p, n), row in rows:
        nu = arb_series([places[p, n], 1])
        omega, once, whole = oscillator.omega_1 / nu, oscillator.free(nu, arb(1)), oscillator.free(nu, arb(p))
        delta, tau, sigma = norm(once)[0], 2 * real(once)[0], real(whole)[0]
        at_0, at_1 = (oscillator.conditions(p, nu, v + 0 * nu) for v in (0, 1))
        plus, minus = (at_0[0] - at_1[0])[0], (at_1[1] - at_0[1])[0]
        limits = (oscillator.motion(p, nu, oscillator.limit(p, nu, which)) for which in (0, 1))
        amplitudes = [oscillator.amplitude_square(nu, f).sqrt() for f in (arb_series([1]), *(f for f, _ in limits))]
        c_sn, c_pd = ((amplitude - amplitudes[0])[2] / omega[1] ** 2 for amplitude in amplitudes[1:])
        q = sigma * oscillator.e
        criticality = minus * (1 - q) * (1 + 3 * sigma + 3 * q + sigma * q)
        for name, value in zip(NUMBERS, (omega[0], amplitudes[0][0], plus, minus, c_sn, c_pd, criticality)):
            what, text = f"resonance p, n = {p, n}: {name}", row[name]
            if row["not_shown"] and text == "?":
                continue
            least, unit = exact(abs(decimal(what, text))), exact(Fraction(1, 10 ** len(text.partition(".")[2])))
            value = -value if text.startswith("-") else value
            require("e" not in text and least <= value <= least + unit, f"{what}: a digit is wrong")
        hypotheses = 0 < delta < 1 and -1 - delta < tau < 1 + delta and plus != 0 and minus != 0 and imag(whole)[1] != 0
        if not row["not_shown"]:
            require(hypotheses and (p == 1 or imag(once)[0] > 0), f"resonance p, n = {p, n}: hypotheses")
    return [which for which, row in rows if not row["not_shown"]], [which for which, row in rows if row["not_shown"]]


def checksum(text):
    total = 0
    for byte in text.encode():
        total = (total * 257 + byte) % (2**61 - 1)
    return total


def statement(text):
    """The texts and the numbers of the statement. Each is there once, the checksum last, and makes sense."""
    rows = [(row["name"], row["value"]) for row in table(FILES[0], text, COLUMNS[0])]
    count = collections.Counter(name for name, _ in rows)
    for name in [*count, *KEYS]:
        require(name in KEYS, f"{FILES[0]}: no number is called {name[:60]}")
        require(count[name] == 1, f"{FILES[0]}: {name} is given {count[name]} times")
    require([name for name, _ in rows] == list(KEYS), f"{FILES[0]}: not in the order {', '.join(KEYS)}")
    texts = dict(rows)
    zeta, epsilon, lowest, highest, low, high, width = numbers = [decimal(name, texts[name]) for name in KEYS[:7]]
    loops = [integer("loops", p, 1, 99) for p in texts["loops"].split(" ")]
    require(0 < zeta < 1, "zeta: not between 0 and 1")
    require(0 < epsilon <= 1, "epsilon: not positive and at most 1")
    require(0 < lowest < highest, "omega_lowest, omega_highest: not positive and increasing")
    require(0 <= low < high, "amplitude_lowest, amplitude: not from 0 on and increasing")
    require(0 < width <= (high - low) / 100, "width: not positive and at most a hundredth of the window's height")
    require(all(p < q for p, q in zip(loops, loops[1:])), "loops: not increasing")
    return texts, dict(zip(KEYS, (*numbers, loops, integer("points", texts["points"], 0), integer("checksum", texts["checksum"], 0))))


def expected(text):
    """What is expected of a statement, from a text like `zeta=0.02,loops=1 2 3`."""
    pairs = [pair.partition("=")[::2] for pair in text.split(",")]
    for name, value in pairs:
        require(name in KEYS[:-1], f"--expect {name[:60]}: the names are {', '.join(KEYS[:-1])}")
        require(sum(other == name for other, _ in pairs) == 1, f"--expect {name}: given twice")
    return {name: [integer("--expect loops", p) for p in value.split()] if name == "loops" else decimal(f"--expect {name}", value) for name, value in pairs}


def check(files, expect=()):
    """Checks a certificate and returns the statement that holds, in words."""
    texts, stated = statement(files[FILES[0]])
    whole = files[FILES[0]].partition("checksum")[0] + files[FILES[1]] + files[FILES[2]]
    require(checksum(whole) == stated["checksum"], "checksum: a file is not what it was taken of")
    for name in expect:
        require(stated[name] == expect[name], f"{name}: {texts[name]} is not what is expected")
    zeta, epsilon, *window, low, high, width = (exact(stated[name]) for name in KEYS[:7])
    oscillator, loops = Oscillator(zeta, epsilon), stated["loops"]
    shown, not_shown = resonances(oscillator, files[FILES[1]], loops, *window)
    lines = [Line(oscillator, row) for row in table(FILES[2], files[FILES[2]], COLUMNS[2])]
    require([line.p for line in lines] == sorted(line.p for line in lines), "p: not in order")
    require({line.p for line in lines} == set(loops), "p: not those that the statement is about")
    first, last = (oscillator.omega_1 / omega for omega in reversed(window))
    for p in loops:
        mine = [line for line in lines if line.p == p]
        require(all(a.right == b.left for a, b in zip(mine, mine[1:])), f"p = {p}: intervals that overlap or leave a gap")
        require(exact(mine[0].left) <= first and exact(mine[-1].right) >= last, f"p = {p}: the intervals do not cover the window")
    require(any(line.verdict != "undecided" for line in lines), "nothing is stated")
    shares, points = collections.Counter(), 0
    for line in lines:
        try:
            line.check(width, high)
            points += line.verdict in POINTS and line.is_in_window(width, window, (low, high))
        except FAILURES as why:
            raise Refused(f"p = {line.p}, nu = {float(line.left)}: {line.verdict}: {why}")
        shares[line.p, line.verdict] += line.right - line.left
    require(points == stated["points"], f"points: {points} are in the window, not {stated['points']}")
    called = lambda which: "; ".join(f"{p}, {n}" for p, n in which) or "none"
    return "\n".join([
        f"zeta = {texts['zeta']}, epsilon = {texts['epsilon']}, {texts['omega_lowest']} <= omega <= {texts['omega_highest']}, "
        f"{texts['amplitude_lowest']} <= A <= {texts['amplitude']}, p = {', '.join(map(str, loops))}:",
        f"Resonances p, n at which all hypotheses hold: {called(shown)}." + (f" NOT SHOWN: {called(not_shown)}." if not_shown else ""),
        *(f"p = {p}: {verdict:9} {float(share):.9f} of nu" for (p, verdict), share in sorted(shares.items())),
        f"Tubes around GZ curves are at most {texts['width']} of A wide.",
        f"Away from resonances, GZ curves that bound stable motion end or meet at {points} points of the window, and at no others"
        + " outside of `undecided` and `thin` lines" * any(verdict in ("undecided", "thin") for _, verdict in shares) + ".",
        f"All of this holds: {len(shown)} resonances and {len(lines)} lines were checked."])


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description="Checks a certificate and prints the statement that holds.")
    arguments.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).parent)
    arguments.add_argument("--expect", metavar="NAME=VALUE,...", help="refuse a statement that is not about these constants and this window")
    arguments = arguments.parse_args()
    try:
        expect = expected(arguments.expect) if arguments.expect else ()
        print(check({name: (arguments.folder / name).read_bytes().decode("latin-1") for name in FILES}, expect))
    except (*FAILURES, OSError) as why:
        sys.exit(f"refused: {why}")

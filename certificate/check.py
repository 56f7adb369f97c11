#!/usr/bin/env python3
"""Checks the certificate of Figure 7 without searching: every line is a few inequalities between balls of python-flint.

    pip install python-flint && python3 check.py [FOLDER]

../docs/proof.md says what each verdict states and why these inequalities prove it. Nothing here is taken from the program that
writes the certificate: motion is written with the matrix of the free oscillation, its stability with the saltation matrix.
"""
import csv, itertools, pathlib, sys
from fractions import Fraction
from flint import arb, arb_series, ctx

ctx.prec, ctx.cap = 140, 4
TURNS_TO_ANGLE = 2 * arb.pi()


class Refused(Exception):
    pass


FILES = ("statement.csv", "resonances.csv", "rows.csv")
FAILURES = (Refused, KeyError, ValueError, IndexError, ZeroDivisionError)


def require(condition, what):
    if not condition:
        raise Refused(what)


def exact(text):
    value = Fraction(text)
    return arb(value.numerator) / value.denominator


def about_zero(radius):
    return arb(0, radius)


def both(x, y):
    """The ball of all numbers of x and y."""
    return x.union(y)


class Oscillator:
    def __init__(self, zeta, epsilon):
        require(0 < zeta < 1 and epsilon > 0, "constants")
        self.zeta, self.e = zeta, epsilon
        self.omega_1 = (1 - zeta**2).sqrt()
        self.k = zeta / self.omega_1

    def free(self, nu, turns):
        """What the free oscillation does to (h, dh/dθ) in this many turns of the forcing."""
        decay = (-TURNS_TO_ANGLE * self.k * nu * turns).exp()
        sine, cosine = (2 * nu * turns).sin_cos_pi()
        skew = self.k * sine
        return (decay * (cosine + skew), decay * sine / nu,
                -decay * sine * nu * (1 + self.k**2), decay * (cosine - skew))

    def motion(self, p, nu, v):
        """The free part of motion with impact velocity v, by its jump at the impact: h(0), h'(0)."""
        m11, m12, m21, m22 = self.free(nu, arb(p))
        kick = -(1 + self.e) * v / ((1 - m11) * (1 - m22) - m12 * m21)
        return kick * m12, kick * (1 - m11)

    def conditions(self, p, nu, v):
        """v (1 + D - T) and v (1 + D + T): trace T and determinant D of the derivative."""
        m11, m12, m21, m22 = self.free(nu, arb(p))
        h, g = self.motion(p, nu, v)
        acceleration = h - 1 - 2 * self.k * nu * g - nu * nu * (1 + self.k**2) * h
        force = acceleration - 2 * self.k * nu * self.e * v
        trace = (1 + self.e) * m12 * force - self.e * v * (m11 + m22)
        whole = v + v * self.e**2 * (m11 * m22 - m12 * m21)
        return whole - trace, whole + trace

    def limit(self, p, nu, which):
        """The velocity at which a multiplier is 1 or -1: where the first or the second condition, linear in v, is zero."""
        at_0, at_1 = (self.conditions(p, nu, v + 0 * nu)[which] for v in (0, 1))
        return at_0 / (at_0 - at_1)

    def distance(self, nu, motion, turns):
        """-x, and its first three derivatives in θ; motion: h(0), h'(0)/ν + k h(0) and ε v + h'(0)."""
        h0, e0, swing = motion
        decay = (-TURNS_TO_ANGLE * self.k * nu * turns).exp()
        free_sine, free_cosine = (2 * nu * turns).sin_cos_pi()
        sine_half, cosine_half = turns.sin_cos_pi()
        sine, cosine = 2 * sine_half * cosine_half, 1 - 2 * sine_half * sine_half
        h = decay * (h0 * free_cosine + e0 * free_sine)
        free = [h, nu * (decay * (e0 * free_cosine - h0 * free_sine) - self.k * h)]
        for _ in range(2):
            free.append(-2 * self.k * nu * free[-1] - nu * nu * (1 + self.k**2) * free[-2])
        return (2 * sine_half * sine_half + h0 * cosine + swing * sine - free[0], (1 - h0) * sine + swing * cosine - free[1],
                (1 - h0) * cosine - swing * sine - free[2], -(1 - h0) * sine - swing * cosine - free[3])

    def grazing_square(self, nu):
        omega = self.omega_1 / nu
        return (1 - omega * omega) * (1 - omega * omega) + 4 * self.zeta**2 * omega * omega

    def amplitude_square(self, nu, motion):
        h0, _, swing = motion
        return self.grazing_square(nu) * ((1 - h0) * (1 - h0) + swing * swing)


class Line:
    """A line of the certificate; its functions of u = ν - base hold on the whole interval by Taylor's theorem."""

    def __init__(self, oscillator, row):
        self.o, self.row, self.p, self.base = oscillator, row, int(row["p"]), int(row["base"])
        left, level = int(row["left"]), int(row["level"])
        require(self.base in (0, 1, 2) and (self.base == 1 or self.p > 1), "base")
        self.left, self.right = Fraction(left, 2**level), Fraction(left + 1, 2**level)
        origin = Fraction(2 * left + self.base, 2 ** (level + 1))
        require(self.base == 1 or (2 * origin).denominator == 1, "only at a resonance of one loop the base is an end")
        self.origin, self.half = exact(origin), exact(Fraction(1, 2 ** (level + 1)))
        middle = exact(Fraction(2 * left + 1, 2 ** (level + 1)))
        self.all, self.open = middle + about_zero(self.half), []
        self.offset = self.all - self.origin
        self.series = [(arb_series([at, 1]), arb_series([at - self.origin, 1])) for at in (self.origin, self.all)]

    def number(self, name):
        return int(self.row[name])

    def witness(self, name, terms, less=None):
        """A polynomial in u, or the difference of two."""
        numbers = [self.number(f"{name}_{i}") - (self.number(f"{less}_{i}") if less else 0) for i in range(terms)]
        return lambda nu, u: sum((arb(n) * arb(2)**-64 * u**i for i, n in enumerate(numbers)), 0 * u)

    def range(self, functions, orders):
        """Over the interval; at a resonance divided by |u| to the power of each order, as often as it vanishes there."""
        at_origin, over_all = (functions(nu, u) for nu, u in self.series)
        ranges = []
        for near, far, order in zip(at_origin, over_all, orders):
            near, far = (list(x.coeffs()) + [arb(0)] * 4 for x in (near, far))
            order = 0 if self.base == 1 else order
            require(all(c == 0 and c.is_exact() for c in near[:order]), "does not vanish at the resonance")
            total = far[3]
            for c in reversed(near[order:3]):
                total = c + self.offset * total
            ranges.append(-total if self.base == 2 and order % 2 else total)
        return ranges

    def motion(self, velocity):
        def at(nu, u):
            v = velocity(nu, u)
            h, g = self.o.motion(self.p, nu, v)
            return h, g / nu + self.o.k * h, self.o.e * v + g
        return at

    def stable(self, velocity):
        low, high, v = self.range(lambda nu, u: (*self.o.conditions(self.p, nu, velocity(nu, u)), velocity(nu, u)), (1, 1, 1))
        require(low > 0 and high > 0 and v > 0, "not stable")

    def unstable(self, velocity):
        ends = lambda nu, u: (*self.o.conditions(self.p, nu, velocity(nu, u)),
                              *self.o.conditions(self.p, nu, 0 * u), velocity(nu, u))
        low, high, low_0, high_0, v = self.range(ends, (1,) * 5)
        require(v > 0 and (low < 0 and low_0 < 0 or high < 0 and high_0 < 0), "perhaps stable")

    def beyond(self, velocity, time, order=2):
        motion = self.motion(velocity)
        at = lambda nu, u: (self.o.distance(nu, motion(nu, u), time(nu, u))[0], time(nu, u))
        distance, time = self.range(at, (order, 0))
        require(distance < 0 and 0 < time < self.p, "not beyond the wall")

    def clear(self, lower, upper, touching=False):
        """That motion with velocities between these touches the wall in blocks of cells alone, once in each at most, and not at
        all with `lower`, unless it is `touching`. The blocks in which it may with `upper`."""
        n, start, end = (self.number(x) for x in ("cells", "start", "end"))
        blocks = [tuple(map(int, b.split(":"))) for b in self.row["blocks"].split(";") if b]
        require(0 < start < end < self.p * n, "cells")
        require(all(start <= first <= last < end for first, last, *_ in blocks), "block")
        in_block = {cell for first, last, *_ in blocks for cell in range(first, last + 1)}
        motion = [both(*x) for x in zip(*(self.range(self.motion(v), (0, 0, 0)) for v in (lower, upper)))]
        curvatures = {}
        for cell in range(self.p * n):
            middle = exact(Fraction(2 * cell + 1, 2 * n))
            value, slope, bend, _ = self.o.distance(self.all, motion, middle)
            third = self.o.distance(self.all, motion, middle + about_zero(arb(1) / (2 * n)))[3]
            r = about_zero(arb.pi() / n)
            curvature = bend + r * third
            if cell < start:
                require(slope + r * (bend + r * third / 2) > 0 or (cell == 0 and curvature > 0), "leaves")
            elif cell >= end:
                require(slope + r * (bend + r * third / 2) < 0 or (cell == self.p * n - 1 and curvature > 0), "returns")
            elif cell in in_block:
                require(curvature > 0, "curvature")
                curvatures[cell] = curvature
            else:
                require(value + r * (slope + r / 2 * (bend + r / 3 * third)) > 0, "cell")
        least = lambda block: [curvatures[cell] for cell in range(block[0], block[1] + 1)]
        require(touching or all(self.minimum_is_clear(lower, block, least(block), n) for block in blocks), "minimum")
        return n, [block for block in blocks if not self.minimum_is_clear(upper, block, least(block), n)]

    def minimum_is_clear(self, velocity, block, curvatures, n):
        first, last, *nearest = block
        motion, (t0, t1) = self.motion(velocity), (arb(x) * arb(2)**-64 for x in nearest)
        at = lambda nu, u: (*self.o.distance(nu, motion(nu, u), t0 + t1 * u)[:2], t0 + t1 * u)
        value, slope, time = self.range(at, (2, 1, 0))
        require(first <= time * n <= last + 1, "time of a block")
        return all(2 * value.lower() * curvature.lower() > slope.abs_upper() ** 2 for curvature in curvatures)

    def changes(self, velocity, block, n, rate):
        """How the distance from the wall changes with ν in a block, times a factor."""
        nu, motion, total = self.series[1][0], self.motion(velocity)(*self.series[1]), None
        for cell in range(block[0], block[1] + 1):
            time = exact(Fraction(2 * cell + 1, 2 * n)) + about_zero(arb(1) / (2 * n))
            change = self.o.distance(nu, motion, arb_series([time]))[0][1] * rate(time)
            total = change if total is None else both(total, change)
        return total

    def limit(self, nu, u):
        """The velocity at which a multiplier is 1, or -1 if that one is positive."""
        return self.o.limit(self.p, nu, 0 if self.o.free(self.all, arb(self.p))[1] < 0 else 1)

    def check(self, width, amplitude):
        verdict = self.row["verdict"]
        if self.base != 1:
            h, g = self.o.motion(self.p, self.origin, arb(1))
            motion = h, g / self.origin + self.o.k * h, self.o.e + g
            require(self.o.distance(self.origin, motion, arb(1))[1] != 0, "at the resonance motion may stay off the wall")
        lower, upper, touch = (lambda: self.witness("lower", 3)), (lambda: self.witness("upper", 3)), (lambda: self.witness("touch", 2))
        if verdict in ("tube", "double"):
            self.stable(lower())
            self.beyond(upper(), touch())
            # dA/dv is at most A_graz |(h(0), ε v + h'(0))/v|, since A = A_graz |(1 - h(0), ε v + h'(0))|.
            speed = lambda nu, u: self.motion(lambda *_: 1 + 0 * u)(nu, u)[::2]
            between = self.witness("upper", 3, "lower")
            wide = lambda nu, u: (self.o.grazing_square(nu) * sum(x * x for x in speed(nu, u)) * between(nu, u) ** 2,)
            require(self.range(wide, (0,))[0] < width**2, "the tube is wider than stated")
            n, self.open = self.clear(lower(), upper())
            require(len(self.open) == (1 if verdict == "tube" else 2), "in how many blocks the wall is touched")
            if verdict == "double":
                # The velocity at which motion touches the wall in a block: its inverse is the greatest psi/(1 - cos) there.
                one, two = (self.changes(lambda *_: 1, block, n, lambda time: 1 / (2 * (time.sin_pi() ** 2)))
                            for block in self.open)
                require(one < two or two < one, "contact changes perhaps more than once")
            self.open = [(Fraction(block[0], n), Fraction(block[1] + 1, n)) for block in self.open]
        elif verdict == "edge":
            self.stable(lower())
            self.clear(lower(), lower())
            square = lambda nu, u: (self.o.amplitude_square(nu, self.motion(lower())(nu, u)),)
            require(self.range(square, (0,))[0] > amplitude**2, "not beyond the window")
        elif verdict == "empty":
            self.unstable(upper())
            self.beyond(upper(), touch())
        elif verdict == "blocked":
            require(0 < self.number("turn") < self.p, "turn")
            self.beyond(lambda nu, u: 1 + 0 * u, lambda nu, u: self.number("turn") + 0 * u, 1)
        elif verdict == "crossing":
            require(self.range(lambda nu, u: (self.limit(nu, u),), (0,))[0] > 0 and self.o.free(self.all, arb(self.p))[1] != 0, "no limit")
            above = lambda nu, u: self.limit(nu, u) * (1 + arb(2) ** -12)
            n, self.open = self.clear(self.limit, above, True)
            require(len(self.open) == 1 and self.changes(self.limit, self.open[0], n, lambda time: 1) != 0, "crosses perhaps twice")
            self.beyond(above, lambda nu, u: (self.open[0][2] + self.open[0][3] * u) * arb(2) ** -64)
        else:
            require(verdict == "undecided" and self.row["reason"], "verdict")


def resonances(oscillator, text, loops, lowest, highest):
    """That, where nothing is said not to be shown, every digit of these resonances is right, the hypotheses of Theorems 2.4 and 2.5 hold, and none is left out.
    Coefficients are those of (omega - omega*)^2 in A - A_graz, along the motion at which a multiplier is 1 or -1."""
    rows = list(csv.DictReader(text.splitlines()))
    places = lambda p, n: arb(n) / 2 if p == 1 else n + arb(1) / (2 * p)
    omegas = {(p, n): oscillator.omega_1 / places(p, n) for p in loops for n in range(int(p == 1), 200)}
    require(all(omega < lowest for (p, n), omega in omegas.items() if n == 199), "a window with so many resonances")
    within = {which for which, omega in omegas.items() if not (omega < lowest or omega > highest)}
    require({(int(row["p"]), int(row["n"])) for row in rows} == within, "which resonances there are")
    for row in rows:
        if row["not_shown"]:
            continue
        p, n = int(row["p"]), int(row["n"])
        nu = arb_series([places(p, n), 1])
        omega, grazing = oscillator.omega_1 / nu, oscillator.grazing_square(nu).sqrt()
        (low_0, high_0), (low, high) = (oscillator.conditions(p, nu, v + 0 * nu) for v in (0, 1))
        plus, minus = (low_0 - low)[0], (high - high_0)[0]
        (a, b, c, d), whole = oscillator.free(nu[0], arb(1)), oscillator.free(nu, arb(p))
        delta, tau, sigma = a * d - b * c, a + d, whole[0][0]
        q = sigma * oscillator.e
        coefficients = []
        for which in (0, 1):
            h, g = oscillator.motion(p, nu, oscillator.limit(p, nu, which))
            swing = g + oscillator.e * oscillator.limit(p, nu, which)
            coefficients.append((oscillator.amplitude_square(nu, (h, None, swing)).sqrt() - grazing)[2] / omega[1]**2)
        proved = (omega[0], grazing[0], plus, minus, *coefficients, minus * (1 - q) * (1 + 3 * sigma + 3 * q + sigma * q))
        for name, value in zip(("omega_star", "amplitude_graz", "s_plus", "s_minus", "c_sn", "c_pd", "criticality"), proved):
            text = row[name]
            least, unit = abs(exact(text)), exact(Fraction(1, 10 ** len(text.partition(".")[2])))
            value = -value if text.startswith("-") else value
            require(least <= value <= least + unit, f"p = {p}, n = {n}: {name}")
        hypotheses = 0 < delta < 1 and -1 - delta < tau < 1 + delta and plus != 0 and minus != 0 and whole[1][1] != 0
        require(hypotheses and (p == 1 or b > 0), f"p = {p}, n = {n}: hypotheses")
    return sum(not row["not_shown"] for row in rows)


def checksum(text):
    total = 0
    for byte in text.encode():
        total = (total * 257 + byte) % (2**61 - 1)
    return total


def points_of(lines):
    """For each group of crossings, or of doubles, whether exactly one point is in it. There are one or two side by side, with
    one change at most in each: of the sign of v_GZ - v_min, or of which time of contact comes first as v increases."""
    kinds = {"tube": "some", "double": "some", "edge": "some", "empty": "none", "blocked": "none"}
    apart = lambda a, b: a[1] < b[0] or b[1] < a[0]
    groups = [(verdict, list(group)) for verdict, group in itertools.groupby(lines, lambda line: line.row["verdict"])]
    for (_, before), (verdict, group), (_, after) in zip(groups, groups[1:], groups[2:]):
        before, after = before[-1], after[0]
        if verdict == "crossing":
            yield len(group) <= 2 and {kinds.get(line.row["verdict"]) for line in (before, after)} == {"some", "none"}
        if verdict == "double":
            first, last, side = group[0].open, group[-1].open, [x.open[0] if len(x.open) == 1 else None for x in (before, after)]
            yield len(group) <= 2 and None not in side and apart(first[0], last[1]) and apart(first[1], last[0]) and any(
                apart(side[0], first[two]) and apart(side[1], last[1 - two]) for two in (0, 1))


def check(files):
    stated, resonances_text, rows_text = (files[name] for name in FILES)
    statement = dict(csv.reader(stated.splitlines()))
    whole = stated[:stated.rindex("checksum")] + resonances_text + rows_text
    require(checksum(whole) == int(statement["checksum"]), "a file is not what the checksum was taken of")
    oscillator = Oscillator(exact(statement["zeta"]), exact(statement["epsilon"]))
    loops, window = list(map(int, statement["loops"].split())), [exact(statement[f"omega_{x}"]) for x in ("lowest", "highest")]
    shown = resonances(oscillator, resonances_text, loops, *window)
    lines = [Line(oscillator, row) for row in csv.DictReader(rows_text.splitlines())]
    shares, passed, points = {}, 0, 0
    for p in loops:
        mine = [line for line in lines if line.p == p]
        require(exact(mine[0].left) <= oscillator.omega_1 / exact(statement["omega_highest"]), "window")
        require(exact(mine[-1].right) >= oscillator.omega_1 / exact(statement["omega_lowest"]), "window")
        require(all(a.right == b.left for a, b in zip(mine, mine[1:])), "a gap")
        for line in mine:
            try:
                line.check(exact(statement["width"]), exact(statement["amplitude"]))
            except Refused as why:
                raise Refused(f"p = {p}, nu = {float(line.left)}: {line.row['verdict']}: {why}")
            verdict = line.row["verdict"]
            shares[p, verdict] = shares.get((p, verdict), 0) + (line.right - line.left)
            passed += 1
        points += sum(points_of(mine))
    require(points == int(statement["points"]), "how many points there are")
    require(passed == len(lines), "lines of other p")
    return shown, passed, points, shares


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    try:
        shown, passed, points, shares = check({name: (folder / name).read_text() for name in FILES})
    except FAILURES as why:
        sys.exit(f"refused: {why}")
    for (p, verdict), share in sorted(shares.items()):
        print(f"p = {p}: {verdict:9} {float(share):.9f} of nu")
    print(f"{shown} resonances and {passed} lines hold, with {points} points where GZ curves end or meet, and no others but where nothing is stated")

#!/usr/bin/env python3
"""Checks the certificate of Figure 7 without searching: every line is a few inequalities between balls of python-flint.

    pip install python-flint && python3 check.py [FOLDER]

../../docs/proof.md says what each verdict states and why these inequalities prove it. Nothing here is taken from the program that
writes the certificate: motion is the real part of two complex exponentials, its stability that of the saltation matrix.
"""
import collections, csv, pathlib, sys
from fractions import Fraction
from flint import acb, acb_series, arb, arb_series, ctx

ctx.prec, ctx.cap = 140, 4
I, PI, UNIT = acb(0, 1), arb.pi(), arb(2) ** -64
FILES = ("statement.csv", "resonances.csv", "rows.csv")
# At how many times motion touches the wall, at which of the two conditions its stability begins or ends, and which.
POINTS = {"SN-GZ": (1, 0, "begins"), "PD-GZ": (1, 1, "begins"), "GZ-PD": (1, 1, "ends"), "GZ-GZ": (2, None, None)}
Block = collections.namedtuple("Block", "first last time curvature cells")


class Refused(Exception):
    pass


FAILURES = (Refused, KeyError, ValueError, IndexError, ZeroDivisionError, TypeError)


def require(condition, what):
    if not condition:
        raise Refused(what)


def exact(number):
    value = Fraction(number)
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
        require(0 < zeta < 1 and 0 < epsilon <= 1, "constants")
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
        self.o, self.row, self.p, self.base = oscillator, row, int(row["p"]), int(row["base"])
        left, scale = int(row["left"]), 2 ** int(row["level"])
        self.left, self.right, origin = (Fraction(2 * left + i, 2 * scale) for i in (0, 2, self.base))
        require(self.base == 1 or self.base in (0, 2) and self.p > 1 and (2 * origin).denominator == 1, "base")
        self.origin, self.all = exact(origin), exact(self.left).union(exact(self.right))

    def range(self, functions, orders):
        """At a resonance divided by |nu - base| to the power of each order, as often as a function vanishes there."""
        near_and_far = zip(*(functions(arb_series([nu, 1])) for nu in (self.origin, self.all)))
        for (near, far), order in zip(near_and_far, orders):
            near, far = (list(x.coeffs()) + [arb(0)] * 4 for x in (near, far))
            order = 0 if self.base == 1 else order
            require(all(c == 0 and c.is_exact() for c in near[:order]), "does not vanish at the resonance")
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
        require(distance < 0 and v > 0 and 0 < time < self.p, "not beyond the wall")

    def blocks(self, lower, upper, touching):
        """That motion with velocities between these touches the wall in none but the first blocks of cells, so many, once in each
        at most, and with `lower` in none."""
        n, start, end = (int(self.row[x]) for x in ("cells", "start", "end"))
        blocks = [tuple(map(int, b.split(":"))) for b in self.row["blocks"].split(";") if b]
        require(0 < start < end < self.p * n and all(start <= b[0] <= b[1] < end for b in blocks), "cells")
        parts = lambda v: self.range(lambda nu: [part(x) for x in self.motion(nu, v) for part in (real, imag)], (0,) * 4)
        f, f_imag, h, h_imag = (x.union(y) for x, y in zip(parts(lower), parts(upper)))
        motion, r, curvatures = (acb(f, f_imag), acb(h, h_imag)), arb(0, PI / n), []
        for cell in range(self.p * n):
            middle = exact(Fraction(2 * cell + 1, 2 * n))
            near = [self.o.distance(self.all, motion, middle, order)[0] for order in range(3)]
            third = self.o.distance(self.all, motion, middle + arb(0, arb(1) / (2 * n)), 3)[0]
            slope, curvature = near[1] + r * (near[2] + r * third / 2), near[2] + r * third
            curvatures.append(curvature.lower())
            if cell < start:
                require(slope > 0 or (cell == 0 and curvature > 0), "leaves")
            elif cell >= end:
                require(slope < 0 or (cell == self.p * n - 1 and curvature > 0), "returns")
            elif not any(b[0] <= cell <= b[1] for b in blocks):
                require(near[0] + r * (near[1] + r * (near[2] + r * third / 3) / 2) > 0, "cell")
        blocks = [Block(b[0], b[1], self.polynomial(b[2:]), min(curvatures[b[0]:b[1] + 1]), n) for b in blocks]
        require(len(blocks) >= touching and all(self.minimum(lower, b)[0] > 0 for b in blocks), "minimum at lower")
        require(all(self.minimum(upper, b)[0] > 0 for b in blocks[touching:]), "minimum at upper")
        return blocks[:touching]

    def minimum(self, velocity, block, end=None):
        """The least distance in a block is at least f - g^2/(2 mu), at a time no farther than |g|/mu away."""
        def functions(nu):
            motion, time = self.motion(nu, velocity), block.time(nu)
            return self.o.distance(nu, motion, time), self.o.distance(nu, motion, time, 1), velocity(nu), time
        at_end = () if end is None else (x[0] for x in functions(arb_series([exact(end), 1])))
        f, g, v, time = at_end or self.range(functions, (2, 1, 1, 0))
        require(v > 0 and block.curvature > 0 and block.first <= time * block.cells <= block.last + 1, "block")
        return (f - g.abs_upper() ** 2 / (2 * block.curvature)).lower(), time + arb(0, g.abs_upper() / (2 * PI * block.curvature))

    def ratio(self, nu, time):
        """psi/(1 - cos): the inverse of the velocity at which motion touches the wall at a time."""
        rise, distance = (self.o.distance(nu, self.motion(nu, lambda nu: v + 0 * nu), time) for v in (0, 1))
        return (rise - distance) / rise

    def changes_order_once(self, events, lower, upper, which):
        """That at exactly one nu two events come at the same velocity: that stability begins or ends (None), and contact in blocks,
        whose curvatures are those of motion with velocities up to `upper`."""
        limit = lambda nu: self.o.limit(self.p, nu, which)
        ratio = lambda nu, event, time: 1 / limit(nu) if event is None else self.ratio(nu, time)
        rates = []
        for event in events:
            time = event and self.minimum(lower, event)[1].union(self.minimum(upper, event)[1])
            rates.append(ratio(arb_series([self.all, 1]), event, arb_series([time]) if event else None)[1])
        require(rates[0] < rates[1] or rates[0] > rates[1], "perhaps more than once")

        def comes_first(one, two, end):
            nu = arb_series([exact(end), 1])
            if two:
                velocity = lambda nu: 1 / ratio(nu, one, one and one.time(nu))
                return (upper(nu) - velocity(nu))[0] > 0 and self.minimum(velocity, two, end)[0] > 0
            return self.o.distance(nu, self.motion(nu, limit), one.time(nu))[0] < 0 and limit(nu)[0] > 0
        orders = [[comes_first(*pair, end) for pair in (events, events[::-1])] for end in (self.left, self.right)]
        require(sorted(orders) == [[False, True], [True, False]], "perhaps not once")

    def check(self, width, amplitude):
        verdict = self.row["verdict"]
        if verdict == "undecided":
            return require(self.row["reason"], "no reason")
        if self.base != 1:
            motion = self.o.motion(self.p, self.origin, arb(1))
            require(self.o.distance(self.origin, motion, arb_series([1]), 1)[0] != 0, "at the resonance motion may stay off the wall")
        witnesses = {name: [int(self.row[f"{name}_{i}"]) for i in range(terms)] if self.row[f"{name}_0"] else None
                     for name, terms in (("lower", 3), ("upper", 3), ("touch", 2))}
        lower, upper, touch = (numbers and self.polynomial(numbers) for numbers in witnesses.values())
        if upper and touch:
            self.beyond(upper, touch)
        beyond_window = lambda v: next(self.range(lambda nu: (self.o.amplitude_square(nu, self.motion(nu, v)[0]),), (0,))) > amplitude**2
        at_0 = self.conditions(lambda nu: 0 * nu)
        if verdict == "none":
            if upper:
                at_upper = self.conditions(upper)
                require(any(x < 0 and y < 0 for x, y in zip(at_upper, at_0)), "perhaps stable")
                require(touch or (at_upper[0] > 0 and beyond_window(upper)), "perhaps admissible")
            else:
                require(witnesses["touch"][0] % 2**64 == 0 == witnesses["touch"][1], "not a whole turn")
                self.beyond(lambda nu: 1 + 0 * nu, touch, 1)
            return
        touching, which, change = POINTS[verdict] if verdict != "stable" else (1 if upper else 0, None, None)
        low, high = self.conditions(lower)
        if upper:
            require(touch, "no time of contact")
            require(change == "begins" or (low > 0 and high > 0), "not stable")
            require(verdict in ("PD-GZ", "GZ-PD") or self.conditions(upper)[1] > 0, "perhaps not stable up to the wall")
            require(not change or (at_0[which] < 0 if change == "begins" else at_0[which] > 0), "where stability changes")
            between = self.polynomial([a - b for a, b in zip(witnesses["upper"], witnesses["lower"])])
            wide = lambda nu: (self.o.amplitude_square(nu, self.motion(nu, between)[0] - 1),)
            require(next(self.range(wide, (0,))) < width**2, "the tube is wider than stated")
        else:
            # From where the first condition holds on to where the second fails, or to amplitudes beyond the window.
            require(verdict == "stable" and low > 0 and (high > 0 or at_0[0] < 0), "where stability begins")
            require((high < 0 and at_0[0] < 0) or beyond_window(lower), "where stable motion ends")
        blocks = self.blocks(lower, upper or lower, touching)
        if verdict != "stable":
            self.changes_order_once(blocks if which is None else [None, *blocks], lower, upper, which)


def resonances(oscillator, text, loops, lowest, highest):
    """That, where nothing is said not to be shown, every digit of these resonances is right, the hypotheses of Theorems 2.4 and
    2.5 hold, and none is left out. Coefficients are those of (omega - omega*)^2 in A - A_graz, along the motion at which a
    multiplier is 1 or -1."""
    rows = list(csv.DictReader(text.splitlines()))
    places = {(p, n): exact(Fraction(n, 2) if p == 1 else n + Fraction(1, 2 * p)) for p in loops for n in range(p == 1, 200)}
    omegas = {which: oscillator.omega_1 / nu for which, nu in places.items()}
    require(all(omega < lowest for (p, n), omega in omegas.items() if n == 199), "a window with so many resonances")
    within = {which for which, omega in omegas.items() if not (omega < lowest or omega > highest)}
    require({(int(row["p"]), int(row["n"])) for row in rows} == within, "which resonances there are")
    for row in rows:
        if row["not_shown"]:
            continue
        p, n = int(row["p"]), int(row["n"])
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
        names = ("omega_star", "amplitude_graz", "s_plus", "s_minus", "c_sn", "c_pd", "criticality")
        for name, value in zip(names, (omega[0], amplitudes[0][0], plus, minus, c_sn, c_pd, criticality)):
            text = row[name]
            least, unit = abs(exact(text)), exact(Fraction(1, 10 ** len(text.partition(".")[2])))
            value = -value if text.startswith("-") else value
            require(least <= value <= least + unit, f"p = {p}, n = {n}: {name}")
        hypotheses = 0 < delta < 1 and -1 - delta < tau < 1 + delta and plus != 0 and minus != 0 and imag(whole)[1] != 0
        require(hypotheses and (p == 1 or imag(once)[0] > 0), f"p = {p}, n = {n}: hypotheses")
    return sum(not row["not_shown"] for row in rows)


def checksum(text):
    total = 0
    for byte in text.encode():
        total = (total * 257 + byte) % (2**61 - 1)
    return total


def check(files):
    stated, resonances_text, rows_text = (files[name] for name in FILES)
    statement = dict(csv.reader(stated.splitlines()))
    whole = stated[:stated.rindex("checksum")] + resonances_text + rows_text
    require(checksum(whole) == int(statement["checksum"]), "a file is not what the checksum was taken of")
    oscillator = Oscillator(exact(statement["zeta"]), exact(statement["epsilon"]))
    loops, window = list(map(int, statement["loops"].split())), [exact(statement[f"omega_{x}"]) for x in ("lowest", "highest")]
    shown = resonances(oscillator, resonances_text, loops, *window)
    lines = [Line(oscillator, row) for row in csv.DictReader(rows_text.splitlines())]
    require([line.p for line in lines] == sorted(line.p for line in lines) and {line.p for line in lines} == set(loops), "loops")
    for p in loops:
        mine = [line for line in lines if line.p == p]
        require(all(a.right == b.left for a, b in zip(mine, mine[1:])), "a gap")
        first, last = (oscillator.omega_1 / omega for omega in reversed(window))
        require(exact(mine[0].left) <= first and exact(mine[-1].right) >= last, "window")
    shares = collections.Counter()
    for line in lines:
        try:
            line.check(exact(statement["width"]), exact(statement["amplitude"]))
        except Refused as why:
            raise Refused(f"p = {line.p}, nu = {float(line.left)}: {line.row['verdict']}: {why}")
        shares[line.p, line.row["verdict"]] += line.right - line.left
    points = sum(line.row["verdict"] in POINTS for line in lines)
    require(points == int(statement["points"]), "how many points there are")
    return shown, len(lines), points, shares


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    try:
        shown, passed, points, shares = check({name: (folder / name).read_text() for name in FILES})
    except FAILURES as why:
        sys.exit(f"refused: {why}")
    for (p, verdict), share in sorted(shares.items()):
        print(f"p = {p}: {verdict:9} {float(share):.9f} of nu")
    print(f"{shown} resonances and {passed} lines hold; points away from resonances where GZ curves that bound stable motion end or meet: {points}, no others in the window but where nothing is stated")

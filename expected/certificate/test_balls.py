#!/usr/bin/env python3
"""Tests the balls that the certificate was made with, against two libraries that know nothing of them.

    pip install python-flint mpmath
    cargo run -p grazing-certify --example balls -- 1000000 | python3 test_balls.py

Each line has an operation, its arguments and its result. At four places of an argument, its ends among them, the value by
python-flint, and at its middle that by mpmath, must lie in the result.
"""
import collections, sys
import mpmath
from flint import arb, ctx, fmpz

ctx.prec, mpmath.mp.prec = 400, 300
SLACK = arb(2)**-250
FLINT = {"sin": lambda x, y: (2 * x).sin_pi(), "cos": lambda x, y: (2 * x).cos_pi(), "exp": lambda x, y: x.exp(),
         "inverse": lambda x, y: 1 / x, "sqrt": lambda x, y: x.sqrt(), "add": lambda x, y: x + y, "sub": lambda x, y: x - y,
         "mul": lambda x, y: x * y}
MPMATH = {"sin": lambda x, y: mpmath.sinpi(2 * x), "cos": lambda x, y: mpmath.cospi(2 * x), "exp": lambda x, y: mpmath.exp(x),
          "inverse": lambda x, y: 1 / x, "sqrt": lambda x, y: mpmath.sqrt(x), "add": lambda x, y: x + y, "sub": lambda x, y: x - y,
          "mul": lambda x, y: x * y}
UNIT = arb(2)**-88
known, unknown = collections.Counter(), collections.Counter()
for line in sys.stdin:
    name, *balls = line.rstrip("\n").split(";")
    if "-" in balls[:2]:
        continue
    if balls[2] == "-":
        unknown[name] += 1
        continue
    (a, r), (b, s), (c, t) = (map(int, ball.split()) for ball in balls)
    known[name] += 1
    for share in (-7, 0, 3, 7):
        x, y = (arb(fmpz(7 * m + share * w)) * UNIT / 7 for m, w in ((a, r), (b, s)))
        distance = abs(FLINT[name](x, y) / UNIT - fmpz(c))
        # Only what is certainly outside is wrong: flint's own error is far below the slack.
        if not distance <= arb(fmpz(t)) + SLACK * (1 + distance):
            sys.exit(f"not in the ball: {line}")
    value = MPMATH[name](*(mpmath.ldexp(m, -88) for m in (a, b)))
    if not abs(mpmath.ldexp(value, 88) - c) <= t + mpmath.ldexp(1 + abs(value), -100):
        sys.exit(f"not in the ball, by mpmath: {line}")
for name in FLINT:
    print(f"{name}: {known[name]} balls hold, {unknown[name]} are unknown")
    assert known[name] > unknown[name] / 4, "nearly nothing is known"

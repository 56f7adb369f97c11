"use strict";
// What axes on a sheet and on a canvas have in common: round steps, numbers as they are written, what of a line is seen.

const Scales = {
  /** A round step of which about so many fit into a length, the parts into which it is divided, and the decimals of its multiples. */
  roundStep(length, most) {
    const least = length / most;
    const power = 10 ** Math.floor(Math.log10(least));
    const factor = [1, 2, 5, 10].find((each) => each * power >= least * 0.999) ?? 10;
    const step = factor * power;
    return { step, parts: factor === 2 ? 4 : 5, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
  },

  /** A number at an axis. */
  written: (value, decimals) => value.toFixed(decimals).replace(/^-(?=[0.]*$)/, "").replace("-", "−"),

  /** Between which shares of itself a segment lies in a box, or null. */
  within([ax, ay], [bx, by], [left, top, right, bottom]) {
    let [from, to] = [0, 1];
    for (const [p, d, low, high] of [[ax, bx - ax, left, right], [ay, by - ay, top, bottom]]) {
      if (d === 0 && (p < low || p > high)) return null;
      if (d === 0) continue;
      const [a, b] = [(low - p) / d, (high - p) / d];
      from = Math.max(from, Math.min(a, b));
      to = Math.min(to, Math.max(a, b));
    }
    return from <= to ? [from, to] : null;
  },
};

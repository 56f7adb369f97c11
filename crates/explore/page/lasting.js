// Names that last. Curves that leave a resonance are known by it; others are numbered as they are found, anew in each
// diagram, and some come and go. Here each gets the number that the nearest of its kind had before.

const SAMPLES = 24;
/** The distance, as a share of the view, beyond which two curves are not the same. */
const FARTHEST = 0.25;
/** The weight of the parts of one curve that the other lacks: views cut curves, and curves grow. */
const REST = 0.1;

/** The mean distance of points of one polyline from another. */
function way(from, to, [across, up]) {
  const stride = Math.ceil(from.length / SAMPLES);
  const sampled = from.filter((_, index) => index % stride === 0);
  const far = ([p, s]) => to.reduce((least, [op, os]) => Math.min(least, Math.hypot((p - op) / across, (s - os) / up)), Infinity);
  return sampled.reduce((sum, point) => sum + far(point), 0) / sampled.length;
}

function apart(a, b, widths) {
  const ways = [way(a.points, b.points, widths), way(b.points, a.points, widths)];
  return Math.min(...ways) + REST * Math.max(...ways);
}

/** Whether a curve is known only by a number. */
export const isNumbered = ({ n, source }) => n === 0 && source === "continuation";

/**
 * The names of the numbered curves of a list, by their keys there; `before` are the curves of the last diagram, with
 * their names.
 */
export function lasting(list, before, { primary: [a, b], secondary: [c, d] }) {
  const names = new Map();
  const curves = list.filter(isNumbered);
  const pairs = curves.flatMap((curve) => before.filter(({ group }) => group === curve.group).map((old) => ({ curve, old, far: apart(curve, old, [b - a, d - c]) })));
  const taken = new Set();
  for (const { curve, old, far } of pairs.sort((one, other) => one.far - other.far)) {
    if (far > FARTHEST || names.has(curve.key) || taken.has(old.key)) continue;
    names.set(curve.key, old.key);
    taken.add(old.key);
  }
  // New curves do not take the number of one that has gone.
  for (const old of before) taken.add(old.key);
  for (const curve of curves) {
    if (names.has(curve.key)) continue;
    let number = 0;
    while (taken.has(`${curve.group}#${number}`)) number += 1;
    names.set(curve.key, `${curve.group}#${number}`);
    taken.add(`${curve.group}#${number}`);
  }
  return names;
}

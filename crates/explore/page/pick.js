// The parts of the diagram under a pointer.
import { count, multipliers } from "./dom.js";
import { diagram } from "./diagram.js";
import { LOOKS } from "./kinds.js";
import { tellMeasured } from "./measured.js";

/** The distance of a point from a segment. */
export function apart([x, y], [ax, ay], [bx, by]) {
  const square = (bx - ax) ** 2 + (by - ay) ** 2;
  const part = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square));
  return Math.hypot(x - ax - part * (bx - ax), y - ay - part * (by - ay));
}

/** The curve within a number of pixels of a point, among the runs that were drawn, or null. */
function curveAt(runs, x, y, within = 7) {
  let best = { distance: within, curve: null };
  for (const { curve, points } of runs) {
    for (let index = 1; index < points.length; index += 1) {
      const distance = apart([x, y], points[index - 1], points[index]);
      if (distance < best.distance) best = { distance, curve };
    }
  }
  return best.curve;
}

/** Whether a place lies inside rings, by the even-odd rule. */
function lies([p, s], rings) {
  let inside = false;
  for (const ring of rings) {
    ring.forEach(([bp, bs], index) => {
      const [ap, as] = ring[(index + ring.length - 1) % ring.length];
      if (as > s !== bs > s && p < ap + ((bp - ap) * (s - as)) / (bs - as)) inside = !inside;
    });
  }
  return inside;
}

/** The greatest distance in pixels from which a place can be moved onto something. */
const ONTO = 14;

/**
 * The point of the diagram, or else the place on a curve, nearest to a place, if one is near: { point } or { curve, at,
 * start }.
 */
export function nearest(place, to) {
  const here = to(place);
  const far = ({ primary, secondary }) => Math.hypot(...to([primary, secondary]).map((each, k) => each - here[k]));
  const point = [...diagram.points].sort((a, b) => far(a) - far(b))[0];
  if (point && far(point) < ONTO) return { point };
  let best = { distance: ONTO };
  for (const curve of diagram.curves.values()) {
    if (!curve.starts || curve.source === "quadratic") continue;
    const pixels = curve.points.map(to);
    for (let index = 1; index < pixels.length; index += 1) {
      const distance = apart(here, pixels[index - 1], pixels[index]);
      if (distance < best.distance) best = { distance, curve, index, ends: [pixels[index - 1], pixels[index]] };
    }
  }
  if (!best.curve) return null;
  const { curve, index, ends: [a, b] } = best;
  const square = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2;
  const part = square === 0 ? 0 : Math.min(1, Math.max(0, ((here[0] - a[0]) * (b[0] - a[0]) + (here[1] - a[1]) * (b[1] - a[1])) / square));
  const between = (list) => [0, 1].map((k) => list[index - 1][k] + part * (list[index][k] - list[index - 1][k]));
  return { curve, at: between(curve.points), start: between(curve.starts) };
}

const loops = ({ p, n }) => (p > 0 ? `, ${count(p, "loop")}${n ? `, n = ${n}` : ""}` : "");

/** The multipliers at the point of a curve nearest to a pixel. */
function along(curve, [x, y], to) {
  if (!curve.multipliers) return "";
  const far = curve.points.map(to).map(([px, py]) => Math.hypot(px - x, py - y));
  return `, multipliers ${multipliers(curve.multipliers[far.indexOf(Math.min(...far))])}`;
}

/**
 * A description of what lies at a pixel and its place; empty if there is nothing. `ends` are those where curves were
 * not followed farther.
 */
export function tellOf(runs, ends, [x, y], place, to) {
  const near = diagram.points.find(({ primary, secondary }) => {
    const [px, py] = to([primary, secondary]);
    return Math.hypot(px - x, py - y) < 9;
  });
  const measured = tellMeasured([x, y], to);
  if (measured) return measured;
  if (near) return (near.kind === "resonance" ? "resonance" : `${near.kind} point`) + loops(near);
  const end = ends.find(({ at }) => Math.hypot(to(at)[0] - x, to(at)[1] - y) < 6);
  if (end) return `could not be followed further: ${end.why}`;
  const curve = curveAt(runs, x, y);
  if (curve) return curve.tells ?? `${curve.source === "quadratic" ? `quadratic ${curve.kind}` : curve.name ? `${curve.name}, ${curve.property}` : LOOKS[curve.kind].meaning}${loops(curve)}${along(curve, [x, y], to)}`;
  const undecided = diagram.regions.find(({ kind, rings }) => kind === "undecided" && lies(place, rings));
  return undecided ? `undecided${undecided.reason ? `: ${undecided.reason}` : ""}` : "";
}

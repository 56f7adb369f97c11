// The places of labels in the plane: away from curves, points and other labels.
import { apart } from "./pick.js";

const CELL = 5;

/** The map of free space: the distance of each cell from the nearest curve, point or edge. */
function distances(frame, runs, points) {
  const [columns, rows] = [Math.max(1, Math.floor(frame.w / CELL)), Math.max(1, Math.floor(frame.h / CELL))];
  const far = new Float32Array(columns * rows).fill(1e9);
  const take = (x, y) => {
    const [column, row] = [Math.floor((x - frame.x) / CELL), Math.floor((y - frame.y) / CELL)];
    if (column >= 0 && column < columns && row >= 0 && row < rows) far[row * columns + column] = 0;
  };
  for (const { points: run } of runs) {
    for (let index = 1; index < run.length; index += 1) {
      const [[ax, ay], [bx, by]] = [run[index - 1], run[index]];
      const steps = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / (CELL / 2)));
      for (let step = 0; step <= steps; step += 1) take(ax + ((bx - ax) * step) / steps, ay + ((by - ay) * step) / steps);
    }
  }
  for (const [x, y] of points) for (const dx of [-4, 0, 4]) for (const dy of [-4, 0, 4]) take(x + dx, y + dy);
  for (let column = 0; column < columns; column += 1) far[column] = far[(rows - 1) * columns + column] = 0;
  for (let row = 0; row < rows; row += 1) far[row * columns] = far[row * columns + columns - 1] = 0;
  const pass = (order, neighbours) => {
    for (const cell of order) for (const [step, by] of neighbours) if (far[cell + step] + by < far[cell]) far[cell] = far[cell + step] + by;
  };
  const inner = [];
  for (let row = 1; row < rows - 1; row += 1) for (let column = 1; column < columns - 1; column += 1) inner.push(row * columns + column);
  pass(inner, [[-1, 1], [-columns, 1], [-columns - 1, 1.4], [-columns + 1, 1.4]]);
  pass(inner.reverse(), [[1, 1], [columns, 1], [columns + 1, 1.4], [columns - 1, 1.4]]);
  const at = (x, y) => {
    const [column, row] = [Math.floor((x - frame.x) / CELL), Math.floor((y - frame.y) / CELL)];
    return column < 0 || column >= columns || row < 0 || row >= rows ? 0 : CELL * far[row * columns + column];
  };
  return { at };
}

/** Whether a label of this width about a point keeps clear of everything. */
const clear = (map, placed, x, y, half, tall = 7) => {
  for (let dx = -half; dx <= half; dx += CELL) if (Math.min(map.at(x + dx, y - tall + 2), map.at(x + dx, y + tall - 2)) < 5) return false;
  return placed.every((other) => Math.abs(other.x - x) > other.half + half + 4 || Math.abs(other.y - y) > 2 * tall + 2);
};

const sheet = document.createElement("canvas").getContext("2d");
const isInside = (path, x, y) => sheet.isPointInPath(path, x, y, "evenodd");
function pathOf({ rings }) {
  const path = new Path2D();
  for (const ring of rings) ring.forEach(([x, y], index) => (index === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  return path;
}

/** The label of a region: p, or with several impacts K/P; none where nothing is stable for sure. */
function nameOf(region) {
  if (region.kind === "mps") return [["p", "italic"], [` = ${region.p}`, ""]];
  return region.kind === "several-impacts" ? [[region.name, ""]] : null;
}

/** Regions with labels, each with the number by which its labels are known. */
const named = (regions) => regions.filter(nameOf).map((region) => ({ ...region, p: region.name ?? region.p, text: nameOf(region) }));

/**
 * The labels p = ... of regions: each at the place that is farthest from everything, outside other regions if possible.
 */
function regionLabels(frame, regions, map, placed) {
  const paths = regions.map(pathOf);
  const inside = (index, x, y) => isInside(paths[index], x, y);
  const step = 2 * CELL;
  regions.forEach((region, index) => {
    if (placed.some(({ kind, p, x, y }) => kind === "region" && p === region.p && inside(index, x, y))) return;
    let best = { score: 0 };
    for (let x = frame.x + 24; x < frame.x + frame.w - 24; x += step) {
      for (let y = frame.y + 10; y < frame.y + frame.h - 10; y += step) {
        const room = map.at(x, y);
        if (room < 9 || room <= best.score || !inside(index, x, y) || !clear(map, placed, x, y, 20)) continue;
        const others = regions.filter((other, at) => at !== index && other.p !== region.p && inside(at, x, y)).length;
        const score = room / (1 + 3 * others);
        if (score > best.score) best = { score, x, y };
      }
    }
    if (best.score > 0) placed.push({ text: region.text, x: best.x, y: best.y, half: 20, kind: "region", p: region.p });
  });
}

/** The label of a curve, with its number of loops as index. */
const wordOf = ({ kind, p, name, followed }) => (kind === "graz" ? [["grazing", ""]] : [[name ?? kind, ""], ...(followed ? [] : [[String(p), "sub"]])]);
const sameWord = (text, other) => text.join() === other.join();

/** The distance in pixels, beyond its own width, within which a label belongs to its curve. */
const REACH = 30;

const reaches = ({ points }, { x, y, half }) => points.some(([px, py], at) => at > 0 && apart([x, y], points[at - 1], [px, py]) < half + REACH);

/** Keeps labels in place if they are still clear, and beside their curve or in their region. */
function keepLabels(runs, regions, map, placed, before) {
  const paths = regions.map((region) => [region.p, pathOf(region)]);
  for (const each of before) {
    const { kind, key, p, x, y, half } = each;
    const own = kind === "region" ? paths.some(([of, path]) => of === p && isInside(path, x, y)) : runs.some((run) => run.curve.key === key && reaches(run, each));
    if (own && clear(map, placed, x, y, half)) placed.push(each);
  }
}

/** A label beside each curve that is long enough, if there is room. */
function curveLabels(frame, runs, map, placed) {
  const long = runs.map((run) => ({ ...run, length: run.points.reduce((sum, [x, y], at) => (at === 0 ? 0 : sum + Math.hypot(x - run.points[at - 1][0], y - run.points[at - 1][1])), 0) }));
  for (const { curve, points, length } of long.sort((a, b) => b.length - a.length)) {
    if (length < 100 || curve.source === "quadratic") continue;
    const half = curve.name ? 8 + 3.5 * curve.name.length : curve.kind === "graz" ? 26 : 14;
    let [best, passed] = [{ score: 0 }, 0];
    if (placed.some((each) => each.key === curve.key && reaches({ points }, each))) continue;
    for (let index = 1; index < points.length; index += 1) {
      const [[ax, ay], [bx, by]] = [points[index - 1], points[index]];
      const along = Math.hypot(bx - ax, by - ay);
      for (let at = (12 - (passed % 12)) % 12; at < along; at += 12) {
        const [dx, dy] = [(bx - ax) / along, (by - ay) / along];
        const [px, py] = [ax + dx * at, ay + dy * at];
        const off = Math.abs(dy) * (half + 4) + Math.abs(dx) * 13;
        for (const side of [-1, 1]) {
          const [x, y] = [px - side * dy * off, py + side * dx * off];
          if (!clear(map, placed, x, y, half)) continue;
          const repeats = placed.some(({ text, x: ox, y: oy }) => sameWord(text, wordOf(curve)) && Math.hypot(ox - x, oy - y) < 130);
          const middle = 1 - Math.abs((passed + at) / length - 0.5);
          const score = repeats ? 0 : Math.min(18, map.at(x, y)) * middle;
          if (score > best.score) best = { score, x, y };
        }
      }
      passed += along;
    }
    if (best.score > 0) placed.push({ text: wordOf(curve), x: best.x, y: best.y, half, kind: curve.kind, key: curve.key });
  }
}

/** All labels: [{ text (pieces), x, y, kind, key of the curve }], in pixels; `before` are the previous ones. */
export function placeLabels(frame, runs, regions, points, before) {
  const map = distances(frame, runs, points);
  const placed = [];
  const own = named(regions);
  keepLabels(runs, own, map, placed, before);
  regionLabels(frame, own, map, placed);
  curveLabels(frame, runs, map, placed);
  return placed;
}

// Axes of a canvas: round ticks however narrow the range, with an offset where the numbers would be too long.

const FAMILY = '"Figure Text", "STIX Two Text", Georgia, "Times New Roman", serif';
export const font = (size, italic = false) => `${italic ? "italic " : ""}${size}px "Figure Signs", ${FAMILY}`;
/** Numbers with more decimals than this are written relative to an offset. */
const LONGEST = 6;

/** The canvas that is drawn on another context, and that context. */
let elsewhere = null;
/** Draws the contents of a canvas on another context. */
export function drawnOn(canvas, context, draw) {
  elsewhere = { canvas, context };
  try {
    draw();
  } finally {
    elsewhere = null;
  }
}

/** A canvas as large as its element, in pixels of the page; null while it is not visible. */
function prepare(canvas) {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width < 40 || height < 40) return null;
  if (elsewhere?.canvas === canvas) return { context: elsewhere.context, width, height };
  const ratio = devicePixelRatio || 1;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across || canvas.height !== down) Object.assign(canvas, { width: across, height: down });
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

/**
 * Ticks for a range: [{ part, label }] with the part of the axis' length from its low end, minor ones without label,
 * and the offset and the power of ten that the labels leave out.
 */
export function ticks([low, high], most) {
  const span = high - low;
  const { step, parts } = Scales.roundStep(span, Math.max(1, most));
  const size = Math.max(Math.abs(low), Math.abs(high));
  let [offset, power] = [0, 0];
  const depth = Math.floor(Math.log10(step) + 1e-9);
  if (-depth > LONGEST && size / step > 1e4) {
    const unit = 10 ** Math.floor(Math.log10(span) + 1e-9);
    offset = Math.round((low + high) / 2 / unit) * unit;
    offset = Number(offset.toFixed(Math.min(16, Math.max(0, Math.round(-Math.log10(unit))))));
    power = Math.floor(Math.log10(span) + 1e-9);
  } else if (size < 0.02 || size >= 1e5) power = Math.floor(Math.log10(size) + 1e-9);
  const decimals = Math.max(0, power - depth);
  const found = [];
  const small = step / parts;
  const from = low - offset;
  for (let at = Math.ceil(from / small - 1e-9); at * small <= high - offset + small * 1e-6 && found.length < 400; at += 1) {
    const label = at % parts === 0 ? Scales.written((at * small) / 10 ** power, decimals) : null;
    found.push({ part: (at * small - from) / span, label });
  }
  return { found, offset: offset === 0 ? null : String(offset), power };
}

/** Writes pieces [text, "italic" | "sub" | "sup" | ""] in a row, shifted from the point by `align` times the width. */
export function write(context, pieces, x, y, size, align = 0) {
  const measured = pieces.map(([text, style]) => {
    const small = style === "sub" || style === "sup";
    context.font = font(small ? size * 0.72 : size, style === "italic");
    return [text, style, context.font, context.measureText(text).width];
  });
  const width = measured.reduce((sum, piece) => sum + piece[3], 0);
  let at = x - align * width;
  context.textAlign = "left";
  for (const [text, style, face, wide] of measured) {
    context.font = face;
    context.fillText(text, at, y + (style === "sub" ? size * 0.22 : style === "sup" ? -size * 0.38 : 0));
    at += wide;
  }
  return width;
}

/** A unit with raised powers: m/s^2. */
export const unitPieces = (unit) => unit.split(/\^(-?\d+)/).flatMap((part, at) => (part === "" ? [] : [[part.replace("-", "−"), at % 2 === 1 ? "sup" : ""]]));

/** The title of an axis with the offset and the power that its labels leave out, and the unit. */
function titled({ title, unit }, { offset, power }) {
  const pieces = [...title];
  if (offset) pieces.push([offset.startsWith("-") ? ` + ${offset.slice(1)}` : ` − ${offset}`, ""]);
  if (offset && (power || unit)) pieces.splice(0, pieces.length, ["(", ""], ...pieces, [")", ""]);
  const ten = power ? [["10", ""], [String(power).replace("-", "−"), "sup"]] : [];
  if (unit) pieces.push([" (", ""], ...ten, [power ? " " : "", ""], ...unitPieces(unit), [")", ""]);
  else if (power) pieces.push([" / ", ""], ...ten);
  return pieces;
}

/** Frame, ticks, numbers and titles. `axes` is { x: { range, title, unit }, y: { ... } }, titles as pieces. */
function drawAxes(context, frame, axes, ink, size = 13) {
  const { x, y, w, h } = frame;
  context.strokeStyle = ink.ink;
  context.fillStyle = ink.ink;
  context.lineWidth = 1;
  context.setLineDash([]);
  context.textBaseline = "alphabetic";
  context.beginPath();
  context.rect(Math.round(x) + 0.5, Math.round(y) + 0.5, Math.round(w), Math.round(h));
  let across = ticks(axes.x.range, w / 62);
  context.font = font(size);
  const widest = Math.max(...across.found.map(({ label }) => (label ? context.measureText(label).width : 0)));
  across = ticks(axes.x.range, w / Math.max(46, widest + 20));
  for (const { part, label } of across.found) {
    const at = Math.round(x + part * w) + 0.5;
    context.moveTo(at, Math.round(y + h) + 0.5);
    context.lineTo(at, Math.round(y + h) + (label === null ? 3.5 : 5.5));
    if (label !== null) write(context, [[label, ""]], at, y + h + 8 + size * 0.75, size, 0.5);
  }
  const up = ticks(axes.y.range, h / 38);
  for (const { part, label } of up.found) {
    const at = Math.round(y + h - part * h) + 0.5;
    context.moveTo(Math.round(x) + 0.5, at);
    context.lineTo(Math.round(x) - (label === null ? 3.5 : 5.5) + 0.5, at);
    if (label !== null) write(context, [[label, ""]], x - 9, at + size * 0.33, size, 1);
  }
  context.stroke();
  write(context, titled(axes.x, across), x + w / 2, y + h + 2.75 * size + 2, size * 1.15, 0.5);
  context.save();
  context.translate(axes.y.at ?? size * 1.15, y + h / 2);
  context.rotate(-Math.PI / 2);
  write(context, titled(axes.y, up), 0, 0, size * 1.15, 0.5);
  context.restore();
}

/** The function that maps places in two ranges into a frame. */
export const into = ({ x, y, w, h }, [a, b], [c, d]) => ([px, py]) => [x + ((px - a) / (b - a)) * w, y + h - ((py - c) / (d - c)) * h];

/**
 * A canvas with a frame of paper, and `end`, which draws its axes; null while it is not visible. `margins(width,
 * height)` are those of the frame.
 */
export function chart(canvas, margins, axes, ink, size) {
  const made = prepare(canvas);
  if (!made) return null;
  const { context, width, height } = made;
  const { left, right, top, bottom } = margins(width, height, context);
  const frame = { x: left, y: top, w: width - left - right, h: height - top - bottom };
  context.save();
  context.beginPath();
  context.rect(frame.x, frame.y, frame.w, frame.h);
  context.fillStyle = ink.paper;
  context.fill();
  context.clip();
  const end = () => (context.restore(), drawAxes(context, frame, axes, ink, size));
  return { context, frame, to: into(frame, axes.x.range, axes.y.range), end };
}

/** The part of a polyline in a box as a list of polylines: a canvas draws lines far outside badly, and dashes not at all. */
export function clipped(points, box) {
  const found = [];
  let run = null;
  for (let index = 1; index < points.length; index += 1) {
    const [[ax, ay], [bx, by]] = [points[index - 1], points[index]];
    const [from, to] = Scales.within([ax, ay], [bx, by], box) ?? [1, 0];
    if (!(from < to)) {
      run = null;
      continue;
    }
    if (!run || from > 0) found.push((run = [[ax + from * (bx - ax), ay + from * (by - ay)]]));
    run.push([ax + to * (bx - ax), ay + to * (by - ay)]);
    if (to < 1) run = null;
  }
  return found;
}

/** The part of a polygon in a box. */
export function clippedRing(points, [left, top, right, bottom]) {
  let ring = points;
  for (const [axis, limit, sign] of [[0, left, 1], [0, right, -1], [1, top, 1], [1, bottom, -1]]) {
    const before = ring;
    ring = [];
    before.forEach((point, index) => {
      const last = before[(index + before.length - 1) % before.length];
      const [inside, was] = [(point[axis] - limit) * sign >= 0, (last[axis] - limit) * sign >= 0];
      if (inside !== was) {
        const part = (limit - last[axis]) / (point[axis] - last[axis]);
        ring.push([last[0] + part * (point[0] - last[0]), last[1] + part * (point[1] - last[1])]);
      }
      if (inside) ring.push(point);
    });
  }
  return ring;
}

export function trace(context, points, closed = false) {
  points.forEach(([x, y], index) => (index === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  if (closed) context.closePath();
}

"use strict";
// The parts of a drawing: what lies in which panel, and where it goes when the panel shows less of its plane.

const SVG = "http://www.w3.org/2000/svg";
/** Sizes of the drawings, in points of the sheet: numbers and ticks of axes, and what is no larger than a marker. */
const NUMBER_SIZE = 7.5;
const TICK = 3;
const MINOR_TICK = 1.7;
const MARKER = 8.5;
/** What is this near to a panel belongs to it; it has no place while the panel shows less than the whole. */
const BESIDE = 26;
/** Width of a digit of the numbers, on average. */
const DIGIT = 3.8;

/** An element of SVG. */
function drawn(name, attributes = {}, text = "") {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

/** A path as moves and lines: [begins, x, y], or [closes]. */
function readPath(text) {
  const points = [];
  let [x, y, command, start] = [0, 0, "", [0, 0]];
  const words = text.match(/[a-zA-Z]|-?(?:\d+\.?\d*|\.\d+)/g) ?? [];
  for (let at = 0; at < words.length; ) {
    if (/[a-zA-Z]/.test(words[at])) command = words[at++];
    if (command === "Z" || command === "z") {
      points.push([true]);
      [x, y] = start;
      command = "";
      continue;
    }
    if (command === "h") x += Number(words[at++]);
    else {
      const near = command === command.toLowerCase();
      x = Number(words[at++]) + (near ? x : 0);
      y = Number(words[at++]) + (near ? y : 0);
    }
    const begins = command === "M" || command === "m";
    points.push([begins, x, y]);
    if (begins) {
      start = [x, y];
      command = command === "M" ? "L" : "l";
    }
  }
  return points;
}

/** How a path of dots, each one unit wide, lies on the sheet; others lie there as they are. */
function latticeOf(node) {
  const told = /translate\(([-\d.]+)[ ,]([-\d.]+)\) scale\(([-\d.]+)\)/.exec(node.getAttribute("transform") ?? "");
  return told && { x: Number(told[1]), y: Number(told[2]), side: Number(told[3]) };
}

/** The box of an element on the sheet. */
function boxOf(node) {
  const box = node.getBBox();
  const lattice = latticeOf(node);
  if (!lattice) return box;
  const { x, y, side } = lattice;
  return { x: x + side * box.x, y: y + side * box.y, width: side * box.width, height: side * box.height };
}

const within = (box, bounds, margin) =>
  box.x >= bounds.x - margin && box.x + box.width <= bounds.x + bounds.w + margin &&
  box.y >= bounds.y - margin && box.y + box.height <= bounds.y + bounds.h + margin;

/**
 * How often the edges of a path wind about a point. The browser knows as well (`isPointInFill`), but lays out the whole page
 * before it answers.
 */
class Winding {
  constructor(point) {
    this.point = point;
    this.turns = 0;
    this.crossings = 0;
  }

  /** Adds the edge between two points; there is none where one is missing. */
  pass(from, to) {
    if (!from || !to) return;
    const [x, y] = this.point;
    if (from[1] > y === to[1] > y) return;
    if (from[0] + ((y - from[1]) / (to[1] - from[1])) * (to[0] - from[0]) <= x) return;
    this.turns += to[1] > from[1] ? 1 : -1;
    this.crossings += 1;
  }

  /** Whether the path covers the point, by a rule for filling. */
  fills(rule) {
    return (rule === "evenodd" ? this.crossings % 2 : this.turns) !== 0;
  }
}

/**
 * A part of a drawing that lies in a panel: `show` puts it where the view wants it, and tells whether
 * any of it is seen there, or its shade only.
 */
function partOf(node, panel, clip) {
  const { bounds } = panel;
  const edges = [bounds.x, bounds.y, bounds.x + bounds.w, bounds.y + bounds.h];
  const sees = (x, y) => x >= bounds.x && x <= bounds.x + bounds.w && y >= bounds.y && y <= bounds.y + bounds.h;
  const names = { path: ["d"], circle: ["cx", "cy"], text: ["x", "y", "transform"] }[node.localName];
  if (!names) return null;
  names.push("clip-path");
  const before = names.map((name) => node.getAttribute(name));
  const restore = () => {
    names.forEach((name, index) => (before[index] === null ? node.removeAttribute(name) : node.setAttribute(name, before[index])));
    node.style.removeProperty("display");
  };
  if (node.localName === "circle") {
    const [cx, cy] = before.map(Number);
    const show = (to) => {
      const [x, y] = to(cx, cy);
      node.setAttribute("cx", x.toFixed(2));
      node.setAttribute("cy", y.toFixed(2));
      node.setAttribute("clip-path", clip);
      return sees(x, y);
    };
    return { show, restore };
  }
  if (node.localName === "text") {
    const box = node.getBBox();
    const [cx, cy] = before[2] ? [bounds.x, bounds.y] : [box.x + box.width / 2, box.y + box.height / 2];
    const show = (to) => {
      const [x, y] = to(cx, cy);
      const seen = !before[2] && sees(x, y);
      node.setAttribute("x", (Number(before[0]) + x - cx).toFixed(2));
      node.setAttribute("y", (Number(before[1]) + y - cy).toFixed(2));
      node.style.display = seen ? "" : "none";
      return seen;
    };
    return { show, restore };
  }
  const points = readPath(before[0]);
  const lattice = latticeOf(node);
  if (lattice) {
    const { side } = lattice;
    const bins = new Map();
    points.forEach(([begins, px, py], index) => {
      if (begins) return;
      for (let at = points[index - 1][1]; at < px; at += 1) bins.set(`${at},${Math.floor(py)}`, [lattice.x + side * (at + 0.5), lattice.y + side * py]);
    });
    // As the drawing counts its bins: from the lower left corner, in whole hundredths of a point.
    const cut = (length) => Math.floor(100 * length) / 100;
    const bin = ({ x, y }) => `${Math.floor(cut(x - bounds.x) / side)},${Math.floor((bounds.h - cut(bounds.y + bounds.h - y)) / side)}`;
    let dots = [...bins.values()];
    let exact = false;
    const show = (to) => {
      // Once the data are there, dots lie where they belong, not where their bins do.
      if (panel.points && !exact) {
        dots = panel.points.filter((point) => point.table.isCloud && bins.has(bin(point))).map(({ x, y }) => [x, y]);
        exact = true;
      }
      const seen = dots.map(([px, py]) => to(px, py)).filter(([x, y]) => sees(x, y));
      node.setAttribute("d", seen.map(([x, y]) => `M${((x - lattice.x) / side - 0.5).toFixed(2)},${((y - lattice.y) / side).toFixed(2)}h1`).join(""));
      return seen.length > 0;
    };
    return { show, restore, dotted: true };
  }
  const filled = node.hasAttribute("fill") && node.getAttribute("fill") !== "none";
  const rule = node.getAttribute("fill-rule");
  const box = boxOf(node);
  const marker = filled && points.length < 14 && box.width <= MARKER && box.height <= MARKER;
  const show = (to) => {
    let path = "";
    let seen = false;
    let last = null;
    let first = null;
    const inside = new Winding([bounds.x + bounds.w / 2, bounds.y + bounds.h / 2]);
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    const moved = marker && to(...middle);
    for (const [begins, px, py] of points) {
      if (px === undefined) {
        path += "Z";
        continue;
      }
      const [x, y] = moved ? [px + moved[0] - middle[0], py + moved[1] - middle[1]] : to(px, py);
      seen ||= begins || !last ? sees(x, y) : Scales.within(last, [x, y], edges) !== null;
      path += `${begins ? "M" : "L"}${x.toFixed(2)},${y.toFixed(2)}`;
      if (begins) {
        inside.pass(last, first);
        first = [x, y];
      } else inside.pass(last, [x, y]);
      last = [x, y];
    }
    inside.pass(last, first);
    node.setAttribute("d", path);
    node.setAttribute("clip-path", clip);
    if (!seen && filled && !marker && inside.fills(rule)) return "shade";
    return seen;
  };
  return { show, restore };
}

/** Whether an element is a tick or a number of the panel's axes, or its frame; these follow the panel's mark. */
function isOfAxes(node, { x, y, w, h }) {
  const near = (a, b) => Math.abs(a - b) < 0.02;
  if (node.localName === "text") {
    return Number(node.getAttribute("font-size")) === NUMBER_SIZE && !node.querySelector("tspan");
  }
  if (node.localName !== "path" || node.getAttribute("fill")) return false;
  const points = readPath(node.getAttribute("d"));
  if (points.length === 6) return points.every(([, px, py]) => (near(px, x) || near(px, x + w)) && (near(py, y) || near(py, y + h)));
  if (points.length !== 2) return false;
  const [[, ax, ay], [, bx, by]] = points;
  return (near(ax, bx) && near(ay, y + h) && by > ay) || (near(ay, by) && near(ax, x) && bx < ax);
}

/** The parts of the drawing, shared out among its panels. */
function takeApart(svg, panels) {
  const nodes = [...svg.children].filter((node) => ["path", "circle", "text"].includes(node.localName));
  const taken = new Set();
  for (const [index, panel] of panels.entries()) {
    const id = `${svg.closest("figure").id}-panel-${index}`;
    const { x, y, w, h } = panel.bounds;
    const clipPath = drawn("clipPath", { id });
    clipPath.append(drawn("rect", { x, y, width: w, height: h }));
    svg.append(clipPath);
    panel.clip = `url(#${id})`;
    [panel.axes, panel.parts, panel.beside] = [[], [], []];
    if (!panel.mark) continue;
    let next = panel.mark.nextElementSibling;
    for (; next && isOfAxes(next, panel.bounds); next = next.nextElementSibling) {
      if (next.localName === "text" || readPath(next.getAttribute("d")).length === 2) panel.axes.push(next);
      taken.add(next);
    }
    // The titles follow.
    for (; next?.localName === "text" && !within(next.getBBox(), panel.bounds, -1); next = next.nextElementSibling) taken.add(next);
  }
  for (const node of nodes) {
    if (taken.has(node)) continue;
    const box = boxOf(node);
    const small = node.localName !== "path" || (box.width <= MARKER && box.height <= MARKER);
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2, width: 0, height: 0 };
    const owner = panels.find((panel) => within(small ? middle : box, panel.bounds, 0.6));
    const part = owner && partOf(node, owner, owner.clip);
    if (part) owner.parts.push(part);
    else {
      for (const panel of panels) {
        const { x, y, w, h } = panel.bounds;
        const across = Math.max(x - box.x - box.width, box.x - x - w, 0);
        const down = Math.max(y - box.y - box.height, box.y - y - h, 0);
        if (Math.max(across, down) < BESIDE) panel.beside.push(node);
      }
    }
  }
  for (const [index, panel] of panels.entries()) if (panel.mark) panel.numbering = numbering(panel, panels[index - 1]);
}

/** How the numbers at the axes come from values: an axis may leave a round number or a power of ten to its title. */
function numbering(panel, before) {
  const texts = panel.axes.filter((node) => node.localName === "text");
  return [0, 1].map((axis) => {
    const of = texts.filter((node) => (node.getAttribute("text-anchor") === "end") === (axis === 1));
    const known = of.map((node) => {
      const place = [Number(node.getAttribute("x")), Number(node.getAttribute("y")) - 0.33 * NUMBER_SIZE];
      return [panel.toData({ x: place[0], y: place[1] })[axis], Number(node.textContent.replace("−", "-")), node];
    });
    const [first, last] = [known[0], known.at(-1)];
    if (known.length < 2) return { scale: before?.numbering?.[axis].scale ?? ((value) => value), room: 0, ratio: before?.numbering?.[axis].ratio ?? 1 };
    const ratio = (last[1] - first[1]) / (last[0] - first[0]);
    const room = Math.max(...known.map(([, , node]) => node.getBBox().width));
    // Places on the sheet are rounded: a ratio that is nearly a power of ten is one.
    const power = 10 ** Math.round(Math.log10(Math.abs(ratio)));
    const exact = Math.abs(ratio / power - 1) < 0.02 ? Math.sign(ratio) * power : ratio;
    // What is left to the title is a round number beside the numbers that stand there.
    const round = 10 ** Math.floor(Math.log10(Math.abs(last[1] - first[1])));
    const offset = Math.round((first[1] - exact * first[0]) / round) * round;
    return { scale: (value) => exact * value + offset, ratio: exact, room };
  });
}

/** Multiples of the step in the range. */
function multiples([low, high], step) {
  const found = [];
  for (let count = Math.ceil(low / step - 1e-9); count * step <= high + step * 1e-9; count += 1) found.push(count * step);
  return found;
}

/** Ticks and numbers for what the panel shows: values at its ends, along x and along y. */
function drawAxes(panel, ranges) {
  const { x, y, w, h } = panel.bounds;
  const group = drawn("g", { class: "axes" });
  const line = (x1, y1, x2, y2) => group.append(drawn("line", { x1, y1, x2, y2, stroke: "#000000", "stroke-width": 0.5 }));
  ranges.forEach((range, axis) => {
    const { scale, ratio, room } = panel.numbering[axis];
    const ends = range.map(scale).sort((a, b) => a - b);
    const length = axis === 0 ? w : h;
    const longest = () => Math.max(...ends.map((end) => end.toFixed(numbers.decimals).length)) * DIGIT;
    let numbers = Scales.roundStep(ends[1] - ends[0], axis === 0 ? length / 34 : length / 22);
    if (axis === 0) numbers = Scales.roundStep(ends[1] - ends[0], Math.max(1.3, length / (longest() + 12)));
    const place = (value) => {
      const part = (value - scale(range[0])) / (ratio * (range[1] - range[0]));
      return axis === 0 ? x + part * w : y + h - part * h;
    };
    for (const value of multiples(ends, numbers.step / numbers.parts)) {
      const at = place(value);
      if (axis === 0) line(at, y + h, at, y + h + MINOR_TICK);
      else line(x, at, x - MINOR_TICK, at);
    }
    // Numbers that are longer than those of the whole panel would run into the title: they stand inside the frame.
    const inside = axis === 1 && longest() > room + 4;
    for (const value of multiples(ends, numbers.step)) {
      const at = place(value);
      const text = Scales.written(value, Math.min(numbers.decimals, 15));
      const set = { "font-size": NUMBER_SIZE, fill: "#000000" };
      if (axis === 0) {
        line(at, y + h, at, y + h + TICK);
        const anchor = { "text-anchor": "middle", x: at, y: y + h + TICK + 2.5 + 0.66 * NUMBER_SIZE };
        group.append(drawn("text", { ...set, ...anchor }, text));
      } else {
        line(x, at, x - TICK, at);
        const low = at + 0.33 * NUMBER_SIZE;
        const beside = { "text-anchor": "end", x: x - TICK - 2.5, y: low };
        const within = { "text-anchor": "start", x: x + 2, y: Math.min(Math.max(low, y + 6), y + h - 1.5), class: "inside" };
        group.append(drawn("text", { ...set, ...(inside ? within : beside) }, text));
      }
    }
  });
  return group;
}

// Simulation under the curves: tiles from coarse to fine, and marks where they disagree with the shading. The last few
// views are kept.
import { $, make, rested } from "./dom.js";
import { Latest, stream } from "./api.js";
import { diagram, isBusy } from "./diagram.js";
import { description, modelOf, viewOf } from "./model.js";
import { inks, loopsInk, loopsNames, onTheme } from "./palette.js";
import { frame, project, redraw, setOverlay } from "./plane.js";
import * as state from "./state.js";

const PERIODS = 300;
const MOST = { columns: 400, rows: 300 };
const KEPT = 6;
/** The tiles of views, newest last: key -> { view, columns, rows, sheet, cells, wrong, done }. */
const kept = new Map();
const latest = new Latest({ failed: (error) => status(error.message) });
let current = null;

const status = (words) => ($("tiles-status").textContent = words);

/** The colour of a cell; where the oscillator is not valid there is none. */
function colourOf([, , loops, periods, , rests], ink) {
  if (loops === undefined) return "transparent";
  if (rests) return ink.muted;
  if (loops === 0) return ink.calm;
  if (loops !== null) return loopsInk(loops, ink);
  return periods === null ? ink.irregular : ink.periodic;
}

function paint(context, view) {
  if (!current) return;
  const { sheet, view: own } = current;
  const to = project(view);
  const [[left, bottom], [right, top]] = [to([own.primary[0], own.secondary[0]]), to([own.primary[1], own.secondary[1]])];
  context.imageSmoothingEnabled = false;
  context.globalAlpha = 0.82 * (diagram.wanted === null ? 0.25 : 1);
  context.drawImage(sheet, left, top, right - left, bottom - top);
  context.globalAlpha = 1;
  if (!current.wrong?.length) return;
  const [wide, high] = [(right - left) / current.columns, (bottom - top) / current.rows];
  context.strokeStyle = inks().place;
  context.lineWidth = 1.2;
  context.beginPath();
  for (const [column, row] of current.wrong) {
    const [x, y] = [left + (column + 0.5) * wide, bottom - (row + 0.5) * high];
    const size = Math.min(3.5, Math.max(2, wide));
    context.moveTo(x - size, y - size);
    context.lineTo(x + size, y + size);
    context.moveTo(x - size, y + size);
    context.lineTo(x + size, y - size);
  }
  context.stroke();
}

/** For each p, the cells with anything shaded within the width of a cell, and the undecided ones. */
function shading({ view, columns, rows }) {
  const sheet = document.createElement("canvas");
  Object.assign(sheet, { width: columns, height: rows });
  const context = sheet.getContext("2d", { willReadFrequently: true });
  const to = ([p, s]) => [((p - view.primary[0]) / (view.primary[1] - view.primary[0])) * columns, rows - ((s - view.secondary[0]) / (view.secondary[1] - view.secondary[0])) * rows];
  const coverage = (chosen) => {
    context.clearRect(0, 0, columns, rows);
    context.lineWidth = 3;
    for (const { rings } of chosen) {
      context.beginPath();
      for (const ring of rings) {
        ring.forEach((point, index) => (index === 0 ? context.moveTo(...to(point)) : context.lineTo(...to(point))));
        context.closePath();
      }
      context.fill("evenodd");
      context.stroke();
    }
    return context.getImageData(0, 0, columns, rows).data;
  };
  const of = new Map();
  return (p, column, row) => {
    if (!of.has(p)) of.set(p, coverage(diagram.regions.filter((region) => (region.kind === "undecided" && !region.impacts && (!region.p || region.p === p)) || (p === 0 ? region.kind === "non-impacting" : region.kind === "mps" && region.p === p))));
    return of.get(p)[4 * ((rows - 1 - row) * columns + column) + 3] > 0;
  };
}

/** Finds the cells in which a p-loop solution was simulated where the diagram shades nothing of this p. */
function judge() {
  if (!current || current.cells.length === 0 || diagram.stale || diagram.regions.length === 0) return;
  const shaded = shading(current);
  const followed = new Set(state.get().loops ?? description.loops);
  current.wrong = current.cells.filter(([column, row, loops]) => typeof loops === "number" && (loops === 0 || followed.has(loops)) && !shaded(loops, column, row));
  const all = current.cells.length;
  const share = Math.round((100 * all) / (current.columns * current.rows));
  const words = current.wrong.length === 0 ? "none disagrees with the shading" : `${current.wrong.length} disagree with the shading (crosses)`;
  status(`${all.toLocaleString("en-GB")} places simulated${current.done ? "" : ` (${share} %)`}; ${words}.`);
  redraw();
}

/** The judgement of all cells, at most once in this many milliseconds. */
const judgeSoon = rested(250, judge);

const request = rested(250, () => {
  const value = state.get();
  if (!value.overlay) return;
  // After everything else: the diagram comes first.
  if (isBusy()) {
    status("Simulation waits for the curves …");
    request();
    return;
  }
  const view = viewOf(value);
  const columns = Math.max(40, Math.min(MOST.columns, Math.floor(frame.w / 2)));
  const rows = Math.max(30, Math.min(MOST.rows, Math.floor(frame.h / 2)));
  const body = { model: modelOf(value), view, columns, rows, periods: PERIODS };
  const key = JSON.stringify([body.model, view]);
  const known = kept.get(key);
  if (known) {
    kept.delete(key);
    kept.set(key, known);
    if (current !== known) latest.stop();
    current = known;
    if (known.done) status("");
    judgeSoon();
    redraw();
    if (known.done || latest.running) return;
  } else {
    const sheet = document.createElement("canvas");
    Object.assign(sheet, { width: columns, height: rows });
    // Earlier results stay below until finer tiles cover them.
    if (current) carry(sheet, current, view);
    current = { view, columns, rows, sheet, cells: [], wrong: [], done: false };
    kept.set(key, current);
    while (kept.size > KEPT) kept.delete(kept.keys().next().value);
  }
  // Places come in a fixed order: those simulated in an earlier visit are skipped.
  run(current, { ...body, columns: current.columns, rows: current.rows, known: current.cells.length });
});

function carry(sheet, { view: old, sheet: before }, view) {
  const part = (axis, value) => (value - view[axis][0]) / (view[axis][1] - view[axis][0]);
  const [left, right] = old.primary.map((value) => part("primary", value) * sheet.width);
  const [bottom, top] = old.secondary.map((value) => (1 - part("secondary", value)) * sheet.height);
  const context = sheet.getContext("2d");
  context.imageSmoothingEnabled = false;
  context.globalAlpha = 0.35;
  context.drawImage(before, left, top, right - left, bottom - top);
}

function run(own, body) {
  const context = own.sheet.getContext("2d");
  status("Simulating …");
  latest.now(async (signal) => {
    const on = {
      tiles({ step, cells }) {
        if (signal.aborted) return;
        const ink = inks();
        for (const cell of cells) {
          const [column, row] = cell;
          cell.step = step;
          context.clearRect(column, own.rows - row - step, step, step);
          context.fillStyle = colourOf(cell, ink);
          context.fillRect(column, own.rows - row - step, step, step);
          own.cells.push(cell);
        }
        if (own === current) {
          const share = Math.round((100 * own.cells.length) / (own.columns * own.rows));
          status(`Simulating: ${share} % of ${own.columns} × ${own.rows} places …`);
          redraw();
        }
      },
      done() {
        if (signal.aborted) return;
        own.done = true;
        if (own === current) judge();
      },
    };
    await stream("tiles", body, on, signal);
  });
}

export function follow(value, moved) {
  document.querySelector('[data-command="overlay"]').setAttribute("aria-pressed", value.overlay);
  $("tiles-legend").hidden = !value.overlay;
  for (const entry of document.querySelectorAll(".shade")) entry.hidden = value.overlay;
  if (!value.overlay) {
    latest.stop();
    request.cancel();
    judgeSoon.cancel();
    setOverlay(null);
    status("");
    return;
  }
  setOverlay(paint);
  const other = ["text", "example", "set", "loops"].some((name) => moved.has(name));
  if (other) current = null;
  if (other || moved.has("view")) latest.stop();
  if (other || moved.has("view") || moved.has("overlay")) request();
}

/** The simulated cells of the view, their number, the numbers in each of the last views, and the view itself. */
export const cells = () => current?.cells ?? [];
export const seen = () => cells().length;
export const sizes = () => [...kept.values()].map(({ cells }) => cells.length);
export const view = () => current?.view ?? null;
export const simulated = () => current;

/** Judges the cells again when the diagram has new regions. */
export const shaded = () => state.get().overlay && judgeSoon();

/** Draws the legend; finished sheets are painted again when the theme changes. */
function colours() {
  const ink = inks();
  const loops = loopsNames().map((word, p) => [loopsInk(p, ink), word]).slice(1);
  const entries = [[ink.calm, "no impacts"], ...loops, [ink.periodic, "other periodic motion"], [ink.irregular, "longer periods, or chaos"], [ink.muted, "rests at the wall"]];
  const entry = ([colour, word]) => {
    const swatch = make("span", { class: "tile", "aria-hidden": "true" });
    swatch.style.background = colour;
    return make("li", {}, swatch, word);
  };
  $("tiles-entries").replaceChildren(...entries.map(entry));
  for (const { sheet, cells, rows } of kept.values()) {
    const context = sheet.getContext("2d");
    for (const cell of cells) {
      context.fillStyle = colourOf(cell, ink);
      context.fillRect(cell[0], rows - cell[1] - cell.step, cell.step, cell.step);
    }
  }
  redraw();
}

export function attach() {
  colours();
  onTheme(colours);
}

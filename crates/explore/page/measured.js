// Measurements: a CSV that is opened or dropped, its marks over the diagram, and the agreement region by region. The
// file is read at once; it is compared when the diagram in view is complete, which is not computed again for it.
import { ask, Latest, stream } from "./api.js";
import { $, count, make } from "./dom.js";
import { isWhole } from "./diagram.js";
import { modelOf, viewOf } from "./model.js";
import { inks, onTheme } from "./palette.js";
import * as state from "./state.js";

/** Half the size of a mark in pixels. */
const SIZE = 5;
/** The most disagreeing measurements that are listed. */
const LISTED = 12;

const ring = (corners, turn = 0) => Array.from({ length: corners }, (_, at) => [Math.sin(turn + (2 * Math.PI * at) / corners), -Math.cos(turn + (2 * Math.PI * at) / corners)]);
/** The outline of the mark of each kind of motion, as corners about the middle: the shapes of the printed figures. */
const SHAPES = {
  "no impacts": ring(24).map(([x, y]) => [0.95 * x, 0.95 * y]),
  "one impact in p periods": ring(4, Math.PI / 4).map(([x, y]) => [1.2 * x, 1.2 * y]),
  "other motion": ring(4).map(([x, y]) => [1.25 * x, 1.25 * y]),
  bifurcation: [[-0.35, -1.2], [0.35, -1.2], [0.35, -0.35], [1.2, -0.35], [1.2, 0.35], [0.35, 0.35], [0.35, 1.2], [-0.35, 1.2], [-0.35, 0.35], [-1.2, 0.35], [-1.2, -0.35], [-0.35, -0.35]],
};
/** The file as it was read: { of, points, columns }, or { of, message } with its first mistake; null before. */
let file = null;
/** The comparison: { of, counts, outside, verdicts by line }, or { of, message }; null before. */
let compared = null;
/** The progress of the comparison. */
let progress = "";
const keyOf = (...parts) => JSON.stringify(parts);
const reading = new Latest({ failed: ({ message }) => told(() => (file = { of: reading.of, points: [], message })) });
const comparing = new Latest({ failed: ({ message }) => told(() => (compared = { of: comparing.of, message })) });

/** The measurements, with verdicts where they have been compared. */
export const points = () => (state.get().data && file ? file.points.map((point) => ({ ...point, ...compared?.verdicts?.get(point.line) })) : []);

let shown = () => {};
/** What is done when there is more to be drawn. */
export const onTold = (act) => (shown = act);

function told(change) {
  change();
  list();
  shown();
}

/** Reads the file in the state if it has changed, and compares it once the diagram is there. */
export function follow() {
  const { data } = state.get();
  const model = modelOf(state.get());
  if (!data) {
    reading.stop();
    comparing.stop();
    if (file) told(() => ([file, compared, reading.of, comparing.of] = [null, null, "", ""]));
    return;
  }
  // Names of columns do not depend on constants.
  const plain = { text: model.text, set: {}, loops: null };
  const of = keyOf(plain, data);
  if (reading.of !== of) {
    // What was told of another file does not stay.
    reading.of = of;
    told(() => ([file, compared] = [null, null]));
    reading.now(async (signal) => {
      const read = await ask("measured", { model: plain, measured: data }, signal);
      if (signal.aborted) return;
      told(() => (file = { of, ...read }));
      follow();
    });
  }
  compare(data, model);
}

function compare(data, model) {
  const body = { model, view: viewOf(state.get()), measured: data };
  const of = keyOf(body);
  if (compared && compared.of !== of) told(() => (compared = null));
  if (comparing.of === of && (comparing.running || compared)) return;
  comparing.stop();
  comparing.of = "";
  if (!file || file.message || !isWhole()) return;
  comparing.of = of;
  progress = "";
  const on = {
    progress({ done, all }) {
      progress = all > 0 ? `, ${done} of ${all}` : "";
      list();
    },
    measured({ points: verdicts, counts, outside }) {
      told(() => (compared = { of, counts, outside, verdicts: new Map(verdicts.map((point) => [point.line, point])) }));
    },
  };
  comparing.now((signal) => stream("compare", body, on, signal));
  list();
}

const isAsComputed = (agreement) => agreement === "agrees" || agreement === "within error";

/** Draws the mark of a measurement about a pixel: filled if it agrees, crossed if it does not. */
function mark(context, { kind, agreement }, [x, y], ink) {
  context.beginPath();
  SHAPES[kind].forEach(([dx, dy], at) => (at ? context.lineTo(x + SIZE * dx, y + SIZE * dy) : context.moveTo(x + SIZE * dx, y + SIZE * dy)));
  context.closePath();
  context.fillStyle = isAsComputed(agreement) ? ink.marker : ink.paper;
  context.fill();
  context.lineWidth = 1;
  context.strokeStyle = isAsComputed(agreement) ? ink.rim : ink.marker;
  context.stroke();
  if (agreement !== "disagrees") return;
  for (const [colour, width] of [[ink.rim, 4], [ink.marker, 1.8]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (const way of [-1, 1]) {
      context.moveTo(x - 1.4 * SIZE, y - 1.4 * way * SIZE);
      context.lineTo(x + 1.4 * SIZE, y + 1.4 * way * SIZE);
    }
    context.stroke();
  }
}

/** Draws all measurements over the plane, with error bars; disagreeing ones lie on top. */
export function drawMeasured(context, to, ink) {
  const all = points().sort((a, b) => (a.agreement === "disagrees") - (b.agreement === "disagrees"));
  context.strokeStyle = ink.muted;
  context.lineWidth = 1;
  context.beginPath();
  for (const { at: [p, s], errors: [dp, ds] } of all) {
    for (const ends of [[[p - dp, s], [p + dp, s]], [[p, s - ds], [p, s + ds]]]) {
      context.moveTo(...to(ends[0]));
      context.lineTo(...to(ends[1]));
    }
  }
  context.stroke();
  for (const point of all) mark(context, point, to(point.at), ink);
}

/** The measurement at a pixel, in words. */
export function tellMeasured([x, y], to) {
  const near = points().find(({ at }) => Math.hypot(to(at)[0] - x, to(at)[1] - y) < 1.5 * SIZE);
  return near ? `measured (line ${near.line}): ${near.seen}${near.agreement ? `, ${near.agreement}` : ""}${near.reason ? `: ${near.reason}` : ""}` : "";
}

function sample(kind, agreement) {
  const canvas = make("canvas", { width: 40, height: 40, class: "sample", "aria-hidden": "true" });
  const context = canvas.getContext("2d");
  context.scale(2, 2);
  mark(context, { kind, agreement }, [10, 10], inks());
  return canvas;
}

/** Lists what the file has, how many measurements agree, region by region, and which do not. */
function list() {
  const { data } = state.get();
  $("measured").hidden = data === null;
  if (!data) return;
  $("measured-file").textContent = data.name;
  const wrong = file?.message ?? compared?.message ?? "";
  $("measured-message").textContent = wrong;
  $("measured-message").hidden = wrong === "";
  const isRead = file !== null && !file.message;
  const result = isRead && !wrong ? compared : null;
  $("measured-read").hidden = $("measured-marks").hidden = !isRead;
  for (const name of ["table", "against", "outside"]) $(`measured-${name}`).hidden = !result;
  const now = !isRead || result || wrong ? "" : comparing.of ? `Comparing with regions and curves${progress} …` : "Compared when all curves are there.";
  $("measured-progress").textContent = now;
  $("measured-progress").hidden = now === "";
  if (!isRead) return;
  const all = points();
  $("measured-read").textContent = `${count(all.length, "measurement")}, from the columns ${file.columns.join(", ")}.`;
  const kinds = Object.keys(SHAPES).filter((kind) => all.some((point) => point.kind === kind));
  const entries = kinds.map((kind) => [sample(kind, result ? "agrees" : undefined), kind]);
  if (result) entries.push([sample(kinds[0], "disagrees"), "disagrees"], [sample(kinds[0], "undecided"), "undecided"]);
  $("measured-marks").replaceChildren(...entries.map((entry) => make("li", {}, ...entry)));
  if (!result) return;
  const heads = ["region", "p", "all", "agree", "within error", "disagree", "undecided"];
  const cells = ({ region, kind, p, points, agree, within_error, disagree, undecided }) => [region ? `${region}: ${kind === "mps" ? "MPS" : kind}` : kind, kind === "none" ? "–" : p, points, agree, within_error, disagree, undecided];
  const rows = result.counts.map((count) => make("tr", {}, ...cells(count).map((cell) => make("td", {}, String(cell)))));
  $("measured-table").replaceChildren(make("thead", {}, make("tr", {}, ...heads.map((head) => make("th", { scope: "col" }, head)))), make("tbody", {}, ...rows));
  const against = all.filter(({ agreement }) => agreement === "disagrees");
  const items = against.slice(0, LISTED).map(({ line, seen, reason }) => make("li", {}, `Line ${line}, ${seen}: ${reason}`));
  const more = against.length > LISTED ? [make("li", {}, `and ${against.length - LISTED} more`)] : [];
  $("measured-against").replaceChildren(...items, ...more);
  $("measured-outside").textContent = result.outside ? `${count(result.outside, "measurement")} outside the view.` : "";
}

async function open(chosen) {
  if (chosen) state.update({ data: { name: chosen.name, text: await chosen.text() } });
}

export const choose = () => $("measured-choose").click();
export const remove = () => state.update({ data: null });

export function attach() {
  $("measured-choose").addEventListener("change", ({ target }) => {
    open(target.files[0]);
    // The same file can be opened again after a change.
    target.value = "";
  });
  const stage = $("stage");
  stage.addEventListener("dragover", (event) => event.preventDefault());
  stage.addEventListener("drop", (event) => {
    event.preventDefault();
    open(event.dataTransfer.files[0]);
  });
  onTheme(list);
}

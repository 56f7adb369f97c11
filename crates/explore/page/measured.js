// Measurements: a CSV that is opened or dropped, its marks over the diagram, and the agreement region by region.
import { $, count, make } from "./dom.js";
import { diagram } from "./diagram.js";
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
  const points = [...(diagram.measured?.points ?? [])].sort((a, b) => (a.agreement === "disagrees") - (b.agreement === "disagrees"));
  context.strokeStyle = ink.muted;
  context.lineWidth = 1;
  context.beginPath();
  for (const { at: [p, s], errors: [dp, ds] } of points) {
    for (const ends of [[[p - dp, s], [p + dp, s]], [[p, s - ds], [p, s + ds]]]) {
      context.moveTo(...to(ends[0]));
      context.lineTo(...to(ends[1]));
    }
  }
  context.stroke();
  for (const point of points) mark(context, point, to(point.at), ink);
}

/** The measurement at a pixel, in words. */
export function tellMeasured([x, y], to) {
  const near = (diagram.measured?.points ?? []).find(({ at }) => Math.hypot(to(at)[0] - x, to(at)[1] - y) < 1.5 * SIZE);
  return near ? `measured (line ${near.line}): ${near.seen}, ${near.agreement}${near.reason ? `: ${near.reason}` : ""}` : "";
}

function sample(kind, agreement) {
  const canvas = make("canvas", { width: 40, height: 40, class: "sample", "aria-hidden": "true" });
  const context = canvas.getContext("2d");
  context.scale(2, 2);
  mark(context, { kind, agreement }, [10, 10], inks());
  return canvas;
}

/** The comparison that is listed. */
let listed = null;

/** Lists how many measurements agree, region by region, and which do not. */
export function list(anew = false) {
  const { data } = state.get();
  const told = data && diagram.measured;
  $("measured").hidden = data === null;
  if (told === listed && !anew) return;
  listed = told;
  if (!data) return;
  $("measured-file").textContent = data.name;
  const wrong = told?.message ?? "";
  $("measured-message").textContent = wrong;
  $("measured-message").hidden = wrong === "";
  for (const name of ["marks", "table", "against", "outside"]) $(`measured-${name}`).hidden = !told || wrong !== "";
  if (!told || wrong) return;
  const kinds = Object.keys(SHAPES).filter((kind) => told.points.some((point) => point.kind === kind));
  const entries = [...kinds.map((kind) => [sample(kind, "agrees"), kind]), [sample(kinds[0] ?? "no impacts", "disagrees"), "disagrees"], [sample(kinds[0] ?? "no impacts", "undecided"), "undecided"]];
  $("measured-marks").replaceChildren(...entries.map((entry) => make("li", {}, ...entry)));
  const heads = ["region", "p", "all", "agree", "within error", "disagree", "undecided"];
  const rows = told.counts.map(({ region, kind, p, counts }) => make("tr", {}, ...[region ? `${region}: ${kind === "mps" ? "MPS" : kind}` : kind, kind === "none" ? "–" : p, ...counts].map((cell) => make("td", {}, String(cell)))));
  $("measured-table").replaceChildren(make("thead", {}, make("tr", {}, ...heads.map((head) => make("th", { scope: "col" }, head)))), make("tbody", {}, ...rows));
  const against = told.points.filter(({ agreement }) => agreement === "disagrees");
  const items = against.slice(0, LISTED).map(({ line, seen, reason }) => make("li", {}, `Line ${line}, ${seen}: ${reason}`));
  const more = against.length > LISTED ? [make("li", {}, `and ${against.length - LISTED} more`)] : [];
  $("measured-against").replaceChildren(...items, ...more);
  $("measured-outside").textContent = told.outside ? `${count(told.outside, "measurement")} outside the view.` : "";
}

async function open(file) {
  if (file) state.update({ data: { name: file.name, text: await file.text() } });
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
  onTheme(() => list(true));
}

// The pictures of the page as displayed, as SVG or PNG, and their numbers as CSV.
import { $ } from "./dom.js";
import { drawnOn } from "./axes.js";
import * as cut from "./cut.js";
import { diagram } from "./diagram.js";
import { description } from "./model.js";
import { inks } from "./palette.js";
import * as place from "./place.js";
import { draw as drawPlane } from "./plane.js";
import * as state from "./state.js";
import { SvgContext } from "./svg.js";
import * as tiles from "./tiles.js";

/** The pixels of a PNG for each pixel of the page. */
const FINE = 3;

const unit = (name) => (name ? ` (${name})` : "");
const axes = () => [description.primary, description.secondary].map((axis) => `${axis.name}${unit(axis.unit)}`);
const length = () => `x${description.from_the_wall ? " from the wall" : ""}${unit(description.units.length)}`;
const speed = () => (description.units.length && description.units.time ? ` (${description.units.length}/${description.units.time})` : "");

/** The simulated places, with their results. */
function simulated() {
  const { columns, rows, cells, view } = tiles.simulated();
  const at = ([low, high], place, count) => low + ((place + 0.5) / count) * (high - low);
  return [
    [...axes(), "loops", "periods", "impacts a period", "rests at the wall"],
    ...cells.filter(([, , loops]) => loops !== undefined).map(([column, row, loops, periods, impacts, rests]) => [at(view.primary, column, columns), at(view.secondary, row, rows), loops, periods, impacts, rests ? 1 : 0]),
  ];
}

const curves = () => [
  ["curve", "p", "n", ...axes(), "bounds"],
  ...[...diagram.curves.values()].flatMap(({ key, p, n, points, bounds }) => points.map((point, index) => [key, p, n, ...point, bounds[index] ? 1 : 0])),
];

/** The rows of branches point by point, bifurcations and simulated dots. */
function along() {
  const { strands, bifurcations, dots, fixed, ordinate } = cut.shown();
  const across = axes()[fixed === "secondary" ? 0 : 1];
  return [
    ["what", "branch", "p", across, ordinate.name === "x" ? length() : `${ordinate.name}${unit(ordinate.unit)}`, "stability", "admissible"],
    ...strands.flatMap(({ p, points }, branch) => points.map(([at, x, stability, admissible]) => ["branch", branch + 1, p, at, x, stability, admissible])),
    ...bifurcations.map(({ kind, p, at, x }) => [kind, null, p, at, x, null, null]),
    ...dots.map(([at, x]) => ["simulated", null, null, at, x, null, null]),
  ];
}

function motion() {
  const { attractors, period } = place.told();
  return [
    ["attractor", "what", `t${unit(description.units.time)}`, "t / T", length(), `v${speed()}`],
    ...attractors.flatMap(({ orbit, motion }, index) => (orbit ?? []).flat().map(([t, x, v]) => [index + 1, motion, t, t / period, x, v])),
  ];
}

const impacts = () => [
  ["attractor", "what", "phase of impact (rad)", `velocity of impact${speed()}`],
  ...place.told().attractors.flatMap(({ strikes, motion }, index) => (strikes ?? []).map(([velocity, phase]) => [index + 1, motion, phase, velocity])),
];

const hasPlace = () => place.told() !== null;
const ofPlace = (name) => document.querySelector(`.place:not(.kept) .${name}`);

/** The pictures: the canvas, the function that draws it, its numbers, and whether it is there. */
const PICTURES = {
  plane: { canvas: () => $("plane"), draw: drawPlane, rows: () => (state.get().overlay ? simulated() : curves()), is: () => diagram.curves.size > 0 },
  cut: { canvas: () => $("cut"), draw: cut.draw, rows: along, is: () => Boolean(state.get().cut && cut.shown()) },
  series: { canvas: () => ofPlace("time"), draw: place.draw, rows: motion, is: hasPlace },
  portrait: { canvas: () => ofPlace("phase"), draw: place.draw, rows: motion, is: hasPlace },
  impacts: { canvas: () => ofPlace("strikes"), draw: place.draw, rows: impacts, is: hasPlace },
};

/** Whether a picture is there. */
export const isSeen = (name) => PICTURES[name].is();

const cell = (value) => (value === null || value === undefined ? "" : typeof value === "string" && /[",\n]/.test(value) ? `"${value.replace(/"/g, '""')}"` : String(value));

/** A file of a picture: `svg`, `png` or `csv`. */
export async function fileOf(name, kind) {
  const { canvas: find, draw, rows } = PICTURES[name];
  if (kind === "csv") return new Blob([rows().map((row) => `${row.map(cell).join(",")}\n`).join("")], { type: "text/csv" });
  const canvas = find();
  const { clientWidth: width, clientHeight: height } = canvas;
  if (kind === "svg") {
    const context = new SvgContext(width, height);
    context.fillStyle = inks().paper;
    context.fillRect(0, 0, width, height);
    drawnOn(canvas, context, draw);
    return new Blob([context.text()], { type: "image/svg+xml" });
  }
  const sheet = document.createElement("canvas");
  Object.assign(sheet, { width: FINE * width, height: FINE * height });
  const context = sheet.getContext("2d");
  context.scale(FINE, FINE);
  context.fillStyle = inks().paper;
  context.fillRect(0, 0, width, height);
  drawnOn(canvas, context, draw);
  return new Promise((told) => sheet.toBlob(told, "image/png"));
}

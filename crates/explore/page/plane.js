// Drawing the plane of parameters.
import { begin } from "./busy.js";
import { $, later } from "./dom.js";
import { chart, clipped, clippedRing, font, into, trace, write } from "./axes.js";
import { diagram, strength } from "./diagram.js";
import { followed } from "./follow.js";
import { LOOKS } from "./kinds.js";
import { placeLabels } from "./labels.js";
import { axisPieces } from "./markup.js";
import { drawMeasured, points as measured } from "./measured.js";
import { description, viewOf, wholeView } from "./model.js";
import { inks, penOf, wordInk } from "./palette.js";
import * as state from "./state.js";

/** The frame of the axes in pixels of the canvas. */
export const frame = { x: 0, y: 0, w: 1, h: 1 };
/** The drawing under the curves that replaces the shading: painter(context, project), set by the overlay. */
let overlay = null;
export const setOverlay = (painter) => (overlay = painter);
/** A zoom box while it is drawn, in pixels, and the place of the pointer in the cut, in parameters. */
export const shown = { box: null, pointer: null };

/** The runs of curves as last drawn, for pointing at them. */
export let runs = [];
let labels = { key: "", placed: -1e9, list: [] };
/** The labels as last placed: [{ text, at (parameters), kind }]. */
export const words = () => labels.list;
let asked = null;

/** Requests a redraw at the next frame. */
export function redraw() {
  if (asked) return;
  asked = begin();
  requestAnimationFrame(() => {
    const end = asked;
    asked = null;
    try {
      draw();
    } finally {
      end();
    }
  });
}

/** The margins, with room for the numbers; the cut under the plane has the same. */
export function margins(width) {
  return width < 520 ? { left: 56, right: 12, top: 8, bottom: 46 } : { left: 70, right: 18, top: 10, bottom: 50 };
}

export const project = ({ primary, secondary }) => into(frame, primary, secondary);

export function toParameters(x, y, { primary: [a, b], secondary: [c, d] } = viewOf(state.get())) {
  return [a + ((x - frame.x) / frame.w) * (b - a), c + ((frame.y + frame.h - y) / frame.h) * (d - c)];
}

/** The title of an axis and its unit. */
export const titleOf = (axis) => ({ title: axisPieces(axis), unit: axis.unit });

/** A pattern of thin slanted lines. */
function hatching(context, ink) {
  const side = 7;
  const tile = document.createElement("canvas");
  Object.assign(tile, { width: side * 2, height: side * 2 });
  const pen = tile.getContext("2d");
  pen.scale(2, 2);
  pen.strokeStyle = ink.hatching;
  pen.lineWidth = 0.8;
  for (const shift of [-side, 0, side]) {
    pen.moveTo(shift, side);
    pen.lineTo(shift + side, 0);
  }
  pen.stroke();
  const pattern = context.createPattern(tile, "repeat");
  pattern.setTransform(new DOMMatrix().scale(0.5));
  return pattern;
}

function drawRegions(context, regions, ink) {
  context.globalAlpha = strength(diagram.of.regions);
  for (const kind of ["non-impacting", "several-impacts", "mps", "undecided"]) {
    const own = regions.filter((region) => region.kind === kind);
    if (own.length === 0) continue;
    context.fillStyle = { mps: ink.stable, "several-impacts": ink.area, undecided: hatching(context, ink) }[kind] ?? ink.calm;
    for (const region of own) {
      context.beginPath();
      for (const ring of region.rings) trace(context, ring, true);
      context.fill("evenodd");
    }
  }
  context.globalAlpha = 1;
}

/** Greys out where the oscillator is not valid. */
function drawInvalid(context, to, ink) {
  if (!diagram.part) return;
  context.fillStyle = ink.faint;
  context.globalAlpha = strength(diagram.part.of);
  context.beginPath();
  for (const { primary: [a, b], secondary: [c, d] } of [diagram.part.whole, diagram.part.view]) {
    const [[left, bottom], [right, top]] = [to([a, c]), to([b, d])];
    context.rect(left, top, right - left, bottom - top);
  }
  context.fill("evenodd");
  context.globalAlpha = 1;
}

function drawCurves(context) {
  context.lineJoin = "round";
  for (const { curve, points, bounds } of [...runs].sort((a, b) => LOOKS[a.curve.kind].layer - LOOKS[b.curve.kind].layer || (a.curve.source === "quadratic") - (b.curve.source === "quadratic"))) {
    const pen = penOf(curve, bounds);
    context.strokeStyle = pen.colour;
    context.setLineDash(pen.dashes);
    context.lineWidth = pen.width;
    context.globalAlpha = strength(curve.of);
    context.beginPath();
    trace(context, points);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.setLineDash([]);
}

function drawPoints(context, to, ink) {
  context.fillStyle = ink.marker;
  context.strokeStyle = ink.rim;
  context.lineWidth = 1;
  context.globalAlpha = strength(diagram.of.points);
  for (const point of [...diagram.points].sort((a, b) => (a.kind === "resonance") - (b.kind === "resonance"))) {
    const [x, y] = to([point.primary, point.secondary]);
    if (!inFrame(x, y, 6)) continue;
    context.beginPath();
    if (point.kind === "resonance") trace(context, [[x, y - 6], [x + 5.4, y + 3.6], [x - 5.4, y + 3.6]], true);
    else context.arc(x, y, 3.4, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** The ends where curves were not followed farther: [{ at, why }]. */
export const ends = () =>
  [...diagram.curves.values(), ...followed()].flatMap(({ points, lost }) => [0, points.length - 1].flatMap((index, end) => (lost?.[end] ? [{ at: points[index], why: lost[end] }] : [])));

function drawEnds(context, to, ink) {
  context.fillStyle = ink.rim;
  context.strokeStyle = ink.marker;
  context.lineWidth = 1.2;
  for (const { at } of ends()) {
    context.beginPath();
    context.arc(...to(at), 3.4, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

const inFrame = (x, y, margin = 0) => x >= frame.x - margin && x <= frame.x + frame.w + margin && y >= frame.y - margin && y <= frame.y + frame.h + margin;

/** Draws a cross at the place with a ring; the kept one has a square. */
function drawPlace(context, place, to, colour, kept) {
  const [x, y] = to(place);
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.globalAlpha = 0.55;
  context.setLineDash([2, 3]);
  context.beginPath();
  trace(context, [[frame.x, y], [frame.x + frame.w, y]]);
  trace(context, [[x, frame.y], [x, frame.y + frame.h]]);
  if (!kept) context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
  context.lineWidth = 2;
  context.fillStyle = inks().paper;
  context.beginPath();
  if (kept) context.rect(x - 5, y - 5, 10, 10);
  else context.arc(x, y, 6, 0, 2 * Math.PI);
  context.globalAlpha = 0.7;
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
}

function drawCut(context, value, to, ink) {
  if (!value.cut || !value.place) return;
  const [x, y] = to(value.place);
  context.strokeStyle = ink.ink;
  context.lineWidth = 2;
  context.beginPath();
  trace(context, value.cut === "secondary" ? [[frame.x, y], [frame.x + frame.w, y]] : [[x, frame.y], [x, frame.y + frame.h]]);
  context.stroke();
  if (shown.pointer === null) return;
  const [px, py] = to(value.cut === "secondary" ? [shown.pointer, value.place[1]] : [value.place[0], shown.pointer]);
  context.fillStyle = ink.ink;
  context.beginPath();
  context.arc(px, py, 4, 0, 2 * Math.PI);
  context.fill();
}

/**
 * The size of a view, as a share of the plane, below which quadratic approximations are shown: they are good only near
 * resonances.
 */
const MAGNIFIED = 0.4;

function isMagnified(view) {
  const whole = wholeView();
  const part = (axis) => (view[axis][1] - view[axis][0]) / (whole[axis][1] - whole[axis][0]);
  return Math.min(part("primary"), part("secondary")) < MAGNIFIED;
}

/** The parts of curves in view, cut where a curve stops bounding a region. */
function runsInView(to, magnified) {
  const box = [frame.x - 6, frame.y - 6, frame.x + frame.w + 6, frame.y + frame.h + 6];
  const found = [];
  for (const curve of [...diagram.curves.values(), ...followed()]) {
    if (curve.source === "quadratic" && !magnified) continue;
    const pixels = curve.points.map(to);
    let from = 0;
    for (let at = 1; at <= pixels.length; at += 1) {
      if (at < pixels.length && curve.bounds[at] === curve.bounds[from]) continue;
      const part = pixels.slice(from, Math.min(at + 1, pixels.length));
      for (const points of clipped(part, box)) found.push({ curve, points, bounds: curve.bounds[from] ?? true });
      from = at;
    }
  }
  return found;
}

export function draw() {
  if (!description) return;
  const ink = inks();
  const value = state.get();
  const view = viewOf(value);
  const axes = { x: { range: view.primary, ...titleOf(description.primary) }, y: { range: view.secondary, ...titleOf(description.secondary) } };
  const made = chart($("plane"), margins, axes, ink);
  if (!made) return;
  const { context, to, end } = made;
  Object.assign(frame, made.frame);
  const box = [frame.x - 20, frame.y - 20, frame.x + frame.w + 20, frame.y + frame.h + 20];
  const regions = diagram.regions.map((region) => ({ ...region, rings: region.rings.map((ring) => clippedRing(ring.map(to), box)).filter((ring) => ring.length > 2) }));
  const magnified = isMagnified(view);
  $("quadratic").hidden = !magnified;
  runs = runsInView(to, magnified);
  drawInvalid(context, to, ink);
  drawRegions(context, regions, ink);
  if (overlay) overlay(context, view);
  drawCurves(context);
  drawCut(context, value, to, ink);
  drawPoints(context, to, ink);
  drawEnds(context, to, ink);
  drawMeasured(context, to, ink);
  if (!overlay) drawLabels(context, regions, to, view, ink);
  if (value.kept) drawPlace(context, value.kept, to, ink.muted, true);
  if (value.place) drawPlace(context, value.place, to, ink.place, false);
  if (shown.box) drawBox(context, shown.box, ink);
  end();
  moveHandle(value, to);
}

/**
 * The interval in milliseconds at which labels find new places; between, they stay at their parameters while the plane
 * moves.
 */
const SETTLES = 200;

function drawLabels(context, regions, to, view, ink) {
  const key = `${diagram.version} ${measured().length} ${followed().length && followed()[0].name} ${frame.w} ${frame.h} ${JSON.stringify(view)}`;
  const passed = performance.now() - labels.placed;
  if (labels.key !== key && passed >= SETTLES) {
    const points = [...diagram.points.map(({ primary, secondary }) => [primary, secondary]), ...measured().map(({ at }) => at)].map(to);
    const before = labels.list.map((each) => ({ ...each, x: to(each.at)[0], y: to(each.at)[1] }));
    const list = placeLabels(frame, runs, regions, points, before);
    labels = { key, placed: performance.now(), list: list.map((each) => ({ ...each, at: toParameters(each.x, each.y, view) })) };
  } else if (labels.key !== key) later(SETTLES - passed, redraw);
  context.textBaseline = "alphabetic";
  for (const { text, at, kind, key: own } of labels.list) {
    const [x, y] = to(at);
    if (!inFrame(x, y)) continue;
    context.globalAlpha = strength(kind === "region" ? diagram.of.regions : (diagram.curves.get(own) ?? followed()[0])?.of);
    context.fillStyle = kind === "region" ? ink.ink : wordInk(kind);
    write(context, text, x, y + 5, 15, 0.5);
  }
  context.globalAlpha = 1;
  context.font = font(13);
}

function drawBox(context, [ax, ay, bx, by], ink) {
  context.strokeStyle = ink.place;
  context.lineWidth = 1.5;
  context.setLineDash([5, 3]);
  context.strokeRect(Math.min(ax, bx), Math.min(ay, by), Math.abs(bx - ax), Math.abs(by - ay));
  context.setLineDash([]);
}

/** Moves the handle for fingers, which scroll the page elsewhere on the plane. */
function moveHandle(value, to) {
  const handle = $("handle");
  const at = value.place ? to(value.place) : null;
  handle.hidden = !at || !inFrame(...at);
  if (!handle.hidden) handle.style.transform = `translate(${at[0]}px, ${at[1]}px)`;
}

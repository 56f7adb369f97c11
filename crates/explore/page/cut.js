// The cut: motion along a line through the place, as a one-parameter diagram under the plane. Both are linked: the
// plane shows the line, and pointing here moves the place.
import { $, coordinate, make, rested } from "./dom.js";
import { chart, clipped, trace, write } from "./axes.js";
import { Latest, stream } from "./api.js";
import { description, modelOf, viewOf } from "./model.js";
import { margins, redraw, shown as marks, titleOf } from "./plane.js";
import { showPlane, told } from "./place.js";
import { heightTitle } from "./portraits.js";
import { curveInk, inks, loopsInk, loopsNames, onTheme, solutionInk, wordInk } from "./palette.js";
import * as state from "./state.js";

/**
 * A dot's height in pixels; its width is the spacing of the values of the parameter, which leaves no gaps between them.
 */
const DOT = 1.4;
/** The opacity of a single dot. */
const FAINTEST = 0.4;

const latest = new Latest({ pause: 100, patience: 600, failed: (error) => fail(error) });
let answer = null;
let asked = "";
let frame = null;

const say = (words) => {
  $("cut-message").textContent = words;
  $("cut-message").hidden = words === "";
};

function fail({ message }) {
  $("cut").removeAttribute("aria-busy");
  asked = "";
  say(message);
  draw();
}

/** The axis along the cut: its name and its place in a pair. */
const along = (value) => (value.cut === "secondary" ? ["primary", 0] : ["secondary", 1]);

function bodyOf(value) {
  const [axis, at] = along(value);
  return { model: modelOf(value), fixed: value.cut, at: value.place[1 - at], range: viewOf(value)[axis], ordinate: ordinateOf(value).name };
}

/** The ordinate: { name, unit }; x, if the oscillator lacks the chosen one. */
const ordinateOf = (value) => description.ordinates.find(({ name }) => name === value.ordinate) ?? description.ordinates[0];
const upTitle = (ordinate) => (ordinate.name === "x" ? heightTitle() : { title: [[ordinate.name, ""]], unit: ordinate.unit });

/** The line through the place, for a request; null without one. */
export function wanted() {
  const value = state.get();
  if (!value.cut || !value.place) return null;
  const { fixed, at, range, ordinate } = bodyOf(value);
  return { cut: { fixed, at, range, ordinate } };
}

/** The menu of ordinates. */
function offer(value) {
  const names = description.ordinates.map(({ name }) => name);
  if (names.join() !== [...$("ordinate").options].map((option) => option.value).join()) $("ordinate").replaceChildren(...names.map((name) => make("option", { value: name }, name)));
  $("ordinate").value = ordinateOf(value).name;
}

/** A key of what the strands depend on, whatever part of them is in view. */
const ofBody = ({ model, fixed, at, ordinate }) => JSON.stringify([model, fixed, at, ordinate]);

const request = rested(200, () => {
  const value = state.get();
  if (!value.cut || !value.place) return;
  const body = bodyOf(value);
  const ordinate = ordinateOf(value);
  const key = JSON.stringify(body);
  if (key === asked) return;
  say("");
  $("cut").setAttribute("aria-busy", "true");
  draw();
  latest.now(async (signal) => {
    // Branches first; the dots of the last cut stay below them until those of this one arrive.
    const take = (told) => {
      if (signal.aborted) return;
      const last = answer?.fixed === body.fixed && answer.ordinate.name === body.ordinate ? answer : { dots: [] };
      answer = { ...last, ...told, fixed: body.fixed, ordinate, at: body.at, of: ofBody(body), old: !told.dots };
      say("");
      legend(answer);
      draw();
    };
    await stream("cut", body, { branches: take, dots: take }, signal);
    asked = key;
    $("cut").removeAttribute("aria-busy");
  });
});

/**
 * The data of the cut: strands, bifurcations and dots, the value of the fixed parameter, and whether dots are still
 * those of the last one.
 */
export const shown = () => answer;

export function follow(value) {
  const on = value.cut !== null && value.place !== null;
  const opens = on && $("cut-panel").hidden;
  $("cut-panel").hidden = !on;
  document.body.classList.toggle("cutting", on);
  if (opens) showPlane();
  for (const name of ["primary", "secondary"]) {
    document.querySelector(`[data-command="${name === "secondary" ? "horizontal" : "vertical"}"]`).setAttribute("aria-pressed", value.cut === name);
  }
  if (!on) {
    latest.stop();
    request.cancel();
    return;
  }
  offer(value);
  request();
  draw();
}

export function draw() {
  const value = state.get();
  if (!value.cut || !value.place || $("cut-panel").hidden) return;
  const ink = inks();
  const [axis, at] = along(value);
  const range = viewOf(value)[axis];
  const ordinate = ordinateOf(value);
  const own = answer?.fixed === value.cut && answer.ordinate.name === ordinate.name ? answer : null;
  const axes = { x: { range, ...titleOf(description[axis]) }, y: { range: own?.frame ?? [-1, 1], ...upTitle(ordinate) } };
  const made = chart($("cut"), margins, axes, ink);
  if (!made) return;
  const { context, to, end } = made;
  frame = made.frame;
  const canvas = $("cut");
  canvas.setAttribute("aria-valuemin", range[0]);
  canvas.setAttribute("aria-valuemax", range[1]);
  canvas.setAttribute("aria-valuenow", value.place[at]);
  canvas.setAttribute("aria-valuetext", `${description[axis].name} ${coordinate(value.place[at], range[1] - range[0])}`);
  if (own) drawFound(context, own, to, ink, own.of === ofBody(bodyOf(value)) ? 1 : 0.25);
  else if (canvas.hasAttribute("aria-busy")) {
    context.fillStyle = ink.muted;
    write(context, [["computing …", "italic"]], frame.x + frame.w / 2, frame.y + frame.h / 2, 15, 0.5);
  }
  const line = (p, colour, dashes) => {
    const [x] = to([p, 0]);
    context.strokeStyle = colour;
    context.lineWidth = 1.2;
    context.setLineDash(dashes);
    context.beginPath();
    trace(context, [[x, frame.y], [x, frame.y + frame.h]]);
    context.stroke();
    context.setLineDash([]);
  };
  line(value.place[at], ink.place, []);
  // The solutions at the place, if velocities are the ordinate.
  if (ordinate.name === "impact velocity") {
    for (const solution of told()?.solutions ?? []) {
      const velocities = solution.p === 0 ? [0] : solution.known.impacts.map(([velocity]) => velocity);
      for (const velocity of velocities) ring(context, to([value.place[at], velocity]), solutionInk(solution, ink));
    }
  }
  if (marks.pointer !== null) line(marks.pointer, ink.muted, [3, 3]);
  end();
}

function ring(context, [x, y], colour) {
  context.strokeStyle = colour;
  context.lineWidth = 1.6;
  context.beginPath();
  context.arc(x, y, 4.5, 0, 2 * Math.PI);
  context.stroke();
}

/** Simulated dots, stronger where several fall together. */
function drawDots(context, dots, values, to, ink, strength) {
  const counts = new Map();
  const [[left], [right]] = [dots[0] ?? [0], dots.at(-1) ?? [0]].map(([p]) => to([p, 0]));
  const wide = Math.max(DOT, Math.abs(right - left) / Math.max(1, values - 1));
  for (const dot of dots) {
    const [x, y] = to(dot);
    const key = `${x} ${Math.round(y / DOT)}`;
    const cell = counts.get(key) ?? { x, y: Math.round(y / DOT) * DOT, count: 0 };
    cell.count += 1;
    counts.set(key, cell);
  }
  context.fillStyle = ink.ink;
  for (const { x, y, count } of counts.values()) {
    context.globalAlpha = strength * (1 - (1 - FAINTEST) ** count);
    context.fillRect(x - wide / 2, y - DOT / 2, wide, DOT);
  }
}

/** The widths of branches by their stability, in pixels of the page. */
const WIDTHS = { stable: 2.4, unstable: 0.9, neutral: 1.6 };

/** The legend of the lines and marks of the cut, and the simulated orbits that are left out. */
function legend({ strands, left_out: leftOut = [] }) {
  const ink = inks();
  const line = (colour, width, dashes = "none", opacity = 1) => {
    const path = make("path", { d: "M1 5h26" });
    Object.assign(path.style, { stroke: colour, strokeWidth: width, strokeDasharray: dashes, opacity });
    return make("svg", { viewBox: "0 0 28 10", "aria-hidden": "true" }, path);
  };
  const several = (strand) => strand.impacts > 1;
  const numbers = [...new Set(strands.filter((strand) => !several(strand)).map(({ p }) => Math.min(p, ink.loops.length - 1)))].sort();
  const entries = [
    ...numbers.map((p) => [line(loopsInk(p, ink), WIDTHS.stable), loopsNames()[p]]),
    ...(strands.some(several) ? [[line(ink.several, WIDTHS.stable), "several impacts (impacts/periods)"]] : []),
    [line(ink.ink, WIDTHS.unstable), "unstable"],
    ...(strands.some(({ points }) => points.some(([, , stability]) => stability === "neutral")) ? [[line(ink.ink, WIDTHS.neutral, "9 2"), "neutral"]] : []),
    [line(ink.ink, WIDTHS.unstable, "3 3", 0.6), "hits the wall in between"],
    [line(ink.ink, 3, "none", FAINTEST), "simulated"],
  ];
  $("cut-legend").replaceChildren(...entries.map(([sample, word]) => make("li", {}, sample, word)), ...(leftOut ?? []).map((words) => make("li", {}, `Left out: ${words}`)));
}

function drawFound(context, { fixed, strands, bifurcations, dots, values, old }, to, ink, strength) {
  drawDots(context, dots, values, to, ink, old ? 0.25 : strength);
  context.globalAlpha = 1;
  const box = [frame.x - 5, frame.y - 5, frame.x + frame.w + 5, frame.y + frame.h + 5];
  for (const { p, impacts, points } of strands) {
    let from = 0;
    for (let at = 1; at <= points.length; at += 1) {
      const same = at < points.length && points[at][2] === points[from][2] && points[at][3] === points[from][3];
      if (same) continue;
      const [, , stability, admissible] = points[from];
      context.strokeStyle = solutionInk({ p, impacts }, ink);
      context.globalAlpha = (admissible ? 1 : 0.45) * strength;
      context.lineWidth = admissible ? WIDTHS[stability] : WIDTHS.unstable;
      context.setLineDash(!admissible ? [3, 3] : stability === "neutral" ? [9, 2] : []);
      context.beginPath();
      for (const run of clipped(points.slice(from, at + 1).map(to), box)) trace(context, run);
      context.stroke();
      from = at;
    }
  }
  context.globalAlpha = strength;
  context.setLineDash([]);
  const taken = [];
  for (const { kind, p, impacts, primary, secondary, x } of bifurcations) {
    const [px, py] = to([fixed === "primary" ? secondary : primary, x]);
    context.beginPath();
    context.arc(px, py, 3.6, 0, 2 * Math.PI);
    context.fillStyle = curveInk(kind) ?? ink.marker;
    context.strokeStyle = ink.rim;
    context.fill();
    context.stroke();
    const of = impacts > 1 ? [[`${impacts}/${p}`, ""]] : [["p", "italic"], [` = ${p}`, ""]];
    const words = kind === "graz" ? [["grazing", ""]] : [[`${kind} `, ""], ...of];
    const wide = kind === "graz" ? 48 : 56;
    // To the right and above if possible; omitted if it would hide another.
    const corners = [[7, -6], [7, 15], [-7 - wide, -6], [-7 - wide, 15]].map(([dx, dy]) => [px + dx, py + dy]);
    const free = ([left, low]) => left > frame.x && left + wide < frame.x + frame.w && low > frame.y + 12 && low < frame.y + frame.h && taken.every(([x, y]) => Math.abs(x - left) > wide || Math.abs(y - low) > 13);
    const corner = corners.find(free);
    if (!corner) continue;
    taken.push(corner);
    // Dots and strands do not cross the labels, which are darker than a line may be.
    context.globalAlpha = 0.75 * strength;
    context.fillStyle = ink.paper;
    context.fillRect(corner[0] - 2, corner[1] - 10, wide - 10, 13);
    context.globalAlpha = strength;
    context.fillStyle = wordInk(kind) ?? ink.marker;
    write(context, words, ...corner, 12);
  }
  context.globalAlpha = 1;
}

export function attach() {
  const canvas = $("cut");
  const parameter = (event) => {
    const [axis] = along(state.get());
    const [low, high] = viewOf(state.get())[axis];
    const part = (event.clientX - canvas.getBoundingClientRect().left - frame.x) / frame.w;
    return low + Math.min(1, Math.max(0, part)) * (high - low);
  };
  const put = (p) => {
    const value = state.get();
    const [, at] = along(value);
    const place = [...value.place];
    place[at] = p;
    state.update({ place }, true);
  };
  let held = false;
  canvas.addEventListener("pointerdown", (event) => {
    if (!frame || event.button !== 0) return;
    held = true;
    canvas.setPointerCapture(event.pointerId);
    put(parameter(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!frame) return;
    marks.pointer = parameter(event);
    if (held) put(marks.pointer);
    else draw();
    redraw();
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => (held = false));
  canvas.addEventListener("pointerleave", () => {
    marks.pointer = null;
    draw();
    redraw();
  });
  canvas.addEventListener("keydown", (event) => {
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!way || event.altKey || event.ctrlKey) return;
    event.preventDefault();
    const value = state.get();
    const [axis, at] = along(value);
    const [low, high] = viewOf(value)[axis];
    put(Math.min(high, Math.max(low, value.place[at] + way * (event.shiftKey ? 0.1 : 0.01) * (high - low))));
  });
  $("ordinate").addEventListener("change", ({ target }) => state.update({ ordinate: target.value === "x" ? null : target.value }));
  new ResizeObserver(draw).observe(canvas);
  onTheme(() => {
    draw();
    if (answer) legend(answer);
  });
}

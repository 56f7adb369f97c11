// The diagram: requested coarse during dragging and in full at rest; curves arrive as they are found.
import { $, count, later, make, number, rested } from "./dom.js";
import { Latest, stream } from "./api.js";
import { isNumbered, lasting } from "./lasting.js";
import { axisPieces, elements, plain } from "./markup.js";
import { description, modelOf, noteOf, viewOf } from "./model.js";
import { drawSamples } from "./palette.js";
import * as state from "./state.js";

/**
 * The current diagram. Each curve names the model that it belongs to, `of` names those of points and regions; contents
 * that do not belong to the wanted model are faded.
 */
export const diagram = {
  curves: new Map(), points: [], regions: [], resonances: [], notes: [], part: null, of: { points: "", regions: "" }, wanted: "", version: 0,
  get stale() {
    return this.of.regions !== this.wanted;
  },
};

const RESTS = 200;
/** The greatest delay of the diagram during dragging, in milliseconds. */
const BEHIND = 300;
/** The slowest of the examples takes 1.5 s for a coarse diagram. */
const COARSE = { pause: 100, patience: 4000 };
let changed = () => {};
export const onDiagram = (act) => (changed = act);

const failed = (error) => {
  finish();
  say(`Not drawn. ${error.message}`, true);
};
const latest = new Latest({ ...COARSE, failed });

/** Whether a diagram is being computed. */
export const isBusy = () => latest.running !== null;

/** The key of the diagram in view if it was computed in full, so that nothing is computed twice; and its summary. */
let computed = "";
/** Whether the diagram of the state is there in full. */
export const isWhole = () => computed !== "" && computed === JSON.stringify(request(state.get(), false));
let summary = "";
/** The curves known only by a number, as last seen: a coarse diagram has few of them. */
let numbered = [];

/** The opacity of contents that belong to a model. */
export const strength = (of) => (of === diagram.wanted ? 1 : 0.22);

const wantedOf = (value) => JSON.stringify(modelOf(value));

/** The wanted model while a file is being edited: it has no name yet. */
export const TYPED = null;

let behind = null;
/** Makes another model the wanted one: that of the state, or one that is being edited. */
export function want(of = wantedOf(state.get())) {
  behind?.();
  behind = null;
  document.body.classList.toggle("typed", of === TYPED);
  if (of === diagram.wanted) return;
  diagram.wanted = of;
  changed();
}

export function clear() {
  latest.stop();
  rest.cancel();
  computed = "";
  numbered = [];
  diagram.curves.clear();
  Object.assign(diagram, { points: [], regions: [], resonances: [], notes: [], part: null, version: diagram.version + 1 });
  list();
  changed();
}

/** The part of the view that is drawn. */
export const drawnView = (value) => (diagram.part?.of === wantedOf(value) && JSON.stringify(diagram.part.whole) === JSON.stringify(viewOf(value)) ? diagram.part.view : viewOf(value));

/** Shows words beside the progress line. */
export function say(words, bad = false) {
  $("progress-text").textContent = $("progress-text").title = words;
  $("progress-text").classList.toggle("bad", bad);
}

/** Says again what the diagram in view is, if nothing is being computed. */
export function resay() {
  if (!isBusy()) say(summary);
}

function finish() {
  $("progress").hidden = true;
  $("stop").hidden = true;
}

export function stop() {
  if ($("stop").hidden) return;
  latest.stop();
  rest.cancel();
  finish();
  say("Stopped. What was found so far is shown.");
}

function request(value, coarse) {
  return { model: modelOf(value), view: viewOf(value), coarse };
}

/** What is not drawn of the view, and why. */
function notDrawn({ view, reason }, whole) {
  const cut = ["primary", "secondary"].filter((axis) => [0, 1].some((end) => view[axis][end] !== whole[axis][end]));
  const ranges = cut.map((axis) => `${plain(axisPieces(description[axis]))} from ${view[axis].map((value) => number(value, 3)).join(" to ")}`);
  return `Drawn for ${ranges.join(", ")} alone. Elsewhere periods are too long, or ${reason}.`;
}

const job = (body) => async (signal) => {
  const { coarse, view } = body;
  const of = JSON.stringify(body.model);
  const bar = $("progress");
  const seen = new Set();
  const names = new Map();
  let latestNotes = [];
  let nothing = null;
  let part = null;
  // While something else is being edited, the words are about that.
  const tell = (words) => diagram.wanted === TYPED || say(words);
  if (!coarse) {
    bar.removeAttribute("value");
    bar.hidden = false;
    $("stop").hidden = false;
    tell("Computing …");
  }
  const drop = () => {
    for (const key of diagram.curves.keys()) if (!seen.has(key)) diagram.curves.delete(key);
  };
  const on = {
    progress({ stage, done, all }) {
      if (coarse) return;
      if (all > 0) Object.assign(bar, { max: all, value: done });
      const words = stage.charAt(0).toUpperCase() + stage.slice(1);
      tell(all > 0 ? `${words}, ${done} of ${all}` : words);
    },
    curves(list) {
      computed = "";
      for (const [key, name] of lasting(list, numbered, view)) names.set(key, name);
      for (const curve of list) {
        const key = names.get(curve.key) ?? curve.key;
        seen.add(key);
        diagram.curves.set(key, { ...curve, key, of });
      }
    },
    keys(keys) {
      seen.clear();
      for (const key of keys) seen.add(names.get(key) ?? key);
    },
    points(points) {
      diagram.points = points;
      diagram.of.points = of;
    },
    regions(regions) {
      diagram.regions = regions;
      diagram.of.regions = of;
    },
    resonances(resonances) {
      diagram.resonances = resonances;
      if (!coarse) list();
    },
    notes(notes) {
      latestNotes = notes;
    },
    nothing(reason) {
      nothing = reason;
    },
    part(told) {
      part = told;
      diagram.part = { view: told.view, whole: view, of };
    },
    done({ seconds }) {
      drop();
      numbered = [...(coarse ? numbered.filter(({ key }) => !seen.has(key)) : []), ...[...diagram.curves.values()].filter(isNumbered)];
      diagram.notes = [...(nothing ? [`${nothing.sentence}. ${nothing.question}`] : []), ...(part ? [notDrawn(part, view)] : []), ...latestNotes];
      if (!part) diagram.part = null;
      diagram.version += 1;
      finish();
      // If dragging has gone on meanwhile, the previous diagram is shown, unless it is too old; a diagram of a file
      // that has been edited since stays faded.
      if (diagram.wanted !== TYPED) {
        if (!coarse || behind || of === wantedOf(state.get())) diagram.wanted = of;
        if (of === wantedOf(state.get())) want(of);
      }
      if (!coarse) {
        computed = JSON.stringify(body);
        const curves = [...diagram.curves.values()].filter(({ source }) => source !== "quadratic").length;
        const took = seconds < 0.995 ? `${Math.round(1000 * seconds)} ms` : `${number(seconds, 3)} s`;
        summary = nothing ? `No grazing and no MPS curve in this view: ${nothing.found}.` : `${count(curves, "curve")} and ${count(diagram.points.length, "point")} in ${took}.`;
        if (part) summary += ` ${notDrawn(part, view)}`;
        tell(summary);
      }
      list();
    },
  };
  // A diagram that arrives within a pause is drawn only when it is complete.
  let drawn = performance.now();
  const noticed = Object.fromEntries(
    Object.entries(on).map(([name, act]) => [
      name,
      (data) => {
        if (signal.aborted) return;
        act(data);
        if (coarse && name !== "done" && performance.now() - drawn < COARSE.pause) return;
        drawn = performance.now();
        changed();
      },
    ]),
  );
  await stream("diagram", body, noticed, signal);
};

const rest = rested(RESTS, () => {
  const body = request(state.get(), false);
  if (JSON.stringify(body) !== computed) {
    latest.rested(job(body));
    return;
  }
  latest.stop();
  finish();
  resay();
});

/** Makes the diagram of the state the wanted one again, after something else was edited. */
export function resume() {
  want();
  rest();
}

/** Follows the state: `constants` is whether constants are being dragged. */
export function follow(value, live, constants) {
  if (!live) want();
  if (live && constants) {
    behind ??= later(BEHIND, () => want());
    computed = "";
    latest.live(job(request(value, true)));
  }
  rest();
}

/** The legend of the curves that the file asks for, and of ends. */
function legend() {
  const all = [...diagram.curves.values()];
  const own = new Map(all.filter(({ name }) => name).map(({ name, property }) => [name, property]));
  const line = () => make("svg", { viewBox: "0 0 28 10", "aria-hidden": "true" }, make("path", { class: "own", d: "M1 5h26" }));
  const ring = () => make("svg", { class: "mark", viewBox: "0 0 14 12", "aria-hidden": "true" }, make("circle", { class: "ring", cx: 7, cy: 6, r: 3.4 }));
  const entries = [...own].map(([name, property]) => make("li", { title: property }, line(), name));
  if (all.some(({ lost }) => lost?.some(Boolean))) entries.push(make("li", {}, ring(), "could not be followed further"));
  $("own-legend").replaceChildren(...entries);
  drawSamples();
}

/** The notes on the file that were shown last. */
let noted = "";

/** The tables under the plane: resonances, and notes: those on the file, and what is missing. */
export function list() {
  const { resonances } = diagram;
  const own = (description?.notes ?? []).map(noteOf);
  const notes = [...own, ...diagram.notes.map((note) => note.charAt(0).toUpperCase() + note.slice(1))];
  legend();
  // Those on the file are shown at once.
  if (description && own.join() !== noted) {
    noted = own.join();
    if (noted) $("notes").open = true;
  }
  $("notes-count").textContent = notes.length;
  $("notes").hidden = notes.length === 0;
  $("notes-list").replaceChildren(...notes.map((note) => make("li", {}, note)));
  $("resonances").hidden = resonances.length === 0;
  $("resonances-count").textContent = resonances.length;
  if (resonances.length === 0) return;
  const two = description.walls > 1;
  const coefficient = (kind) => make("th", { scope: "col" }, make("i", {}, "c"), make("sub", {}, kind));
  const head = make(
    "tr",
    {},
    make("th", { scope: "col" }, make("i", {}, "p")),
    ...(two ? [make("th", { scope: "col" }, "wall")] : []),
    make("th", { scope: "col" }, make("i", {}, "n")),
    make("th", { scope: "col" }, ...elements(axisPieces(description.primary))),
    make("th", { scope: "col" }, ...elements(axisPieces(description.secondary))),
    coefficient("SN"),
    coefficient("PD"),
    make("th", { scope: "col", class: "words" }, "Theorem"),
    make("th", { scope: "col" }, make("span", { class: "unseen" }, "Zoom")),
  );
  const rows = resonances.map((each) =>
    make(
      "tr",
      {},
      ...[each.p, ...(two ? [each.wall] : []), each.n ?? "–", number(each.primary, 6), number(each.secondary, 6), number(each.c_sn), number(each.c_pd)].map((cell) => make("td", {}, String(cell))),
      make("td", { class: `words ${each.theorem_holds ? "good" : "bad"}` }, each.theorem_holds ? "holds" : each.failing),
      make("td", {}, make("button", { type: "button", class: "small", onclick: () => zoomTo(each), "aria-label": `Zoom to the resonance p = ${each.p}, n = ${each.n}${two ? ` at wall ${each.wall}` : ""}` }, "Zoom")),
    ),
  );
  $("resonances-table").replaceChildren(make("thead", {}, head), make("tbody", {}, ...rows));
}

/** Centres a resonance, in a twelfth of the current view, or of the whole if it lies outside. */
function zoomTo({ primary, secondary }) {
  const view = viewOf(state.get());
  const about = (centre, [low, high]) => [centre - (high - low) / 24, centre + (high - low) / 24];
  state.update({ view: { primary: about(primary, view.primary), secondary: about(secondary, view.secondary) } });
  $("plane").focus();
}

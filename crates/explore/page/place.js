// Motion at a place of the plane: attractors, maximal periodic solutions, and their pictures. Two places can be shown
// side by side.
import { $, coordinate, count, make, multipliers, number, rested } from "./dom.js";
import { ask, Latest } from "./api.js";
import { axisPieces, elements } from "./markup.js";
import { description, modelOf, viewOf } from "./model.js";
import { attractorInks, onTheme, solutionInk } from "./palette.js";
import { drawPortraits } from "./portraits.js";
import { isFollowed } from "./follow.js";
import { nearest } from "./pick.js";
import { project } from "./plane.js";
import * as state from "./state.js";

/** The number of initial states in the search for attractors: fewer during dragging. */
const STATES = { live: 6, rest: 24 };
const LIVE = { pause: 30, patience: 1000 };
/** The number of forcing periods for which motion that does not settle is followed during dragging. */
const LIVE_PERIODS = 500;
const RESTS = 180;
/** The duration of an answer, in milliseconds, beyond which there are fewer than 20 a second. */
const SLOW = 45;
/** A key of what motion from a nearby place depends on: the oscillator and its numbers of loops, not its constants. */
const knownAs = ({ model: { text, loops } }) => JSON.stringify([text, loops]);
const SPEAKS = 900;
let speaking = 0;
/** Announces the results to screen readers once they are at rest; nothing visible waits for this. */
function speak(words) {
  clearTimeout(speaking);
  speaking = setTimeout(() => ($("announce").textContent = words), SPEAKS);
}

const KINDS = { "non-impacting": "No impacts", chaotic: "Chaos", resting: "Rests at the wall", escaping: "Escapes" };

/** Numbers of impacts, all and at the second of two walls: "2 impacts at wall 1 and 1 at wall 2". */
function struckAt(all, second) {
  const [first, other] = [all - second, second];
  if (first && other) return `${count(first, "impact")} at wall 1 and ${other} at wall 2`;
  return `${count(all, "impact")} at wall ${other ? 2 : 1}`;
}

/** The name of an attractor. */
function nameOf({ motion, periods, impacts, impacts_at_wall_2: second, rests, waited }) {
  if (motion === "unsettled") return `Not settled after ${waited} periods`;
  if (motion === "non-impacting" && periods > 1) return `No impacts, ${count(periods, "period")}`;
  if (motion !== "periodic") return KINDS[motion] ?? motion;
  if (description.walls > 1 && !rests && second !== null) return `Periodic: ${struckAt(Math.round(impacts * periods), Math.round(second * periods))} in ${count(periods, "period")}`;
  // Infinitely many impacts are null.
  const struck = Math.round((impacts ?? 0) * periods);
  if (rests) {
    const rest = rests * periods > 1.5 ? count(Math.round(rests * periods), "rest") : "a rest";
    return `Periodic: ${impacts === null ? `chatter and ${rest}` : `${count(struck, "impact")} and ${rest}`} in ${count(periods, "period")}`;
  }
  if (struck === 1) return `MPS, ${count(periods, "loop")}`;
  return `Periodic: ${count(struck, "impact")} in ${count(periods, "period")}`;
}

/** The numbers of impacts and periods of a solution, briefly: p, or with several impacts "3/2". */
const numbers = ({ p, impacts }) => (impacts > 1 ? `${impacts}/${p}` : String(p));

/** Whether a solution is stable, in a word. */
const stability = ({ stable }) => ({ true: "stable", false: "unstable" })[stable] ?? stable;
const isGood = ({ stable, admissible }) => stable === true && admissible;

/** The name of a solution with the velocity of its slowest impact. */
function nameOfSolution({ p, impacts, impact_velocity: velocity, known: { stops } }) {
  if (impacts === 0) return KINDS["non-impacting"];
  const kind = description.walls > 1 ? `${struckAt(impacts, stops.filter((stop) => stop === 1).length)} in ${count(p, "period")}` : impacts === 1 ? `MPS, ${count(p, "loop")}` : `${count(impacts, "impact")} in ${count(p, "period")}`;
  return `${kind}, velocity ${number(velocity, 3)}`;
}

const percent = (share) => `${Math.round(100 * share)} %`;
/** The keys of solutions, "p-k" for the k-th with this p, or "K/p-k". */
function keysOf(solutions) {
  const counts = new Map();
  return solutions.map((each) => {
    const own = numbers(each);
    counts.set(own, (counts.get(own) ?? 0) + 1);
    return `${own}-${counts.get(own)}`;
  });
}

/** The name of what a place can be moved onto. */
function nameOfNear({ point, curve }) {
  if (!point && curve.kind === "graz") return ["grazing"];
  const { kind, p } = point ?? curve;
  return [`${kind}, `, make("i", {}, "p"), ` = ${p}`];
}

/** One card: that of the place itself, or of the kept one. */
class Card {
  constructor(key) {
    this.key = key;
    this.answer = null;
    this.asked = "";
    /** The MPSs that are drawn although they may not attract, by p and their index among those with the same p. */
    this.drawn = new Set();
    this.latest = new Latest({ ...LIVE, failed: (error) => this.fail(error) });
    this.rest = rested(RESTS, () => this.request(false));
    this.build();
  }

  build() {
    const kept = this.key === "kept";
    const action = kept
      ? make("button", { type: "button", class: "small", onclick: () => state.update({ kept: null }) }, "Remove")
      : make("button", { type: "button", class: "small", "data-command": "keep", title: "Keep this place to compare it with another (K)" }, "Keep");
    this.at = make("p", { class: "at" });
    this.short = make("p", { class: "short" });
    this.on = make("p", { class: "on" });
    this.message = make("p", { class: "message bad", hidden: true });
    this.attractors = make("ul", { class: "attractors" });
    const picture = (name, label) => (this[name] = make("canvas", { class: `picture ${name}`, role: "img", "aria-label": label }));
    this.pictures = make("div", { class: "pictures" }, picture("time", "Time series"), picture("phase", "Phase portrait"), picture("strikes", "Impacts by phase and velocity"));
    this.table = make("tbody");
    const heads = [[make("i", {}, "p"), "Loops, or impacts/periods; press to draw"], ["velocity", "Impact velocity, the lowest of several"], ["multipliers", "Floquet multipliers"], ["stability", ""], ["admissible", "Whether the orbit stays clear of the wall between impacts"]];
    const head = make("tr", {}, ...heads.map(([word, title]) => make("th", { scope: "col", title: title || null }, word)));
    this.solutions = make("div", { class: "scroll" }, make("table", {}, make("caption", {}, "Periodic solutions"), make("thead", {}, head), this.table));
    this.follows = make("p", { class: "row", hidden: true });
    this.hint = make("p", { class: "muted", hidden: true }, "Followed from the previous place; a full search starts when the place rests.");
    this.body = make("div", { class: "card-body" }, this.pictures, this.attractors, this.hint, this.solutions, this.follows);
    this.element = make("article", { class: `place ${this.key}`, "aria-label": kept ? "Kept place" : "Place", hidden: true }, make("header", {}, make("div", {}, this.at, this.short), action), this.on, this.message, this.body);
    $("places").append(this.element);
    new ResizeObserver(() => this.draw()).observe(this.pictures);
    onTheme(() => this.answer && this.show());
  }

  /** Follows the state. */
  follow(value, live) {
    const place = value[this.key];
    this.element.hidden = !place;
    if (!place) {
      this.latest.stop();
      this.rest.cancel();
      this.asked = "";
      return;
    }
    this.title(place, value);
    this.age(value);
    if (live) this.latest.live(this.job(true));
    this.rest();
  }

  /** Fades results of another place or oscillator. */
  age(value) {
    this.element.classList.toggle("stale", this.answer !== null && this.told !== JSON.stringify([modelOf(value), value[this.key]]));
  }

  title(place, value) {
    const view = viewOf(value);
    const widths = [view.primary, view.secondary].map(([low, high]) => high - low);
    const told = [description.primary, description.secondary].map((axis, at) => [at ? ", " : "", ...elements(axisPieces(axis)), ` = ${coordinate(place[at], widths[at])}`, axis.unit ? ` ${axis.unit}` : ""]);
    this.at.replaceChildren(...told.flat());
    if (this.key === "place") this.offer(place, view);
  }

  /** Offers to go exactly onto something near, or describes it if the place is there. */
  offer(place, view) {
    if (JSON.stringify(this.exact?.at) === JSON.stringify(place)) {
      this.on.replaceChildren(...this.exact.words);
      return;
    }
    const near = nearest(place, project(view));
    this.on.replaceChildren(...(near ? [make("button", { type: "button", class: "small", onclick: () => this.go(near) }, "Go exactly onto ", ...nameOfNear(near))] : []));
  }

  /** Moves the place onto a curve or a point, where its multipliers are known. */
  async go({ point, curve, at, start }) {
    const value = state.get();
    try {
      const found = point
        ? { at: [point.primary, point.secondary], multipliers: point.multipliers }
        : await ask("exact", { model: modelOf(value), view: viewOf(value), kind: curve.kind, p: curve.p, wall: curve.wall, start, at });
      const words = ["Exactly on ", ...nameOfNear({ point, curve })];
      if (found.multipliers) words.push(`: multipliers ${multipliers(found.multipliers)}`);
      this.exact = { at: found.at, words };
      state.update({ place: found.at });
    } catch (error) {
      this.on.textContent = error.message;
    }
  }

  body_(live) {
    const value = state.get();
    const body = { model: modelOf(value), at: value[this.key], states: live ? STATES.live : STATES.rest, orbits: true };
    if (live) body.periods = LIVE_PERIODS;
    else if (this.longer?.of === JSON.stringify([body.model, body.at])) body.periods = this.longer.periods;
    // If a complete search takes too long, only known motion is followed during dragging.
    if (live && this.answer && this.slow && this.known === knownAs(body)) {
      const solutions = this.answer.solutions.filter(({ p }) => p > 0).map(({ known }) => known);
      body.nearby = { solutions, attractors: this.answer.attractors.map(({ states, state }) => [states, state]) };
    }
    return body;
  }

  request(live) {
    const body = this.body_(live);
    if (!body.at || JSON.stringify(body) === this.asked) return;
    this.latest.rested(this.job(live));
  }

  job(live) {
    const body = this.body_(live);
    return async (signal) => {
      this.element.setAttribute("aria-busy", "true");
      this.message.hidden = true;
      const began = performance.now();
      const answer = await ask("place", body, signal);
      if (signal.aborted) return;
      if (!body.nearby) this.slow = performance.now() - began > SLOW;
      this.known = knownAs(body);
      this.asked = live ? "" : JSON.stringify(body);
      [this.answer, this.shown, this.told] = [answer, body.at, JSON.stringify([body.model, body.at])];
      this.age(state.get());
      this.show();
      this.element.removeAttribute("aria-busy");
      if (!live && this.key === "place") this.announce(body.at);
    };
  }

  fail(error) {
    this.asked = "";
    this.message.textContent = error.message;
    this.message.hidden = false;
    this.body.hidden = true;
    this.element.removeAttribute("aria-busy");
  }

  show() {
    this.message.hidden = true;
    this.body.hidden = false;
    this.hint.hidden = !this.answer.followed;
    const { attractors, solutions } = this.answer;
    const inks = attractorInks(attractors);
    const missed = this.missed();
    this.short.textContent = [...attractors.map((each) => `${nameOf(each)} ${percent(each.share)}`), ...missed.map((each) => `${nameOfSolution(each)}: stable, not reached`)].join("; ");
    const rows = attractors.map((each, index) => {
      const swatch = make("span", { class: "swatch", "aria-hidden": "true" });
      swatch.style.background = inks[index];
      const share = make("span", { class: "share" });
      share.style.width = `${100 * each.share}%`;
      share.style.background = inks[index];
      const rates = each.motion === "non-impacting" || each.impacts === null ? [] : [`${number(each.impacts, 3)} ${each.impacts === 1 ? "impact" : "impacts"} per period`];
      const { lyapunov_exponent: rate, lyapunov_error: error } = each;
      const sure = error > 0 ? ` ± ${number(error, 1)}` : "";
      const forgets = each.rests && each.periods ? [rates.length ? " · " : "", "forgets its state at rest: multipliers 0"] : [];
      const exponent = rate === null ? forgets : [rates.length ? " · " : "", make("span", { title: "Displacements grow like exp(λt)" }, "largest Lyapunov exponent ", make("i", {}, "λ"), ` = ${number(rate, 3)}${sure}${description.units.time ? ` / ${description.units.time}` : ""}`)];
      const on = each.motion === "unsettled" ? [" ", make("button", { type: "button", class: "small", title: "Follow it for four times as long", onclick: () => this.goOn(4 * each.waited) }, "Continue")] : [];
      return make("li", {}, swatch, make("span", { class: "name" }, nameOf(each)), make("b", { title: "Share of the initial states that reach it" }, percent(each.share)), make("span", { class: "track", "aria-hidden": "true" }, share), make("span", { class: "detail" }, ...rates, ...exponent, ...on));
    });
    const starts = count(this.answer.states, "random start");
    const others = missed.map((each) => {
      const swatch = make("span", { class: "swatch open", "aria-hidden": "true" });
      swatch.style.color = solutionInk(each);
      return make("li", {}, swatch, make("span", { class: "name" }, nameOfSolution(each)), make("b", {}, "0 %"), make("span", { class: "detail" }, `stable, but none of the ${starts} reached it`));
    });
    const head = make("li", { class: "head" }, `Reached from ${starts}`);
    this.attractors.replaceChildren(...(rows.length ? [head, ...rows] : [make("li", {}, "No attractor was found.")]), ...others);
    const mark = (yes, word = yes ? "yes" : "no") => make("td", { class: yes ? "good" : "muted" }, word);
    const focused = this.table.contains(document.activeElement) ? document.activeElement.dataset.key : null;
    const keys = keysOf(solutions);
    const lines = solutions.map((each, index) => {
      const key = keys[index];
      const pressed = this.drawn.has(key);
      const button = make("button", { type: "button", class: "small toggle", "data-key": key, "aria-pressed": pressed, "aria-label": `Draw ${nameOfSolution(each)}`, onclick: () => this.toggle(key) }, numbers(each));
      button.style.setProperty("--ink", solutionInk(each));
      return make("tr", {}, make("th", { scope: "row" }, button), make("td", {}, number(each.impact_velocity, 4)), make("td", {}, multipliers(each.multipliers)), mark(each.stable === true, stability(each)), mark(each.admissible));
    });
    this.table.replaceChildren(...lines);
    if (focused !== null) this.table.querySelector(`[data-key="${focused}"]`)?.focus();
    this.solutions.hidden = solutions.length === 0;
    this.offerToFollow();
    this.draw();
  }

  /** Stable solutions that no start has reached, where all motion was looked for. */
  missed() {
    const { solutions, followed } = this.answer;
    return followed ? [] : solutions.filter((each) => isGood(each) && !each.reached);
  }

  /** Follows unsettled motion for longer. */
  goOn(periods) {
    const { model, at } = this.body_(false);
    this.longer = { of: JSON.stringify([model, at]), periods };
    this.request(false);
  }

  /**
   * Offers to follow the solution whose button was pressed last: along a parameter, in the cut, or in the plane at
   * its velocity.
   */
  offerToFollow() {
    const { solutions } = this.answer;
    const [at, key] = [this.shown, [...this.drawn].at(-1)];
    const found = solutions[keysOf(solutions).indexOf(key)];
    this.follows.hidden = this.key === "kept" || !(found?.p > 0);
    if (this.follows.hidden) return;
    const { p, impacts, known } = found;
    const button = (patch, ...words) => make("button", { type: "button", class: "small", onclick: () => state.update(patch) }, ...words);
    const along = (axis, cut) => button({ cut, ordinate: "impact velocity" }, "along ", ...elements(axisPieces(axis)));
    const on = isFollowed(known, at);
    const held = button({ follow: on ? null : { at, ...known } }, "at this velocity");
    held.setAttribute("aria-pressed", on);
    const of = impacts > 1 ? [`${numbers(found)}: `] : [make("i", {}, "p"), ` = ${p}: `];
    this.follows.replaceChildren("Follow ", ...of, along(description.primary, "secondary"), along(description.secondary, "primary"), held);
  }

  toggle(key) {
    if (!this.drawn.delete(key)) this.drawn.add(key);
    this.show();
  }

  draw() {
    if (!this.answer || this.element.hidden) return;
    const { attractors, solutions, period, beyond } = this.answer;
    const inks = attractorInks(attractors);
    const keys = keysOf(solutions);
    const moving = attractors.map(({ orbit, periods }, index) => ({ orbit: orbit ?? [], ink: inks[index], wide: periods ? 1.4 : 0.7, periods, repeats: Boolean(periods) }));
    const extra = solutions.filter((_, index) => this.drawn.has(keys[index])).map((each) => ({ orbit: each.orbit ?? [], ink: solutionInk(each), wide: 1.4, dashed: each.stable !== true, periods: each.p || 1, repeats: true }));
    const strikes = attractors.map((each, index) => ({ strikes: each.strikes ?? [], ink: inks[index] }));
    // The attractor of most states is drawn on top.
    drawPortraits(this, { orbits: [...moving.reverse(), ...extra], strikes: strikes.reverse(), period, beyond });
  }

  announce(at) {
    const { attractors, solutions } = this.answer;
    const names = [description.primary, description.secondary].map((axis, index) => `${axis.name} ${number(at[index], 4)}`);
    const found = attractors.map((each) => `${nameOf(each)}, ${percent(each.share)} of the states`).join("; ");
    const named = (each) => (each.impacts > 1 ? nameOfSolution(each) : `p = ${each.p}`);
    const stable = solutions.filter((each) => each.p > 0 && isGood(each)).map(named);
    const missed = this.missed().map(named);
    speak(`At ${names.join(", ")}: ${found || "no attractor"}. ${stable.length ? `Stable and admissible: ${stable.join(", ")}.` : "No solution with impacts is stable and admissible."}${missed.length ? ` Reached by none of the ${this.answer.states} states: ${missed.join(", ")}.` : ""}`);
  }
}

/** Brings the plane, with the cut below it, above the answer, where this is a sheet over the lower part of the page. */
export function showPlane() {
  if (getComputedStyle($("place-section")).position === "fixed") $("stage").scrollIntoView({ block: "start", behavior: "instant" });
}

let cards = [];

/** The place that a card shows, or null. */
export const shown = (key) => cards.find((card) => card.key === key)?.shown ?? null;

/** The results at the place, or null, and the drawing of its pictures. */
export const told = () => (state.get().place ? (cards[0]?.answer ?? null) : null);
export const draw = () => cards[0]?.draw();

export const attach = () => (cards = [new Card("place"), new Card("kept")]);

/** Follows the state: `moved` has the names of the entries that changed. */
export function follow(value, moved, live) {
  const model = ["set", "text", "example", "loops"].some((name) => moved.has(name));
  for (const card of cards) if (model || moved.has(card.key)) card.follow(value, live);
    else if (moved.has("follow") && card.answer) card.offerToFollow();
    else if (moved.has("view") && value[card.key]) card.title(value[card.key], value);
  $("place-hint").hidden = value.place !== null || value.kept !== null;
  const opens = value.place !== null && !document.body.classList.contains("placed");
  document.body.classList.toggle("placed", value.place !== null || value.kept !== null);
  if (opens) showPlane();
  document.body.classList.toggle("two-places", value.place !== null && value.kept !== null);
}

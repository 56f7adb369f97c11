// The page: everything follows the state, and buttons and keys change it.
import { $, rested } from "./dom.js";
import { ask } from "./api.js";
import { begin } from "./busy.js";
import * as constants from "./constants.js";
import * as cut from "./cut.js";
import * as diagram from "./diagram.js";
import * as editor from "./editor.js";
import * as following from "./follow.js";
import * as hand from "./hand.js";
import * as measured from "./measured.js";
import * as model from "./model.js";
import * as place from "./place.js";
import { redraw } from "./plane.js";
import { drawSamples, listKinds, onTheme } from "./palette.js";
import * as share from "./share.js";
import * as state from "./state.js";
import * as straightened from "./straightened.js";
import * as tiles from "./tiles.js";

const OSCILLATOR = ["example", "text"];
const CONSTANTS = ["set", "loops"];

/** A cut needs a place: the middle of the view, if there is none. */
const toggleCut = (fixed) => {
  const value = state.get();
  if (!value.place) hand.step(0, 0);
  state.update({ cut: value.cut === fixed ? null : fixed });
};

const COMMANDS = {
  in: () => hand.zoom(1.6),
  out: () => hand.zoom(1 / 1.6),
  whole: hand.whole,
  box: hand.startBox,
  // Not beyond the entry by which the page was opened.
  back: () => history.state?.step > 0 && history.back(),
  forward: () => history.forward(),
  horizontal: () => toggleCut("secondary"),
  vertical: () => toggleCut("primary"),
  keep: () => state.get().place && state.update({ kept: state.get().place }),
  overlay: () => state.update({ overlay: !state.get().overlay }),
  straighten: straightened.toggle,
  measured: measured.choose,
  unmeasured: measured.remove,
  leave: () => state.update({ place: null, kept: null, cut: null }),
  edit: () => state.update({ edit: !state.get().edit }),
  stop: diagram.stop,
  share: share.share,
  export: share.save,
  help: () => $("help").showModal(),
};

/** The keys of the plane; a question mark opens the help anywhere. */
const KEYS = { "+": "in", "=": "in", "-": "out", 0: "whole", "[": "back", "]": "forward", b: "box", h: "horizontal", v: "vertical", k: "keep", o: "overlay", t: "straighten", m: "measured", e: "edit", s: "share", x: "export", Escape: "stop" };

function keys() {
  $("plane").addEventListener("keydown", (event) => {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    const name = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (hand.arrow(event)) event.preventDefault();
    else if (plain && name) {
      COMMANDS[name]();
      event.preventDefault();
    }
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "?" || event.target.matches("input, textarea, select")) return;
    COMMANDS.help();
    event.preventDefault();
  });
  document.addEventListener("click", (event) => {
    const button = event.target.closest("[data-command]");
    if (button) COMMANDS[button.dataset.command]();
  });
}

/** Until a file is valid only its check matters; the diagram of the last valid one stays. */
const checkSoon = rested(200, () => editor.check(model.modelOf(state.get())));

function follow(value, changed, live) {
  if (!live && changed.size > 0 && model.description) $("warning").hidden = true;
  const has = (names) => names.some((name) => changed.has(name));
  editor.follow(value);
  if (has(OSCILLATOR)) {
    diagram.want();
    // Nothing can be requested before the program has described the parameters of the oscillator.
    editor.check(model.modelOf(value));
    return;
  }
  if (!model.description) return;
  if (has(CONSTANTS)) checkSoon();
  showAll(value, changed, live);
}

function showAll(value, changed, live) {
  constants.follow(value);
  if (["set", "loops", "view", ...OSCILLATOR].some((name) => changed.has(name))) diagram.follow(value, live, changed.has("set"));
  place.follow(value, changed, live);
  cut.follow(value);
  following.follow(value, live);
  tiles.follow(value, changed);
  straightened.follow();
  measured.follow();
  // While a constant is dragged, the plane is redrawn as results arrive.
  if (!live || !changed.has("set")) redraw();
}

/** The oscillator that the page shows: that of the last description. */
let described = "";

function taken(answer) {
  if (!answer.ok) {
    // An invalid file in the address is shown with its mistake.
    if (!model.description && model.textOf(state.get()) !== null && !state.get().edit) state.update({ edit: true });
    editor.tell(answer);
    constants.refuse(answer);
    diagram.say(`Not drawn. ${model.withLine(answer)}`, true);
    return;
  }
  const names = ({ name, primary, secondary }) => JSON.stringify([name, primary.name, secondary.name]);
  if (model.description && names(model.description) !== names(answer)) diagram.clear();
  model.setDescription(answer);
  document.title = `${answer.name} – grazing explorer`;
  $("plane").setAttribute("aria-label", `Bifurcation diagram of ${answer.name}: ${answer.primary.name} across, ${answer.secondary.name} up`);
  const value = state.get();
  const key = JSON.stringify([model.textOf(value)]);
  const all = key !== described;
  described = key;
  diagram.list();
  if (all) showAll(value, new Set(["example", "text", "set", "loops", "view", "place", "kept", "cut", "ordinate", "follow", "overlay", "data"]), false);
  else {
    constants.follow(value);
    redraw();
  }
}

async function start() {
  try {
    model.setExamples(await ask("examples"));
  } catch (error) {
    diagram.say(error.message, true);
    return;
  }
  place.attach();
  editor.attach(model.choose);
  editor.onTaken(taken);
  hand.attach();
  cut.attach();
  tiles.attach();
  measured.attach();
  share.attach();
  keys();
  following.onFollowed(redraw);
  measured.onTold(redraw);
  diagram.onDiagram(() => {
    redraw();
    tiles.shaded();
    straightened.follow();
    measured.follow();
  });
  onTheme(redraw);
  onTheme(drawSamples);
  listKinds();
  drawSamples();
  new ResizeObserver(redraw).observe($("plane"));
  document.fonts.ready.then(redraw);
  state.subscribe(follow);
  const known = state.fromAddress();
  $("warning").hidden = known;
  $("warning").textContent = known ? "" : "The part of the address after # could not be read; it may have been cut off. The paper’s oscillator is shown.";
  if (described === "" && !state.get().text && !state.get().example) editor.check(model.modelOf(state.get()));
}

const started = begin();
start().finally(started);

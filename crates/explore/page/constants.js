// Constants: a slider and a field for each, and the numbers of loops.
import { $, make, number } from "./dom.js";
import { elements, namePieces } from "./markup.js";
import { description } from "./model.js";
import * as state from "./state.js";

const STEPS = 400;
/** The reach of a slider, as factors of the file's value. */
const BELOW = 0.25;
const ABOVE = 2.5;
/** The numbers of loops that can be chosen. */
const LOOPS = 6;

/** Ranges that typing has extended, by constant. */
let extended = {};
let built = "";
let controls = [];
/** The constant that was changed last. */
let last = "";

/**
 * The range of a slider. A value between a half and one is most likely a fraction, such as a coefficient of
 * restitution: it ends at one.
 */
function rangeOf({ name, value }) {
  const [low, high] = value === 0 ? [-1, 1] : [value * BELOW, value > 0.5 && value <= 1 ? 1 : value * ABOVE].sort((a, b) => a - b);
  const typed = extended[name] ?? [low, high];
  return [Math.min(low, typed[0]), Math.max(high, typed[1])];
}

function control(constant) {
  const { name, value: own } = constant;
  const id = `constant-${name}`;
  const slider = make("input", { type: "range", id, min: 0, max: STEPS, step: 1, "aria-describedby": `${id}-range` });
  const field = make("input", { type: "text", inputmode: "decimal", "aria-label": `${name}, value`, autocomplete: "off", spellcheck: "false" });
  const reset = make("button", { type: "button", class: "small reset", "aria-label": `Reset ${name}`, title: `Reset to the file’s value, ${number(own, 6)}` }, "↺");
  const ends = make("span", { class: "ends", id: `${id}-range` });
  const why = make("p", { class: "why", role: "alert", hidden: true });
  const refuse = (words) => {
    field.classList.toggle("bad", words !== "");
    why.textContent = words;
    why.hidden = words === "";
  };
  const set = (value, live) => {
    last = name;
    const next = { ...state.get().set };
    if (value === own) delete next[name];
    else next[name] = value;
    state.update({ set: next }, live);
  };
  let typing = false;
  const show = () => {
    const value = state.get().set[name] ?? own;
    if (!(value >= rangeOf(constant)[0] && value <= rangeOf(constant)[1])) extended[name] = value < 0 ? [2 * value, Math.max(0, own)] : [Math.min(value / 2, own), 2 * value];
    const [low, high] = rangeOf(constant);
    slider.value = Math.round(((value - low) / (high - low)) * STEPS);
    slider.setAttribute("aria-valuetext", number(value, 6));
    if (!typing) field.value = String(Number(value.toPrecision(10)));
    refuse("");
    reset.hidden = value === own;
    ends.textContent = `${number(low, 3)} to ${number(high, 3)}`;
  };
  slider.addEventListener("input", () => {
    const [low, high] = rangeOf(constant);
    const value = low + (slider.value / STEPS) * (high - low);
    // Numbers rounded to the slider's own resolution, so that the value shown can be typed again.
    set(Number(value.toPrecision(4)), true);
  });
  slider.addEventListener("change", () => state.update({}));
  field.addEventListener("input", () => (typing = true));
  field.addEventListener("change", () => {
    typing = false;
    const value = Number(field.value.replace("−", "-").replace(",", "."));
    if (field.value.trim() !== "" && Number.isFinite(value)) set(value, false);
    else refuse(`“${field.value}” is not a number; ${name} is still ${number(state.get().set[name] ?? own, 6)}.`);
  });
  reset.addEventListener("click", () => {
    set(own, false);
    slider.focus();
  });
  const row = make("div", { class: "constant" }, make("label", { for: id, title: name }, elements(namePieces(name))), make("span", { class: "slide" }, slider, ends), field, reset, why);
  return { name, row, show, refuse };
}

/** The controls of the oscillator, built anew if its constants change. */
export function follow(value) {
  if (!description) return;
  const key = JSON.stringify([description.constants, description.loops, value.example]);
  if (key !== built) {
    built = key;
    extended = {};
    controls = description.constants.map(control);
    $("constants-list").replaceChildren(...controls.map(({ row }) => row));
    $("no-constants").hidden = controls.length > 0;
    const boxes = Array.from({ length: Math.max(LOOPS, ...description.loops) }, (_, index) => index + 1).map((p) =>
      make("label", {}, make("input", { type: "checkbox", value: p, onchange: choose }), String(p)),
    );
    $("loops-list").replaceChildren(...boxes);
  }
  for (const { show } of controls) show();
  const loops = value.loops ?? description.loops;
  for (const box of $("loops-list").querySelectorAll("input")) box.checked = loops.includes(Number(box.value));
}

/** Shows why a value is rejected, beside the constant whose key is wrong, or else the one that was changed last. */
export function refuse({ key, message }) {
  const wrong = controls.find(({ name }) => key === `parameters.${name}`) ?? controls.find(({ name }) => name === last);
  wrong?.refuse(message);
}

function choose() {
  const chosen = [...$("loops-list").querySelectorAll("input:checked")].map(({ value }) => Number(value));
  const own = JSON.stringify(chosen) === JSON.stringify(description.loops);
  state.update({ loops: own || chosen.length === 0 ? null : chosen });
}

// Editing the file of the oscillator, with mistakes marked under the character and described by the program.
import { $, make, rested } from "./dom.js";
import { ask, Latest } from "./api.js";
import * as diagram from "./diagram.js";
import { exampleOf, examples, noteOf, textOf, withLine } from "./model.js";
import * as state from "./state.js";

const RESTS = 350;
const latest = new Latest({ failed: (error) => tell({ ok: false, message: error.message }) });
let taken = () => {};
/** `act(description)` is called with each good answer to `check`. */
export const onTaken = (act) => (taken = act);

/** Shows the text with the mistake marked, if there is one. */
export function tell(answer) {
  const { ok, message, line, span, notes = [] } = answer;
  const text = $("text").value;
  const lines = text.split("\n");
  $("gutter").replaceChildren(...lines.map((_, at) => make("span", { class: !ok && at + 1 === line ? "wrong" : "" }, `${at + 1}\n`)));
  const marks = $("marks");
  const callout = $("callout");
  callout.hidden = ok || !line;
  $("verdict").className = ok ? "good" : "bad";
  $("verdict").textContent = ok ? ["The file is valid.", ...notes.map(noteOf)].join(" ") : withLine(answer);
  $("go-to-mistake").hidden = ok || !line;
  if (ok || !line) {
    marks.replaceChildren(`${text}\n`);
    $("text").removeAttribute("aria-invalid");
    return;
  }
  const own = lines[line - 1] ?? "";
  const [from, to] = span ?? [own.search(/\S|$/), own.length];
  const before = lines.slice(0, line - 1).map((each) => `${each}\n`).join("");
  marks.replaceChildren(before + own.slice(0, from), make("mark", {}, own.slice(from, Math.max(to, from + 1)) || " "), `${own.slice(Math.max(to, from + 1))}\n`);
  $("text").setAttribute("aria-invalid", "true");
  $("go-to-mistake").onclick = () => {
    const at = before.length + from;
    $("text").focus({ preventScroll: true });
    $("text").setSelectionRange(at, before.length + Math.max(to, from + 1));
    $("text").scrollTop = Math.max(0, (line - 5) * lineHeight());
    $("text").scrollLeft = 0;
  };
  callout.textContent = message;
  callout.style.top = `${line * lineHeight() + 10}px`;
  callout.style.left = `${from}ch`;
  // As far to the left as is needed to show all of it.
  const over = callout.offsetLeft + callout.offsetWidth + 16 - callout.parentElement.clientWidth;
  if (over > 0) callout.style.left = `max(0px, ${from}ch - ${over}px)`;
}

const lineHeight = () => Number.parseFloat(getComputedStyle($("text")).lineHeight);

/** The last valid file, and its description without any values set. */
let file = { text: undefined, described: null };

/** Checks the model with the program, and passes the answer on. */
export function check(model) {
  return latest.now(async (signal) => {
    const { text } = model;
    // Constants and loops of the file itself, with which the state is compared.
    const described = file.text === text ? file.described : await ask("check", { text, set: {}, loops: null }, signal);
    if (described.ok) file = { text, described };
    const changed = Object.keys(model.set).length > 0 || model.loops !== null;
    const answer = described.ok && changed ? await ask("check", model, signal) : described;
    if (signal.aborted) return;
    // Text that is being edited has its own verdict.
    if (text === $("text").value) tell(answer);
    if (described.ok) taken({ ...described, notes: answer.notes ?? described.notes });
    if (!answer.ok) taken(answer);
  });
}

const edited = rested(RESTS, async () => {
  const text = $("text").value;
  await latest.now(async (signal) => {
    const answer = await ask("check", { text, set: {}, loops: null }, signal);
    if (signal.aborted) return;
    if (!answer.ok) return taken(answer);
    tell(answer);
    if (text === textOf(state.get())) {
      // What was said of the mistake elsewhere is said no more.
      taken(answer);
      return diagram.resume();
    }
    // Constants that the new file does not have are forgotten.
    const names = new Set(answer.constants.map(({ name }) => name));
    const set = Object.fromEntries(Object.entries(state.get().set).filter(([name]) => names.has(name)));
    filled = text;
    state.update({ text, set });
  });
});

/**
 * The text of the state that filled the field, or that was typed there: later edits stay until the state has another
 * text.
 */
let filled;

/** The menu and the text follow the state. */
export function follow(value) {
  const menu = $("oscillator");
  const example = exampleOf(value);
  $("own-file").hidden = example !== null;
  menu.value = example ? example.file : "?own";
  const opens = value.edit && $("editor").hidden;
  $("editor").hidden = !value.edit;
  if (opens) $("editor").scrollIntoView({ block: "nearest" });
  document.body.classList.toggle("editing", value.edit);
  document.querySelector('[data-command="edit"]').setAttribute("aria-expanded", value.edit);
  if (!value.edit) return;
  const text = textOf(value);
  $("built-in").hidden = text !== null;
  $("code").hidden = text === null;
  if (text === null) {
    $("verdict").textContent = "";
    $("go-to-mistake").hidden = true;
    return;
  }
  if (filled === text) return;
  filled = text;
  $("text").value = text;
  tell({ ok: true });
  scroll();
}

function scroll() {
  const { scrollTop, scrollLeft } = $("text");
  $("gutter").style.transform = `translateY(${-scrollTop}px)`;
  for (const name of ["marks", "callout"]) $(name).style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
}

export function attach(choose) {
  $("oscillator").prepend(...examples.map(({ name, file }) => make("option", { value: file }, name)));
  $("oscillator").addEventListener("change", () => choose($("oscillator").value));
  const copy = examples.find(({ file }) => file.endsWith("paper.toml") && file !== examples[0].file) ?? examples.find(({ text }) => text !== null);
  $("edit-copy").hidden = !copy;
  $("edit-copy").addEventListener("click", () => copy && choose(copy.file));
  const field = $("text");
  field.addEventListener("input", () => {
    const lines = field.value.split("\n").length;
    $("gutter").textContent = Array.from({ length: lines }, (_, at) => `${at + 1}\n`).join("");
    $("marks").textContent = "";
    $("callout").hidden = true;
    diagram.want(diagram.TYPED);
    edited();
  });
  field.addEventListener("scroll", scroll);
}

// The oscillator in the state: the data sent to the server, and its description from there.
import * as state from "./state.js";

/** The examples, [{ name, file, text }], the paper first. */
export let examples = [];
/** The command that starts the program, `cargo xtask` or `grazing`. */
export let program = "";
/** The last good answer of `check`. */
export let description = null;

export const setExamples = (told) => ({ program, examples } = told);
export const setDescription = (told) => (description = told);

/** A message on the file, with its line. */
export const withLine = ({ line, message }) => `${line ? `Line ${line}: ` : ""}${message}`;

/** A note on the file, as a sentence. */
export const noteOf = (note) => withLine(note).replace(/[^.?]$/, "$&.");

export const exampleOf = (value) => (value.text === null ? (examples.find(({ file }) => file === value.example) ?? examples[0]) : null);

/** The text of the file; null for the paper's own oscillator. */
export const textOf = (value) => value.text ?? exampleOf(value)?.text ?? null;

export const modelOf = (value) => ({ text: textOf(value), set: value.set, loops: value.loops });

export const wholeView = () => ({ primary: [...description.primary.range], secondary: [...description.secondary.range] });

/** The part of the plane in view. */
export const viewOf = (value) => value.view ?? wholeView();

/** Changes to another oscillator: the plane of the old one does not apply to it. */
export const choose = (file) =>
  state.update({ example: file === examples[0].file ? null : file, text: null, set: {}, loops: null, view: null, place: null, kept: null, follow: null });

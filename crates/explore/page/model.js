// The oscillator that the state names: what is sent to the server, and what the server said of it.
import * as state from "./state.js";

/** [{ name, file, text }], the paper first. */
export let examples = [];
/** How people start the program, `cargo xtask` or `grazing`. */
export let program = "";
/** The last good answer of `check`. */
export let description = null;

export const setExamples = (told) => ({ program, examples } = told);
export const setDescription = (told) => (description = told);

export const exampleOf = (value) => (value.text === null ? (examples.find(({ file }) => file === value.example) ?? examples[0]) : null);

/** The text of the file; null for the paper's own oscillator. */
export const textOf = (value) => value.text ?? exampleOf(value)?.text ?? null;

export const modelOf = (value) => ({ text: textOf(value), set: value.set, loops: value.loops });

export const wholeView = () => ({ primary: [...description.primary.range], secondary: [...description.secondary.range] });

/** What part of the plane is seen. */
export const viewOf = (value) => value.view ?? wholeView();

/** Goes to another oscillator: nothing of the old one's plane means anything there. */
export const choose = (file) =>
  state.update({ example: file === examples[0].file ? null : file, text: null, set: {}, loops: null, view: null, place: null, kept: null, follow: null });

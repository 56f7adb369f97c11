// Sharing and saving: the address, the command that writes the same, the figure and the numbers as files.
import { $, make } from "./dom.js";
import { file } from "./api.js";
import { namePieces, plain } from "./markup.js";
import { description, exampleOf, examples, modelOf, program, textOf, viewOf } from "./model.js";
import { fileOf as fileOfSeen, isSeen } from "./seen.js";
import { drawnView } from "./diagram.js";
import * as cut from "./cut.js";
import * as state from "./state.js";
import * as straightened from "./straightened.js";

/** A word of a command line; quoted if a shell would interpret it. */
const word = (text) => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);
const list = (numbers) => `[${numbers.join(",")}]`;

/** The path of the file in a command: as named at the start of the program, or in its folder. */
function fileOf(example) {
  if (!example) return "oscillator.toml";
  const shipped = examples.some((each) => each !== examples[0] && each.file === example.file && each.text === example.text);
  return example === examples[0] && !shipped ? example.file : `examples/${example.file}`;
}

/**
 * Characters that a terminal or a shell may interpret: control characters, and marks that change the direction of
 * writing.
 */
const TREACHEROUS = /[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/u;

/**
 * The command that writes the same figure and numbers; null if names in the address, which anybody can write, make it
 * unsafe.
 */
export function command(value) {
  const { primary, secondary } = drawnView(value);
  const example = exampleOf(value);
  const paper = example !== null && example.text === null;
  const setting = (key, told) => ` --set ${word(`${key}=${told}`)}`;
  const constants = Object.entries(value.set).map(([name, told]) => setting(paper ? `oscillator.${name}` : name, told));
  const [across, up, loops] = paper ? ["fig07.amplitude", "fig07.frequency", "fig07.loops"] : ["primary.range", "secondary.range", "analysis.loops"];
  // The figure of the paper has other ranges than the initial plane.
  const ranges = value.view || paper ? setting(across, list(primary)) + setting(up, list(secondary)) : "";
  // One-parameter diagrams of the file need not lie in the view.
  const alone = value.view && /^\s*\[\[\s*diagrams/m.test(textOf(value) ?? "") ? setting("diagrams", "[]") : "";
  const chosen = value.loops ? setting(loops, list(value.loops)) : "";
  const first = `${program} ${paper ? "reproduce --only fig07" : `unfold ${word(fileOf(example))}`}`;
  const measured = value.data ? ` --data ${word(value.data.name)}` : "";
  const line = first + constants.join("") + ranges + alone + chosen + (paper ? "" : measured);
  return TREACHEROUS.test(line) ? null : line;
}

async function copy(text, button) {
  const before = button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
  } catch {
    button.textContent = "Select it to copy";
  }
  setTimeout(() => (button.textContent = before), 1500);
}

function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const stem = () => (description?.name ?? "oscillator").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");

async function take(what, of = "plane") {
  const value = state.get();
  const [kind, table] = what.split(":");
  $("export-status").textContent = "Drawing …";
  try {
    const blob = await file("export", { model: modelOf(value), view: viewOf(value), what, columns: $("columns").value, measured: value.data, of: FIGURES[of].wanted() });
    const name = table ?? (of === "plane" ? null : of);
    download(blob, `${stem()}${name ? `-${name}` : ""}.${kind}`);
    $("export-status").textContent = "Saved.";
  } catch (error) {
    $("export-status").textContent = error.message;
  }
}

/**
 * The figures that the program draws: their names, their requests, which are empty while there is none, and their
 * tables.
 */
const FIGURES = {
  plane: { words: "Diagram", wanted: () => "plane" },
  cut: { words: "Cut", wanted: cut.wanted },
  place: { words: "Place", wanted: () => state.get().place && { place: state.get().place }, tables: ["place_basins"] },
  straightened: { words: "Straightened", wanted: straightened.wanted, tables: ["straightened"] },
};

/** The pictures of the page by name. */
const PICTURES = { plane: "Plane", cut: "Cut", series: "Time series", portrait: "Phase portrait", impacts: "Impacts" };

async function takeSeen(name, kind) {
  download(await fileOfSeen(name, kind), `${stem()}-${name}.${kind}`);
  $("export-status").textContent = "Saved.";
}

/** Opens one of the two dialogs. */
function open(dialog) {
  const told = Object.entries(state.get().set).map(([name, number]) => `${plain(namePieces(name))} = ${number}`);
  $(dialog).querySelector(".what").textContent = [description.name, ...told].join(", ");
  $(dialog).showModal();
}

/** The address, and the command that writes the same. */
export function share() {
  const value = state.get();
  $("address").value = location.origin + location.pathname + state.encode(value);
  const line = command(value);
  $("command").textContent = line ?? "None: a name in the address contains characters that are not text.";
  $("copy-command").disabled = line === null;
  $("own-text").hidden = textOf(value) === null;
  $("save-text").textContent = `Save ${exampleOf(value)?.file ?? "oscillator.toml"}`;
  open("share");
}

/** Everything that can be saved as a file. */
export function save() {
  for (const row of $("seen-list").children) row.hidden = !isSeen(row.dataset.name);
  for (const row of $("print-list").children) row.hidden = !FIGURES[row.dataset.name].wanted();
  $("export-status").textContent = "";
  open("export");
}

export function attach() {
  $("copy-address").addEventListener("click", (event) => copy($("address").value, event.currentTarget));
  $("copy-command").addEventListener("click", (event) => copy($("command").textContent, event.currentTarget));
  $("save-text").addEventListener("click", () => download(new Blob([textOf(state.get())], { type: "application/toml" }), exampleOf(state.get())?.file ?? "oscillator.toml"));
  for (const button of document.querySelectorAll("dialog .close")) button.addEventListener("click", () => button.closest("dialog").close());
  for (const [name, { words, tables = [] }] of Object.entries(FIGURES)) {
    const kinds = ["svg", "pdf", "png", ...tables.map((table) => `csv:${table}`)];
    const buttons = kinds.map((kind) => make("button", { type: "button", "data-take": kind, "data-of": name }, kind.slice(0, 3).toUpperCase()));
    $("print-list").append(make("p", { class: "row", "data-name": name }, make("span", {}, words), ...buttons));
  }
  for (const button of $("export").querySelectorAll("[data-take]")) button.addEventListener("click", () => take(button.dataset.take, button.dataset.of));
  const buttons = (name) => ["svg", "png", "csv"].map((kind) => make("button", { type: "button", "data-seen": `${name}:${kind}`, onclick: () => takeSeen(name, kind) }, kind.toUpperCase()));
  for (const [name, words] of Object.entries(PICTURES)) $("seen-list").append(make("p", { class: "row", "data-name": name }, make("span", {}, words), ...buttons(name)));
}

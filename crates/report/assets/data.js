"use strict";
// The tables of the page, and how their values are written.

const SYMBOLS = JSON.parse(document.getElementById("columns").textContent);

/** Reads a table as the page keeps it: a line with the headers, then the cells column by column, each on a line. */
function readTable(name, text) {
  const lines = text.split("\n");
  const header = lines[0].split("|");
  const rows = (lines.length - 1) / header.length;
  const byName = new Map(header.map((title, index) => [title, lines.slice(1 + index * rows, 1 + (index + 1) * rows)]));
  return { name, rows, header, column: (title) => byName.get(title) };
}

/** The tables that are kept in the element with that identifier, compressed. */
async function readTables(id) {
  const kept = document.getElementById(id);
  if (!kept) return [];
  const bytes = Uint8Array.from(atob(kept.textContent), (letter) => letter.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const texts = JSON.parse(await new Response(plain).text());
  return Object.entries(texts).map(([name, text]) => readTable(name, text));
}

/** A number with so many significant digits as markup: with a true minus sign, and powers of ten as powers. */
function written(value, digits) {
  if (value === 0) return "0";
  const plain = Number(value.toPrecision(digits));
  const size = Math.abs(plain);
  const text = size >= 1e-3 && size < 1e6 ? String(plain) : plain.toExponential();
  const [mantissa, power] = text.replace(/-/g, "−").replace("e+", "e").split("e");
  if (power === undefined) return mantissa;
  const one = /^−?1$/.test(mantissa);
  return `${one ? mantissa.slice(0, -1) : `${mantissa} × `}10<sup>${power}</sup>`;
}

/** Whether a cell holds a number. */
const isNumber = (cell) => cell !== "" && Number.isFinite(Number(cell));

/** Puts a cell into an element as a reader wants it. */
function fill(made, cell) {
  if (isNumber(cell)) made.innerHTML = written(Number(cell), 7);
  else made.textContent = cell.replace(/_/g, " ");
  return made;
}

/** An element with a class and a text. */
function element(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

/** The symbol of a column. The symbols are part of the page, so they may hold markup. */
function symbol(tag, column) {
  const made = element(tag);
  if (SYMBOLS[column]) made.innerHTML = SYMBOLS[column];
  else made.textContent = column.replace(/_/g, " ");
  return made;
}

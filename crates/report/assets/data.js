"use strict";
// The tables of the page, and how their values are written.

const SYMBOLS = JSON.parse(document.getElementById("columns").textContent);

/** A column that is written as `decimals,order`: without the decimal point, and so many times as differences. */
function undone(cells, [decimals, order]) {
  const sums = new Array(order + 1).fill(0);
  return cells.map((cell) => {
    if (cell === "") return cell;
    sums[order] = Number(cell);
    for (let at = order; at > 0; at -= 1) sums[at - 1] += sums[at];
    return String(Number(`${sums[0]}e-${decimals}`));
  });
}

/**
 * Reads a table as the page keeps it: a line with the headers, one with how each column is written, one with the units, then the
 * cells column by column, each on a line.
 */
function readTable(name, isCloud, text) {
  const lines = text.split("\n");
  const [header, codes, units] = lines.slice(0, 3).map((line) => line.split("|"));
  const rows = (lines.length - 3) / header.length;
  const column = (index) => {
    const cells = lines.slice(3 + index * rows, 3 + (index + 1) * rows);
    return codes[index] ? undone(cells, codes[index].split(",").map(Number)) : cells;
  };
  const byName = new Map(header.map((title, index) => [title, column(index)]));
  return { name, isCloud, rows, header, column: (title) => byName.get(title), unit: (title) => units[header.indexOf(title)] || "" };
}

/** The tables that are kept in the element with that identifier, compressed. */
async function readTables(id) {
  const kept = document.getElementById(id);
  if (!kept) return [];
  const bytes = Uint8Array.from(atob(kept.textContent), (letter) => letter.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const texts = JSON.parse(await new Response(plain).text());
  return Object.entries(texts).map(([name, [isCloud, text]]) => readTable(name, isCloud, text));
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

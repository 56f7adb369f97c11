"use strict";
// The tables behind the figures, and how their values are written.

const SYMBOLS = JSON.parse(document.getElementById("columns").textContent);

/** Reads a table as the page keeps it: lines of cells between bars, in which `=` stands for the cell above. */
function readTable(name, text) {
  const lines = text.split("\n");
  const header = lines[0].split("|");
  const rows = lines.length - 1;
  const columns = header.map(() => new Array(rows));
  for (let row = 0; row < rows; row += 1) {
    const cells = lines[row + 1].split("|");
    for (let column = 0; column < header.length; column += 1) {
      columns[column][row] = cells[column] === "=" ? columns[column][row - 1] : cells[column];
    }
  }
  const byName = new Map(header.map((title, index) => [title, columns[index]]));
  return { name, rows, header, column: (title) => byName.get(title) };
}

/** All tables of a figure. */
function readTables(figure) {
  const element = document.getElementById(`data-${figure.id}`);
  const texts = element ? JSON.parse(element.textContent) : {};
  return Object.entries(texts).map(([name, text]) => readTable(name, text));
}

/** A number with so many significant digits, with a true minus sign. */
function written(value, digits) {
  if (value === 0) return "0";
  const plain = Number(value.toPrecision(digits));
  const size = Math.abs(plain);
  const text = size >= 1e-4 && size < 1e7 ? String(plain) : plain.toExponential();
  return text.replace(/e\+?(-?\d+)$/, " × 10^$1").replace(/-/g, "−");
}

/** A cell as a reader wants it. */
function writtenCell(cell) {
  return cell !== "" && Number.isFinite(Number(cell)) ? written(Number(cell), 7) : cell.replace(/_/g, " ");
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

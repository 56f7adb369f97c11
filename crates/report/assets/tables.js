"use strict";
// Tables that sort by a click on a heading and keep the rows that contain a text.

function sortKey(row, index) {
  const cell = row.cells[index];
  const text = cell.dataset.value ?? cell.textContent.replace(/−/g, "-").trim();
  const number = Number(text);
  return { text, number: text !== "" && Number.isFinite(number) ? number : null };
}

/** Numbers in order of size, then words in order of the alphabet; empty cells last. */
function compare(a, b) {
  if (a.number !== null && b.number !== null) return a.number - b.number;
  if (a.text === "" || b.text === "") return (a.text === "") - (b.text === "");
  if ((a.number === null) !== (b.number === null)) return a.number === null ? 1 : -1;
  return a.text.localeCompare(b.text, "en");
}

for (const table of document.querySelectorAll("table.sortable")) {
  const headings = [...table.tHead.rows[0].cells];
  headings.forEach((heading, index) => {
    const button = element("button");
    button.type = "button";
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      const descending = heading.getAttribute("aria-sort") === "ascending";
      for (const other of headings) other.removeAttribute("aria-sort");
      heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
      const rows = [...table.tBodies[0].rows].map((row) => ({ row, key: sortKey(row, index) }));
      rows.sort((a, b) => (descending ? compare(b.key, a.key) : compare(a.key, b.key)));
      table.tBodies[0].append(...rows.map(({ row }) => row));
    });
  });
}

/** The cells of a long table, once it is opened. */
async function setRows(table) {
  const [{ rows, header, column }] = await readTables(table.dataset.rows);
  const tones = new Map(table.dataset.tones.split("|").map((pair) => pair.split("=")));
  const body = new DocumentFragment();
  for (let row = 0; row < rows; row += 1) {
    const line = element("tr");
    for (const title of header) {
      const cell = column(title)[row];
      const made = element("td");
      if (title === "verdict") made.append(element("span", `verdict ${tones.get(cell)}`, cell));
      else fill(made, cell);
      if (isNumber(cell)) {
        made.className = "number";
        made.dataset.value = cell;
      }
      line.append(made);
    }
    body.append(line);
  }
  table.tBodies[0].append(body);
}
for (const table of document.querySelectorAll("table[data-rows]")) {
  table.closest("details").addEventListener("toggle", () => setRows(table), { once: true });
}

for (const input of document.querySelectorAll("input[data-filters]")) {
  const table = document.getElementById(input.dataset.filters);
  const output = input.closest("p").querySelector("output");
  input.addEventListener("input", () => {
    const rows = [...table.tBodies[0].rows];
    const wanted = input.value.trim().toLowerCase();
    let left = 0;
    for (const row of rows) {
      row.hidden = !row.textContent.toLowerCase().includes(wanted);
      if (!row.hidden) left += 1;
    }
    output.textContent = wanted === "" ? `${rows.length} rows` : `${left} of ${rows.length} rows`;
  });
}

// What is folded away is printed too, but for long tables.
addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details:not(.table, .screen):not([open])")) {
    details.open = true;
    details.dataset.opened = "";
  }
});
addEventListener("afterprint", () => {
  for (const details of document.querySelectorAll("details[data-opened]")) {
    details.open = false;
    delete details.dataset.opened;
  }
});

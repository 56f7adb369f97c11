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

for (const input of document.querySelectorAll("input[data-filters]")) {
  const rows = [...document.getElementById(input.dataset.filters).tBodies[0].rows];
  const output = input.closest("p").querySelector("output");
  input.addEventListener("input", () => {
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
  for (const details of document.querySelectorAll("details:not(.table):not([open])")) {
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

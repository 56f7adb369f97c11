"use strict";
// Uses the page as a reader would, and writes down what came of it. SPOTS are spots of figures with what must be told there.
addEventListener("load", async () => {
  const results = [];
  const check = (name, passed, seen) => results.push(`${passed ? "passed" : "FAILED"}: ${name}${passed ? "" : `: ${JSON.stringify(seen)}`}`);
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const turn = () => new Promise((done) => setTimeout(done, 50));
  const errors = [];
  addEventListener("error", (event) => errors.push(event.message));

  const loaded = performance.getEntriesByType("resource").filter((entry) => !entry.name.startsWith("data:"));
  check("nothing was loaded", loaded.length === 0, loaded.map((entry) => entry.name));
  await document.fonts.ready;

  // Light and dark.
  const background = () => getComputedStyle(document.body).backgroundColor;
  const button = document.getElementById("theme");
  const first = background();
  button.click();
  const second = background();
  check("the button turns light to dark or back", first !== second, [first, second]);
  const sheetInDark = () => getComputedStyle(document.querySelector(".sheet svg") ?? document.body).filter !== "none";
  check("figures follow", sheetInDark() === (document.documentElement.dataset.theme === "dark"), document.documentElement.dataset.theme);
  button.click();
  button.click();
  check("three clicks lead back", background() === first && button.textContent === "Theme: auto", button.textContent);

  // Figures: values under the pointer.
  const figures = all("figure.figure");
  check("there are figures", figures.length > 0, figures.length);
  const pointAt = (sheet, x, y) => {
    const svg = sheet.querySelector("svg");
    const place = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM());
    sheet.dispatchEvent(new PointerEvent("pointermove", { clientX: place.x, clientY: place.y, bubbles: true }));
  };
  for (const spot of SPOTS) {
    const figure = document.getElementById(spot.figure);
    pointAt(figure.querySelector(".sheet"), spot.x, spot.y);
    if (spot.hidden) {
      check(`${spot.figure} hides what is not drawn`, all(".probe circle", figure).length === 0, "a ring");
      figure.querySelector(".side input").click();
      pointAt(figure.querySelector(".sheet"), spot.x, spot.y);
    }
    const text = figure.querySelector(".readout").textContent;
    const missing = spot.told.filter((part) => !text.includes(part));
    check(`${spot.figure} at ${spot.x}, ${spot.y} tells ${spot.told.join("; ")}`, missing.length === 0, text);
    check(`${spot.figure} marks the point`, all(".probe circle", figure).length === 1, "no ring");
  }

  // Figures: zoom by keys, buttons and wheel.
  for (const figure of figures) {
    const sheet = figure.querySelector(".sheet");
    const svg = sheet.querySelector("svg");
    const box = () => svg.getAttribute("viewBox").split(" ").map(Number);
    const whole = box();
    const press = (key) => sheet.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    sheet.focus();
    check(`${figure.id} can be focused`, document.activeElement === sheet, document.activeElement?.className);
    check(`${figure.id}: arrows are left to the page`, press("ArrowDown"), "taken");
    press("+");
    const near = box();
    check(`${figure.id}: + magnifies`, near[2] < whole[2] && Math.abs(near[2] / near[3] - whole[2] / whole[3]) < 1e-3, near);
    press("ArrowLeft");
    check(`${figure.id}: arrows move`, box()[0] !== near[0] || near[0] === whole[0], box());
    press("0");
    check(`${figure.id}: 0 shows all`, box().every((value, index) => Math.abs(value - whole[index]) < 1e-6), box());
    figure.querySelector("[data-zoom=in]").click();
    const clicked = box()[2];
    figure.querySelector("[data-zoom=all]").click();
    check(`${figure.id}: buttons magnify and show all`, clicked < whole[2] && Math.abs(box()[2] - whole[2]) < 1e-6, clicked);
    const middle = svg.getBoundingClientRect();
    const wheel = { deltaY: -300, clientX: middle.x + middle.width / 2, clientY: middle.y + middle.height / 2, cancelable: true };
    sheet.focus();
    sheet.dispatchEvent(new WheelEvent("wheel", wheel));
    check(`${figure.id}: the wheel magnifies a focused figure`, box()[2] < whole[2], box());
    press("0");
    sheet.blur();
    sheet.dispatchEvent(new WheelEvent("wheel", wheel));
    check(`${figure.id}: the wheel scrolls the page otherwise`, Math.abs(box()[2] - whole[2]) < 1e-6, box());
    if (all("rect.panel", svg).length > 0) {
      press("n");
      const one = figure.querySelector(".readout").textContent;
      press("n");
      const two = figure.querySelector(".readout").textContent;
      press("p");
      const back = figure.querySelector(".readout").textContent;
      const some = document.getElementById(`data-${figure.id}`).textContent.length > 2;
      check(`${figure.id}: n and p step through the points`, !some || (one === back && one !== two), [one, two, back]);
    }
    press("Escape");
  }

  // Tables sort.
  const headings = all("table.sortable").filter((table) => table.tBodies[0].rows.length > 1);
  for (const table of headings.slice(0, 3)) {
    const rows = () => [...table.tBodies[0].rows].map((row) => row.cells[0].textContent);
    const heading = table.tHead.rows[0].cells[0];
    heading.querySelector("button").click();
    const up = rows();
    heading.querySelector("button").click();
    const down = rows();
    const turned = up[0] === down.at(-1) || new Set(up).size < up.length;
    check("a heading sorts and turns round", turned && heading.getAttribute("aria-sort") === "descending", [up, down]);
  }
  for (const input of all("input[data-filters]")) {
    const rows = [...document.getElementById(input.dataset.filters).tBodies[0].rows];
    input.value = "no row has this text";
    input.dispatchEvent(new Event("input", { bubbles: true }));
    const none = rows.filter((row) => !row.hidden).length;
    input.value = "";
    input.dispatchEvent(new Event("input", { bubbles: true }));
    check(`${input.dataset.filters} filters`, none === 0 && rows.every((row) => !row.hidden), none);
  }

  // The ledger filters.
  const form = document.getElementById("claim-filters");
  const entries = all(".claim");
  const left = () => entries.filter((entry) => !entry.hidden);
  if (form) {
    for (const [field, key] of [["kind", "kind"], ["part", "part"], ["state", "state"]]) {
      for (const option of [...form.elements[field].options].slice(1)) {
        form.elements[field].value = option.value;
        form.dispatchEvent(new Event("input", { bubbles: true }));
        const fits = (entry) => (option.value === "misprint" ? "misprint" in entry.dataset : entry.dataset[key] === option.value);
        check(`${field} ${option.value} filters`, left().every(fits) && left().length === entries.filter(fits).length, left().length);
      }
      form.reset();
      await turn();
    }
    form.elements.text.value = entries[0].querySelector("h3").textContent;
    form.dispatchEvent(new Event("input", { bubbles: true }));
    check("a label finds its claim", left().includes(entries[0]) && (left().length < entries.length || entries.length === 1), left().length);
    form.elements.text.value = "nobody states this";
    form.dispatchEvent(new Event("input", { bubbles: true }));
    check("other words find nothing", left().length === 0 && form.querySelector("output").textContent.startsWith("0 of"), left().length);
    location.hash = entries.at(-1).id;
    await turn();
    await turn();
    check("a link shows a claim that was filtered away", !entries.at(-1).hidden, location.hash);
  }

  const focusable = all("a[href], button, select, input, summary, [tabindex='0']");
  const unnamed = focusable.filter(
    (one) => !(one.getAttribute("aria-label") || one.textContent.trim() || one.closest("label") || one.matches("pre")),
  );
  check("everything that can be focused has a name", unnamed.length === 0, unnamed.map((one) => one.outerHTML.slice(0, 80)));
  check("the page is not wider than the window", document.documentElement.scrollWidth <= innerWidth, document.documentElement.scrollWidth);
  check("no script failed", errors.length === 0, errors);

  const told = document.createElement("pre");
  told.id = "checks";
  told.textContent = results.join("\n");
  document.body.replaceChildren(told);
});

"use strict";
// Uses the page as a reader would, and writes down what came of it. SPOTS are spots of figures with what must be told there,
// FORMULAS are texts that the search must find, with the labels of their claims. What is waited for ends after PATIENCE milliseconds at the latest.
addEventListener("load", async () => {
  const results = [];
  const check = (name, passed, seen) => results.push(`${passed ? "passed" : "FAILED"}: ${name}${passed ? "" : `: ${JSON.stringify(seen)}`}`);
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const turn = () => new Promise((done) => setTimeout(done, 10));
  // A browser may paint no more where nothing changes.
  const frame = () => new Promise((done) => { requestAnimationFrame(done); setTimeout(done, 100); });
  /** Waits until something is so, but not for ever. */
  const until = async (is) => {
    for (const began = performance.now(); !is() && performance.now() - began < PATIENCE; ) await turn();
    return is();
  };
  /** Waits until a figure has read its data, and has told what was asked for. */
  const told = async (figure) => {
    await until(() => !figure.querySelector(".readout").hasAttribute("aria-busy"));
    await turn();
    return figure.querySelector(".readout").textContent;
  };
  const errors = [];
  addEventListener("error", (event) => errors.push(event.message));

  const loaded = performance.getEntriesByType("resource").filter((entry) => !entry.name.startsWith("data:"));
  check("nothing was loaded", loaded.length === 0, loaded.map((entry) => entry.name));
  check("nothing is laid out before all is read", EARLY.length === 0, EARLY);
  await document.fonts.ready;
  const font = [...document.fonts].find((face) => face.family.replaceAll('"', "") === "Formulas");
  check("formulas have their font", !document.querySelector("math") || font?.status === "loaded", font?.status);

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
    const read = () => figure.querySelector(".readout").textContent;
    pointAt(figure.querySelector(".sheet"), spot.x, spot.y);
    await told(figure);
    if (spot.hidden) {
      check(`${spot.figure} hides what is not drawn`, all(".probe circle", figure).length === 0, "a ring");
      figure.querySelector(".side input").click();
      pointAt(figure.querySelector(".sheet"), spot.x, spot.y);
      await told(figure);
    }
    const missing = spot.told.filter((part) => !read().includes(part));
    check(`${spot.figure} at ${spot.x}, ${spot.y} tells ${spot.told.join("; ")}`, missing.length === 0, read());
    check(`${spot.figure} marks the point`, all(".probe circle", figure).length === 1, "no ring");
  }

  // Figures: zoom by keys, buttons and wheel. Lines and letters keep their sizes, the axes get other numbers.
  let empty = 0;
  for (const figure of figures) {
    const sheet = figure.querySelector(".sheet");
    const svg = sheet.querySelector("svg");
    const zoom = () => Number(svg.dataset.zoom ?? 1);
    const press = (key) => sheet.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    const drawing = () => all("path, circle, text", svg).filter((node) => !node.closest(".axes, .probe"));
    const state = () => drawing().map((node) => ["d", "x", "y", "cx", "cy", "style", "clip-path"].map((name) => node.getAttribute(name) || "").join());
    const sizes = () => drawing().map((node) => `${node.getAttribute("stroke-width")} ${node.getAttribute("font-size")} ${node.getCTM().a}`).join(";");
    // The browser lays a figure out once it is to be seen.
    sheet.scrollIntoView({ block: "center" });
    await frame();
    await frame();
    const whole = state().join("\n");
    const wholeSizes = sizes();
    sheet.focus();
    check(`${figure.id} can be focused`, document.activeElement === sheet, document.activeElement?.className);
    check(`${figure.id}: arrows are left to the page`, press("ArrowDown"), "taken");
    press("+");
    const near = state().join("\n");
    check(`${figure.id}: + magnifies`, Math.abs(zoom() - 1.5) < 1e-3 && near !== whole, zoom());
    check(`${figure.id}: widths and letters keep their sizes`, sizes() === wholeSizes, "other sizes");
    press("ArrowLeft");
    check(`${figure.id}: arrows move`, state().join("\n") !== near, "unmoved");
    press("0");
    check(`${figure.id}: 0 shows all`, zoom() === 1 && state().join("\n") === whole && !svg.querySelector(".axes"), zoom());
    figure.querySelector("[data-zoom=in]").click();
    const clicked = zoom();
    figure.querySelector("[data-zoom=all]").click();
    check(`${figure.id}: buttons magnify and show all`, clicked > 1.4 && zoom() === 1, clicked);
    const marks = all("rect.panel", svg);
    const number = (node) => Number(node.textContent.replace("−", "-"));
    for (const [index, mark] of marks.entries()) {
      // The axes show what is seen: the place of every number is that of its value, as the numbers of the whole panel have it.
      const box = mark.getBBox();
      const across = (node) => Number(node.getAttribute("y")) > box.y + box.height && Number(node.getAttribute("x")) >= box.x - 1 && Number(node.getAttribute("x")) <= box.x + box.width + 1;
      const below = (root) => all("text[font-size='7.5'][text-anchor='middle']", root).filter((node) => across(node) && /^[−\d.]+$/.test(node.textContent));
      // Those of the nearest axis.
      const numbers = (root) => below(root).filter((node, _, list) => Number(node.getAttribute("y")) < 1 + Math.min(...list.map((other) => Number(other.getAttribute("y")))));
      const places = (nodes) => nodes.map((node) => [Number(node.getAttribute("x")), number(node)]);
      const before = places(numbers(svg)).filter(([, value], at, list) => at === 0 || value > list[at - 1][1]);
      const place = new DOMPoint(box.x + box.width / 2, box.y + box.height / 2).matrixTransform(svg.getScreenCTM());
      sheet.focus();
      sheet.dispatchEvent(new WheelEvent("wheel", { deltaY: -1000, clientX: place.x, clientY: place.y, cancelable: true }));
      const axes = all(".axes", svg);
      const after = axes.length === 1 ? places(numbers(axes[0])) : [];
      check(`${figure.id}, panel ${index}: axes get new numbers`, axes.length === 1 && after.length >= 1 && after.length < Math.max(12, box.width / 25), after);
      if (before.length > 1 && after.length > 1) {
        const slope = (list) => (list.at(-1)[1] - list[0][1]) / (list.at(-1)[0] - list[0][0]);
        const ratio = slope(before) / slope(after);
        check(`${figure.id}, panel ${index}: numbers lie as far apart as the zoom says`, Math.abs(ratio / zoom() - 1) < 0.03, [ratio, zoom(), before, after]);
        const middle = (list) => list[0][1] + (box.x + box.width / 2 - list[0][0]) * slope(list);
        const off = Math.abs(middle(before) - middle(after)) / (slope(before) * box.width);
        check(`${figure.id}, panel ${index}: the middle stays where it is`, off < 0.01, [middle(before), middle(after)]);
      }
      // As deep as one can go, in every corner: something is drawn there, or the panel says that there is nothing.
      for (let turns = 0; turns < 12; turns += 1) press("+");
      check(`${figure.id}, panel ${index}: there is an end to it`, zoom() === 40, zoom());
      for (const [right, low] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
        press("0");
        const corner = new DOMPoint(box.x + right * box.width, box.y + low * box.height).matrixTransform(svg.getScreenCTM());
        // The pixel of a pointer is a whole one: it lies inside the panel, and arrows go the rest of the way.
        const [clientX, clientY] = [right ? Math.floor(corner.x) - 1 : Math.ceil(corner.x) + 1, low ? Math.floor(corner.y) - 1 : Math.ceil(corner.y) + 1];
        sheet.dispatchEvent(new WheelEvent("wheel", { deltaY: -3000, clientX, clientY, cancelable: true }));
        for (const key of [right ? "ArrowRight" : "ArrowLeft", low ? "ArrowDown" : "ArrowUp"]) press(key);
        check(`${figure.id}, panel ${index}: the wheel goes to the end at once`, zoom() === 40, zoom());
        const frame = mark.getBoundingClientRect();
        const met = drawing().filter((node) => node.getAttribute("clip-path")?.endsWith(`-panel-${index})`) || latticeOf(node)).some((node) => {
          const shown = node.getBoundingClientRect();
          return shown.right >= frame.left && shown.left <= frame.right && shown.bottom >= frame.top && shown.top <= frame.bottom;
        });
        const said = svg.querySelector(".nothing") !== null;
        if (said) empty += 1;
        check(`${figure.id}, panel ${index}: nothing is said to be nothing`, met || said, [right, low]);
      }
      press("0");
    }
    // Dots of a cloud lie where they belong however far one zooms, not in the bins in which they are drawn on the whole figure.
    const cloud = (await readTables(`data-${figure.id}`)).find((table) => table.isCloud);
    const panel = cloud && readPanels(svg).find(({ tables }) => tables?.includes(cloud.name));
    const owner = panel?.only && cloud.column(panel.only[0]);
    const spotOf = (row) => panel.toSheet(...panel.columns.map((column) => Number(cloud.column(column)[row])));
    const isShown = (row) => (!owner || owner[row] === panel.only[1]) && panel.holds(spotOf(row), -3);
    const own = cloud ? [...Array(cloud.rows).keys()].filter(isShown) : [];
    for (const row of cloud ? [own[0], own[Math.floor(own.length / 2)], own.at(-1)] : []) {
      const spot = spotOf(row);
      const place = new DOMPoint(spot.x, spot.y).matrixTransform(svg.getScreenCTM());
      // The pixel of a pointer is a whole one; what lies under it stays where it is.
      const [clientX, clientY] = [Math.round(place.x), Math.round(place.y)];
      const fixed = new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());
      sheet.focus();
      sheet.dispatchEvent(new WheelEvent("wheel", { deltaY: -1500, clientX, clientY, cancelable: true }));
      const wanted = [fixed.x + zoom() * (spot.x - fixed.x), fixed.y + zoom() * (spot.y - fixed.y)];
      // In points of the sheet, since the page may scroll meanwhile.
      const dots = () => all("path[transform*=scale]", svg).flatMap((node) => {
        const { x: left, y: top, side } = latticeOf(node);
        return [...node.getAttribute("d").matchAll(/M([-\d.]+),([-\d.]+)/g)].map(([, x, y]) => [left + side * (Number(x) + 0.5), top + side * Number(y)]);
      });
      const met = () => dots().some(([x, y]) => Math.hypot(x - wanted[0], y - wanted[1]) < 0.05);
      check(`${figure.id}: the dot of row ${row} lies where it belongs`, await until(met), [wanted, dots().slice(0, 9)]);
      press("0");
    }
    const middle = svg.getBoundingClientRect();
    const wheel = { deltaY: -300, clientX: middle.x + middle.width / 2, clientY: middle.y + middle.height / 2, cancelable: true };
    sheet.focus();
    sheet.dispatchEvent(new WheelEvent("wheel", wheel));
    check(`${figure.id}: the wheel magnifies a focused figure`, zoom() > 1, zoom());
    press("0");
    sheet.blur();
    sheet.dispatchEvent(new WheelEvent("wheel", wheel));
    check(`${figure.id}: the wheel scrolls the page otherwise`, zoom() === 1, zoom());
    if (marks.length > 0 && document.getElementById(`data-${figure.id}`)) {
      const seen = [];
      for (const key of ["n", "n", "p"]) {
        press(key);
        seen.push(await told(figure));
      }
      const [one, two, back] = seen;
      check(`${figure.id}: n and p step through the points`, one === back && one !== two, seen);
    }
    press("Escape");
  }
  check("empty places say that they are", empty > 0, empty);
  check("no figure has e-notation in its readout", figures.every((figure) => !/\de[-+−]?\d/.test(figure.querySelector(".readout").textContent)), "e");

  // Long tables have their rows once they are opened.
  for (const table of all("table[data-rows]")) {
    const folded = table.closest("details");
    const promised = Number(folded.querySelector("summary span").textContent.split(" ")[0]);
    check(`${table.id} begins without rows`, table.tBodies[0].rows.length === 0 && promised > 0, promised);
    folded.open = true;
    check(`${table.id} gets its rows`, await until(() => table.tBodies[0].rows.length === promised), table.tBodies[0].rows.length);
    const cells = [...table.tBodies[0].rows].map((row) => row.cells.length);
    check(`${table.id} has a cell for every heading`, cells.every((count) => count === table.tHead.rows[0].cells.length), cells[0]);
  }
  check("every table has a caption", all("table").every((table) => table.caption?.textContent.trim()), all("table").length);
  const small = all(".tools button, .bar a, .bar button, thead button, summary, .links a, .contents a, tbody a, .claim h3 a, .filters select, .filters input, .filters button, .side input")
    .map((target) => [target, target.getBoundingClientRect()])
    .filter(([, box]) => box.width > 0 && (box.width < 24 || box.height < 23.9));
  check("what can be touched is large enough", small.length === 0, small.slice(0, 5).map(([target, box]) => [target.outerHTML.slice(0, 60), box.width, box.height]));
  const list = document.querySelector(".bar nav");
  const goesOn = () => list.classList.contains("more-after") === list.scrollWidth > list.clientWidth + 2;
  check("the list of sections tells whether it goes on", await until(goesOn), list.className);

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
      await until(() => left().length === entries.length);
    }
    form.elements.text.value = entries[0].querySelector("h3").textContent;
    form.dispatchEvent(new Event("input", { bubbles: true }));
    check("a label finds its claim", left().includes(entries[0]) && (left().length < entries.length || entries.length === 1), left().length);
    const find = async (text) => {
      form.elements.text.value = text;
      form.dispatchEvent(new Event("input", { bubbles: true }));
      return left();
    };
    for (const { text, label } of FORMULAS) {
      const found = (await find(text)).map((entry) => entry.id);
      check(`${text} finds ${label}`, found.includes(`claim-${label}`) && found.length < entries.length, found.slice(0, 5));
    }
    await find("nobody states this");
    check("other words find nothing", left().length === 0 && form.querySelector("output").textContent.startsWith("0 of"), left().length);
    location.hash = entries.at(-1).id;
    check("a link shows a claim that was filtered away", await until(() => !entries.at(-1).hidden), location.hash);
  }

  const focusable = all("a[href], button, select, input, summary, [tabindex='0']");
  const unnamed = focusable.filter(
    (one) => !(one.getAttribute("aria-label") || one.textContent.trim() || one.closest("label") || one.matches("pre")),
  );
  check("everything that can be focused has a name", unnamed.length === 0, unnamed.map((one) => one.outerHTML.slice(0, 80)));
  check("the page is not wider than the window", document.documentElement.scrollWidth <= innerWidth, document.documentElement.scrollWidth);
  check("no script failed", errors.length === 0, errors);

  const ended = document.createElement("pre");
  ended.id = "checks";
  ended.textContent = results.join("\n");
  document.body.replaceChildren(ended);
});

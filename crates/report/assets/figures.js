"use strict";
// Values under the pointer: where it is in the panel's coordinates, and the nearest row of the data.

/** Columns that titles of axes name otherwise. */
const COLUMN_OF_TITLE = { A: "amplitude" };
/** Columns that only keep rows together. */
const BOOKKEEPING = new Set(["arc", "branch", "region", "panel", "portrait", "kind", "stable", "admissible"]);
/** How near to a point the pointer must be to show its row, and how much nearer a less telling point must be; pixels. */
const REACH = 28;
const PREFERENCE = 5;

/** The panels that the figure says it has; one that names no columns has those of its titles, or of the panel before. */
function readPanels(svg) {
  const panels = [];
  const column = (title) => {
    const name = title.replace(/\\mathcal|[^A-Za-z_]/g, "");
    return COLUMN_OF_TITLE[name] || name;
  };
  for (const mark of svg.querySelectorAll("rect.panel")) {
    const number = (name) => Number(mark.getAttribute(name));
    const range = (name) => mark.getAttribute(name).split(" ").map(Number);
    const before = panels.at(-1);
    const bounds = { x: number("x"), y: number("y"), w: number("width"), h: number("height") };
    const [x0, x1] = range("data-x");
    const [y0, y1] = range("data-y");
    panels.push({
      mark,
      bounds,
      columns:
        mark.dataset.columns?.split(" ") ??
        ["data-x-title", "data-y-title"].map((name, axis) => column(mark.getAttribute(name)) || before?.columns[axis] || ""),
      tables: mark.dataset.tables ? mark.dataset.tables.split(" ") : null,
      only: mark.dataset.only ? mark.dataset.only.split(" ") : null,
      /** Whether the point lies in the panel, or beside it by no more than a margin, in points of the sheet. */
      holds: (point, margin = 0.01) =>
        point.x >= bounds.x - margin && point.x <= bounds.x + bounds.w + margin &&
        point.y >= bounds.y - margin && point.y <= bounds.y + bounds.h + margin,
      toData: (point) => [
        x0 + ((point.x - bounds.x) / bounds.w) * (x1 - x0),
        y1 - ((point.y - bounds.y) / bounds.h) * (y1 - y0),
      ],
      toSheet: (x, y) => ({
        x: bounds.x + ((x - x0) / (x1 - x0)) * bounds.w,
        y: bounds.y + ((y1 - y) / (y1 - y0)) * bounds.h,
      }),
    });
  }
  return panels;
}

/** What a row is, in words; `KINDS` comes from the program. */
function nameOf(cell) {
  const kind = cell("kind");
  if (kind) return KINDS[kind] || kind.replace(/_/g, " ");
  if (cell("stable") === undefined) return "Nearest computed point";
  return cell("p") === "0" ? "Non-impacting solution" : `Solution with ${cell("p")} ${cell("p") === "1" ? "loop" : "loops"}`;
}

/** The rows that a panel shows, with their places on the sheet; of all tables if it names none. */
function rowsOf(panel, tables) {
  const points = [];
  const named = panel.tables?.map((name) => tables.find((table) => table.name === name)).filter(Boolean);
  (named ?? tables).forEach((table, rank) => {
    const [xs, ys] = panel.columns.map(table.column);
    const kept = panel.only && table.column(panel.only[0]);
    if (!xs || !ys || (panel.only && !kept)) return;
    const admissible = table.column("admissible");
    for (let row = 0; row < table.rows; row += 1) {
      if (xs[row] === "" || ys[row] === "" || (kept && kept[row] !== panel.only[1])) continue;
      const spot = panel.toSheet(Number(xs[row]), Number(ys[row]));
      if (panel.holds(spot)) points.push({ ...spot, table, row, rank, drawn: !admissible || admissible[row] === "true" });
    }
  });
  return points;
}

/** The point nearest to a spot of those that are seen, within reach; among points that nearly coincide the one of the most telling table. */
function nearest(points, spot, scale, withHidden, seen) {
  let best = null;
  let least = REACH;
  for (const point of points) {
    if ((!point.drawn && !withHidden) || !seen(point)) continue;
    const distance = Math.hypot(point.x - spot.x, point.y - spot.y) * scale + point.rank * PREFERENCE;
    if (distance < least) [best, least] = [point, distance];
  }
  return best;
}

const pointOf = ([x, y]) => ({ x, y });

function setUpFigure(figure) {
  const sheet = figure.querySelector(".sheet");
  const svg = sheet.querySelector("svg");
  const readout = figure.querySelector(".readout");
  const panels = readPanels(svg);
  let tables = null;
  let shown = null;
  let withHidden = false;

  const probe = drawn("g", { class: "probe", "aria-hidden": "true" });
  svg.append(probe);
  const view = makeZoomable(sheet, svg, panels, () => {
    mark(shown);
    // Dots stand in bins as long as the figure is seen whole; their places are in the data.
    if (!tables && view.isZoomed() && panels.some((panel) => panel.parts.some((part) => part.dotted))) load().then(view.redraw);
  });

  let loading = null;
  const load = () => {
    if (loading) return loading;
    // Until then the readout cannot say what is there.
    readout.setAttribute("aria-busy", "true");
    loading = readTables(`data-${figure.id}`).then((read) => {
      readout.removeAttribute("aria-busy");
      tables = read;
      for (const panel of panels) {
        panel.points = rowsOf(panel, tables);
        panel.unit = (column) => panel.points.map(({ table }) => table.unit(column)).find(Boolean);
      }
      if (!panels.some((panel) => panel.points.some((point) => !point.drawn))) return;
      const label = element("label");
      const box = element("input");
      box.type = "checkbox";
      box.addEventListener("change", () => (withHidden = box.checked));
      label.append(box, "include inadmissible points, which are not drawn");
      readout.before(label);
    });
    return loading;
  };

  /** A ring about a point of the data, with lines to the axes. */
  const mark = (point) => {
    probe.replaceChildren();
    if (!point) return;
    const { x, y, w, h } = point.panel.bounds;
    const [across, down] = view.toSeen(point.panel, point.x, point.y);
    if (across < x - 1 || across > x + w + 1 || down < y - 1 || down > y + h + 1) return;
    probe.append(
      drawn("line", { x1: x, x2: x + w, y1: down, y2: down }),
      drawn("line", { x1: across, x2: across, y1: y, y2: y + h }),
      drawn("circle", { cx: across, cy: down, r: 5 / view.scale() }),
    );
    svg.append(probe);
  };

  const hint = () => {
    shown = null;
    mark(null);
    const text = panels.length > 0 ? "Point at the figure to read values off it." : "A sketch without scales, which can be zoomed.";
    readout.replaceChildren(element("p", "hint", text));
  };

  const tell = (panel, values, point) => {
    shown = point && { ...point, panel };
    mark(shown);
    const where = element("p", "pointer");
    panel.columns.forEach((column, axis) => {
      if (!column) return;
      const value = element("b");
      value.innerHTML = written(values[axis], 6);
      const unit = panel.unit(column);
      where.append(...(axis > 0 ? [", "] : []), symbol("i", column), " = ", value, ...(unit ? [` ${unit}`] : []));
    });
    readout.replaceChildren(where);
    if (!point) return;
    const { table, row } = point;
    const cell = (column) => table.column(column)?.[row];
    readout.append(element("p", "name", nameOf(cell)));
    const flags = element("p", "flags");
    for (const [column, yes, no] of [["stable", "stable", "unstable"], ["admissible", "admissible", "inadmissible"]]) {
      const value = cell(column);
      if (value === "true") flags.append(element("span", "verdict passed", yes));
      if (value === "neutral") flags.append(element("span", "verdict unchecked", "neutral"));
      if (value === "false") flags.append(element("span", "verdict misprint", no));
    }
    if (flags.childNodes.length > 0) readout.append(flags);
    const list = element("dl");
    for (const column of table.header) {
      if (BOOKKEEPING.has(column) || cell(column) === "") continue;
      const made = fill(element("dd"), cell(column));
      if (table.unit(column)) made.append(` ${table.unit(column)}`);
      list.append(symbol("dt", column), made);
    }
    readout.append(list);
  };

  let pointer = 0;
  const point = async (event) => {
    const spot = view.toSheet(event);
    const turn = (pointer += 1);
    await load();
    // By then the pointer may be elsewhere.
    if (turn !== pointer) return;
    const panel = panels.find((candidate) => candidate.holds(spot, 1));
    if (!panel) return;
    readout.setAttribute("aria-live", "off");
    const whole = view.toWhole(panel, spot);
    const seen = (candidate) => panel.holds(pointOf(view.toSeen(panel, candidate.x, candidate.y)));
    tell(panel, panel.toData(whole), nearest(panel.points, whole, view.scale() * view.factor(panel), withHidden, seen));
  };

  /** The next or previous row of the panel, in the order of the table. */
  const step = async (by) => {
    await load();
    const panel = shown?.panel ?? panels.find((candidate) => candidate.points.length > 0);
    const points = panel?.points.filter((candidate) => candidate.drawn || withHidden) ?? [];
    if (points.length === 0) return;
    const at = shown ? points.findIndex((candidate) => candidate.table === shown.table && candidate.row === shown.row) : -1;
    const next = points[(at + by + points.length) % points.length];
    readout.setAttribute("aria-live", "polite");
    tell(panel, panel.toData(next), next);
  };

  sheet.addEventListener("pointermove", point);
  sheet.addEventListener("pointerdown", point);
  sheet.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const moving = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    const about = shown ? pointOf(view.toSeen(shown.panel, shown.x, shown.y)) : undefined;
    if (event.key === "+" || event.key === "=") view.zoom(1.5, about);
    else if (event.key === "-" || event.key === "_") view.zoom(1 / 1.5, about);
    else if (event.key === "0") view.all();
    else if (event.key === "n") step(1);
    else if (event.key === "p") step(-1);
    else if (event.key === "Escape") hint();
    // The whole figure cannot be moved: arrows then scroll the page.
    else if (moving && view.isZoomed()) view.move(...moving);
    else return;
    event.preventDefault();
  });
  for (const button of figure.querySelectorAll("[data-zoom]")) {
    const actions = { in: () => view.zoom(1.5), out: () => view.zoom(1 / 1.5), all: view.all };
    button.addEventListener("click", actions[button.dataset.zoom]);
  }
  hint();
}

document.querySelectorAll("figure.figure").forEach(setUpFigure);

"use strict";
// Zooming and moving the panels of a figure: what lies in a panel moves apart, lines and letters keep their sizes, and
// the axes get new ticks.

/** How far one can zoom: drawings are exact to a hundredth of a point. */
const DEEPEST = 40;
const NOTHING = ["Nothing is drawn here.", "Zoom out to see more."];
const SHADE = ["Only shading is in view.", "Zoom out to see more."];

/** Makes the panels in the sheet zoomable; `changed` is called whenever another part of one is seen. */
function makeZoomable(sheet, svg, panels, changed) {
  const [left, top, width, height] = svg.getAttribute("viewBox").split(/[\s,]+/).map(Number);
  svg.style.aspectRatio = `${width} / ${height}`;
  // A sketch has no panels: it is zoomed as a whole.
  const areas = panels.length > 0 ? panels : [{ bounds: { x: left, y: top, w: width, h: height } }];
  for (const area of areas) area.view = { ...area.bounds };
  const largest = areas.reduce((a, b) => (b.bounds.w * b.bounds.h > a.bounds.w * a.bounds.h ? b : a));
  let active = largest;
  let apart = false;

  const factor = (area) => area.bounds.w / area.view.w;
  const isZoomed = (area = active) => factor(area) > 1.0005;
  /** From the whole panel to what is seen of it, and back. */
  const toSeen = (area, x, y) => {
    const k = factor(area);
    return [area.bounds.x + (x - area.view.x) * k, area.bounds.y + (y - area.view.y) * k];
  };
  const toWhole = (area, { x, y }) => {
    const k = factor(area);
    return { x: area.view.x + (x - area.bounds.x) / k, y: area.view.y + (y - area.bounds.y) / k };
  };

  const draw = (area) => {
    area.added?.remove();
    area.added = null;
    const zoomed = isZoomed(area);
    for (const node of [...area.axes, ...area.beside]) {
      // What lies between two panels is hidden while either is zoomed.
      const hidden = zoomed || areas.some((other) => other !== area && isZoomed(other) && other.beside.includes(node));
      node.style.display = hidden ? "none" : "";
    }
    if (!zoomed) {
      area.parts.forEach((part) => part.restore());
      return;
    }
    const told = new Set(area.parts.map((part) => part.show((x, y) => toSeen(area, x, y))));
    const { x, y, w, h } = area.bounds;
    area.added = drawn("g");
    if (area.mark) {
      const ends = [area.toData({ x: area.view.x, y: area.view.y + area.view.h }), area.toData({ x: area.view.x + area.view.w, y: area.view.y })];
      area.added.append(drawAxes(area, [0, 1].map((axis) => [ends[0][axis], ends[1][axis]])));
    }
    if (!told.has(true)) {
      const size = Math.min(8, w / 12);
      (told.has("shade") ? SHADE : NOTHING).forEach((words, line) => {
        const place = { x: x + w / 2, y: y + h / 2 + line * 1.3 * size, "text-anchor": "middle", "font-size": size, fill: "#000000" };
        area.added.append(drawn("text", { ...place, class: "nothing" }, words));
      });
    }
    svg.append(area.added);
  };

  const show = (area, x, y, w) => {
    if (!apart) takeApart(svg, areas);
    apart = true;
    const { bounds } = area;
    const h = (w * bounds.h) / bounds.w;
    const between = (value, low, high) => Math.min(Math.max(value, low), Math.max(low, high));
    area.view = { x: between(x, bounds.x, bounds.x + bounds.w - w), y: between(y, bounds.y, bounds.y + bounds.h - h), w, h };
    active = area;
    draw(area);
    svg.dataset.zoom = Math.max(...areas.map(factor)).toFixed(3);
    sheet.classList.toggle("zoomed", areas.some(isZoomed));
    changed();
  };
  const middle = (area) => ({ x: area.bounds.x + area.bounds.w / 2, y: area.bounds.y + area.bounds.h / 2 });
  /** The panel at a point of the sheet. */
  const at = (point, margin = 0) =>
    areas.find(({ bounds: { x, y, w, h } }) => point.x >= x - margin && point.x <= x + w + margin && point.y >= y - margin && point.y <= y + h + margin);
  /** Magnifies a panel by a factor; the point of the sheet stays where it is. */
  const zoom = (by, point = middle(active)) => {
    const area = at(point) ?? active;
    const fixed = at(point) ? point : middle(area);
    const whole = toWhole(area, fixed);
    const w = Math.min(area.bounds.w, Math.max(area.bounds.w / DEEPEST, area.view.w / by));
    const part = w / area.bounds.w;
    show(area, whole.x - (fixed.x - area.bounds.x) * part, whole.y - (fixed.y - area.bounds.y) * part, w);
  };
  /** Moves the panel by parts of what is seen. */
  const move = (across, down) => show(active, active.view.x + across * active.view.w, active.view.y + down * active.view.h, active.view.w);
  const all = () => {
    for (const area of areas) if (isZoomed(area)) show(area, area.bounds.x, area.bounds.y, area.bounds.w);
    active = largest;
  };
  /** The point of the sheet under a pointer. */
  const toSheet = (event) => {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return { x: point.x, y: point.y };
  };
  /** How many pixels of the screen a point of the sheet is. */
  const scale = () => svg.getScreenCTM().a;

  gestures(sheet, {
    // Without focus the wheel scrolls the page, as everywhere else.
    scrolls: (event) => !event.ctrlKey && !event.metaKey && !sheet.contains(document.activeElement),
    zoom: (by, spot) => zoom(by, toSheet(spot)),
    press(event, held) {
      active = at(toSheet(event), 1) ?? active;
      if (!isZoomed() && held === 0) return;
      sheet.setPointerCapture(event.pointerId);
      sheet.classList.add("dragging");
    },
    drag(before, now) {
      const k = scale() * factor(active);
      if (isZoomed()) show(active, active.view.x - (now.clientX - before.clientX) / k, active.view.y - (now.clientY - before.clientY) / k, active.view.w);
    },
    pinch: (by, centre) => zoom(by, toSheet(centre)),
    release: (_, held) => held === 0 && sheet.classList.remove("dragging"),
  });
  sheet.addEventListener("dblclick", (event) => zoom(2, toSheet(event)));

  const redraw = () => areas.filter(isZoomed).forEach(draw);

  return { zoom, move, all, redraw, toSheet, toSeen, toWhole, factor, scale, isZoomed };
}

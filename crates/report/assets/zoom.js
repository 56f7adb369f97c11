"use strict";
// Zooming and moving a figure: the view box of its SVG changes, so everything stays sharp.

const DEEPEST = 100;

/** Makes the SVG in the sheet zoomable; `changed` is called whenever another part of it is seen. */
function makeZoomable(sheet, svg, changed) {
  const [left, top, width, height] = svg.getAttribute("viewBox").split(/[\s,]+/).map(Number);
  svg.style.aspectRatio = `${width} / ${height}`;
  let box = { x: left, y: top, w: width, h: height };

  const show = (x, y, w) => {
    const h = (w * height) / width;
    const within = (value, low, high) => Math.min(Math.max(value, low), Math.max(low, high));
    box = { x: within(x, left, left + width - w), y: within(y, top, top + height - h), w, h };
    svg.setAttribute("viewBox", `${box.x} ${box.y} ${box.w} ${box.h}`);
    sheet.classList.toggle("zoomed", isZoomed());
    changed();
  };
  const isZoomed = () => box.w < 0.999 * width;
  const middle = () => ({ x: box.x + box.w / 2, y: box.y + box.h / 2 });
  /** Magnifies by a factor; the point of the sheet stays where it is. */
  const zoom = (factor, point = middle()) => {
    const w = Math.min(width, Math.max(width / DEEPEST, box.w / factor));
    show(point.x - ((point.x - box.x) * w) / box.w, point.y - ((point.y - box.y) * w) / box.w, w);
  };
  /** Moves by parts of what is seen. */
  const move = (across, down) => show(box.x + across * box.w, box.y + down * box.h, box.w);
  const all = () => show(left, top, width);
  /** The point of the sheet under a pointer. */
  const toSheet = (event) => {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return { x: point.x, y: point.y };
  };
  /** How many pixels of the screen a point of the sheet is. */
  const scale = () => svg.getScreenCTM().a;

  sheet.addEventListener(
    "wheel",
    (event) => {
      // Without focus the wheel scrolls the page, as everywhere else.
      if (!event.ctrlKey && !event.metaKey && !sheet.contains(document.activeElement)) return;
      event.preventDefault();
      zoom(Math.exp(-event.deltaY * (event.deltaMode === 0 ? 0.002 : 0.05)), toSheet(event));
    },
    { passive: false },
  );
  sheet.addEventListener("dblclick", (event) => zoom(2, toSheet(event)));

  const held = new Map();
  sheet.addEventListener("pointerdown", (event) => {
    held.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (isZoomed() || held.size > 1) {
      sheet.setPointerCapture(event.pointerId);
      sheet.classList.add("dragging");
    }
  });
  sheet.addEventListener("pointermove", (event) => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const now = { x: event.clientX, y: event.clientY };
    if (held.size === 1) {
      if (isZoomed()) show(box.x - (now.x - before.x) / scale(), box.y - (now.y - before.y) / scale(), box.w);
    } else if (held.size === 2) {
      const other = [...held].find(([id]) => id !== event.pointerId)[1];
      const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
      const centre = { clientX: (now.x + other.x) / 2, clientY: (now.y + other.y) / 2 };
      zoom(distance(now, other) / Math.max(1, distance(before, other)), toSheet(centre));
    }
    held.set(event.pointerId, now);
  });
  const release = (event) => {
    held.delete(event.pointerId);
    if (held.size === 0) sheet.classList.remove("dragging");
  };
  sheet.addEventListener("pointerup", release);
  sheet.addEventListener("pointercancel", release);
  sheet.addEventListener("pointerleave", release);

  return { zoom, move, all, toSheet, scale, isZoomed };
}

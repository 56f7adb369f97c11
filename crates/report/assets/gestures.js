"use strict";
// Wheel, drag and pinch on an element, told as what they mean. Spots are { clientX, clientY }, as those of events.

/**
 * `on.zoom(factor, spot)` for the wheel, unless `on.scrolls(event)` leaves it to the page; `on.press(event, held)` with how many
 * pointers are down before it, `on.hover(event)`, `on.drag(before, event)` for one pointer, `on.pinch(factor, centre, [across, down])` for two,
 * by how much their middle has moved, and `on.release(event, held)` with how many are left.
 */
function gestures(element, on) {
  const held = new Map();
  const spot = ({ clientX, clientY }) => ({ clientX, clientY });
  element.addEventListener(
    "wheel",
    (event) => {
      if (on.scrolls?.(event)) return;
      event.preventDefault();
      on.zoom(Math.exp(-event.deltaY * (event.deltaMode === 0 ? 0.002 : 0.05)), event);
    },
    { passive: false },
  );
  element.addEventListener("pointerdown", (event) => {
    if (event.button > 1) return;
    on.press(event, held.size);
    held.set(event.pointerId, spot(event));
  });
  element.addEventListener("pointermove", (event) => {
    on.hover?.(event);
    const before = held.get(event.pointerId);
    if (!before) return;
    if (held.size === 1) on.drag(before, event);
    else if (held.size === 2) {
      const other = [...held].find(([id]) => id !== event.pointerId)[1];
      const distance = (a) => Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY);
      const centre = { clientX: (event.clientX + other.clientX) / 2, clientY: (event.clientY + other.clientY) / 2 };
      on.pinch(distance(event) / Math.max(1, distance(before)), centre, [(event.clientX - before.clientX) / 2, (event.clientY - before.clientY) / 2]);
    }
    held.set(event.pointerId, spot(event));
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) {
    element.addEventListener(end, (event) => held.delete(event.pointerId) && on.release(event, held.size));
  }
}

// Pointing at the plane: places, boxes, wheel and pinch, and the same from the keyboard.
import { $, coordinate } from "./dom.js";
import { axisPieces, plain } from "./markup.js";
import { description, viewOf, wholeView } from "./model.js";
import { tellOf } from "./pick.js";
import { frame, project, redraw, runs, shown, toParameters } from "./plane.js";
import * as state from "./state.js";

/** The narrowest view: so much of the whole plane's width, still far above rounding. */
const NARROWEST = 4e-10;
let boxing = false;

/** Zooms by a factor, above one inwards, about a point of the plane, that of the place or the middle. */
export function zoom(factor, about = null, live = false) {
  const value = state.get();
  const view = viewOf(value);
  const whole = wholeView();
  const seen = value.place && ["primary", "secondary"].every((axis, at) => value.place[at] > view[axis][0] && value.place[at] < view[axis][1]);
  const centre = about ?? (seen ? value.place : [(view.primary[0] + view.primary[1]) / 2, (view.secondary[0] + view.secondary[1]) / 2]);
  const part = (axis, at) => {
    const [low, high] = view[axis];
    const most = 20 * (whole[axis][1] - whole[axis][0]);
    const width = Math.min(most, Math.max((whole[axis][1] - whole[axis][0]) * NARROWEST, (high - low) / factor));
    const share = (centre[at] - low) / (high - low);
    return [centre[at] - share * width, centre[at] + (1 - share) * width];
  };
  state.update({ view: { primary: part("primary", 0), secondary: part("secondary", 1) } }, live);
}

export const whole = () => state.update({ view: null });

/** Moves the view by parts of its width and height. */
export function move(across, up, live = false) {
  const view = viewOf(state.get());
  const moved = ([low, high], part) => [low + part * (high - low), high + part * (high - low)];
  state.update({ view: { primary: moved(view.primary, across), secondary: moved(view.secondary, up) } }, live);
}

/** The next drag draws a box: for fingers, which have no shift key. */
export function startBox() {
  boxing = !boxing;
  document.querySelector('[data-command="box"]').setAttribute("aria-pressed", boxing);
  $("stage").classList.toggle("boxing", boxing);
}

/** Moves the place by parts of the view; the first time it comes into the middle. */
export function step(across, up) {
  const value = state.get();
  const view = viewOf(value);
  const inside = (at, [low, high]) => Math.min(high, Math.max(low, at));
  const middle = [(view.primary[0] + view.primary[1]) / 2, (view.secondary[0] + view.secondary[1]) / 2];
  const [p, s] = value.place ?? middle;
  const shift = value.place ? [across * (view.primary[1] - view.primary[0]), up * (view.secondary[1] - view.secondary[0])] : [0, 0];
  state.update({ place: [inside(p + shift[0], view.primary), inside(s + shift[1], view.secondary)] }, true);
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** The arrow keys; whether it was one. */
export function arrow(event) {
  const way = ARROWS[event.key];
  if (!way || event.altKey) return false;
  if (event.ctrlKey || event.metaKey) move(way[0] * 0.1, way[1] * 0.1);
  else step(...way.map((part) => part * (event.shiftKey ? 0.1 : 0.01)));
  return true;
}

/** What the pointer is over, in words. */
function tell(x, y) {
  const inside = x >= frame.x && x <= frame.x + frame.w && y >= frame.y && y <= frame.y + frame.h;
  if (!inside) return ($("pointer").textContent = "");
  const view = viewOf(state.get());
  const at = toParameters(x, y, view);
  const names = [description.primary, description.secondary].map((axis) => plain(axisPieces(axis)));
  const widths = [view.primary, view.secondary].map(([low, high]) => high - low);
  const told = tellOf(runs, [x, y], at, project(view));
  $("pointer").textContent = `${at.map((value, index) => `${names[index]} = ${coordinate(value, widths[index])}`).join(", ")}${told && ` · ${told}`}`;
}

/** Takes the pointers that come to the plane. */
export function attach() {
  const stage = $("stage");
  const held = new Map();
  let doing = null;
  const point = (event) => {
    const { left, top } = stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const clamp = ([x, y]) => [Math.min(frame.x + frame.w, Math.max(frame.x, x)), Math.min(frame.y + frame.h, Math.max(frame.y, y))];

  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 0 ? 0.0018 : 0.05)), toParameters(...clamp(point(event))), true);
  }, { passive: false });
  stage.addEventListener("dblclick", (event) => zoom(3, toParameters(...clamp(point(event)))));

  stage.addEventListener("pointerdown", (event) => {
    if (event.button > 1) return;
    const at = point(event);
    held.set(event.pointerId, at);
    stage.setPointerCapture(event.pointerId);
    $("plane").focus({ preventScroll: true });
    if (held.size > 1) doing = "pinch";
    else if (event.shiftKey || boxing) {
      doing = "box";
      shown.box = [...clamp(at), ...clamp(at)];
    } else if (event.button === 1 || event.ctrlKey || event.metaKey) doing = "move";
    else {
      const [x, y] = clamp(at);
      // What is held is the ring itself, not the pointer's offset from it.
      doing = "place";
      state.update({ place: toParameters(x, y) }, true);
    }
    event.preventDefault();
  });

  stage.addEventListener("pointermove", (event) => {
    const at = point(event);
    const before = held.get(event.pointerId);
    tell(...at);
    if (!before) return;
    if (doing === "place") state.update({ place: toParameters(...clamp(at)) }, true);
    else if (doing === "box") {
      shown.box = [shown.box[0], shown.box[1], ...clamp(at)];
      redraw();
    } else if (doing === "move") move((before[0] - at[0]) / frame.w, (at[1] - before[1]) / frame.h, true);
    else if (doing === "pinch" && held.size === 2) {
      const other = [...held].find(([id]) => id !== event.pointerId)[1];
      const length = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
      const centre = [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2];
      move((before[0] - at[0]) / 2 / frame.w, (at[1] - before[1]) / 2 / frame.h, true);
      zoom(length(at, other) / Math.max(1, length(before, other)), toParameters(...centre), true);
    }
    held.set(event.pointerId, at);
  });

  const release = (event) => {
    if (!held.delete(event.pointerId)) return;
    if (doing === "box" && shown.box) {
      const [ax, ay, bx, by] = shown.box;
      shown.box = null;
      if (boxing) startBox();
      if (Math.abs(bx - ax) > 4 && Math.abs(by - ay) > 4 && event.type === "pointerup") {
        const [[a, c], [b, d]] = [toParameters(Math.min(ax, bx), Math.max(ay, by)), toParameters(Math.max(ax, bx), Math.min(ay, by))];
        state.update({ view: { primary: [a, b], secondary: [c, d] } });
      } else redraw();
    } else if (doing === "place" && held.size === 0) state.update({});
    if (held.size === 0) doing = null;
  };
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
  stage.addEventListener("pointerleave", () => ($("pointer").textContent = ""));
}

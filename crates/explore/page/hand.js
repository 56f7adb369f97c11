// Pointing at the plane: places, boxes, wheel and pinch, and the same with the keyboard.
import { $, coordinate } from "./dom.js";
import { axisPieces, plain } from "./markup.js";
import { description, viewOf, wholeView } from "./model.js";
import { tellOf } from "./pick.js";
import { ends, frame, project, redraw, runs, shown, toParameters } from "./plane.js";
import * as state from "./state.js";

/** The width of the narrowest view, as a share of the whole plane, still far above rounding. */
const NARROWEST = 4e-10;
/** The distance in pixels up to which a pointer selects a place; beyond it the plane moves. */
const STILL = 4;
let boxing = false;

/** Zooms by a factor, inwards if it is above one, about a point: a given one, the place, or the middle. */
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

/** Moves the view by shares of its width and height. */
export function move(across, up, live = false) {
  const view = viewOf(state.get());
  const moved = ([low, high], part) => [low + part * (high - low), high + part * (high - low)];
  state.update({ view: { primary: moved(view.primary, across), secondary: moved(view.secondary, up) } }, live);
}

/** Switches whether the next drag draws a box: for fingers, which have no shift key. */
export function startBox() {
  boxing = !boxing;
  document.querySelector('[data-command="box"]').setAttribute("aria-pressed", boxing);
  $("stage").classList.toggle("boxing", boxing);
}

/** Moves the place by shares of the view; the first time it is put into the middle. */
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

/** Handles the arrow keys; returns whether the key was one. */
export function arrow(event) {
  const way = ARROWS[event.key];
  if (!way || event.altKey) return false;
  if (event.ctrlKey || event.metaKey) move(way[0] * 0.1, way[1] * 0.1);
  else step(...way.map((part) => part * (event.shiftKey ? 0.1 : 0.01)));
  return true;
}

/** Describes what is under the pointer. */
function tell(x, y) {
  const inside = x >= frame.x && x <= frame.x + frame.w && y >= frame.y && y <= frame.y + frame.h;
  if (!inside) return ($("pointer").textContent = "");
  const view = viewOf(state.get());
  const at = toParameters(x, y, view);
  const names = [description.primary, description.secondary].map((axis) => plain(axisPieces(axis)));
  const widths = [view.primary, view.secondary].map(([low, high]) => high - low);
  const told = tellOf(runs, ends(), [x, y], at, project(view));
  $("pointer").textContent = `${at.map((value, index) => `${names[index]} = ${coordinate(value, widths[index])}`).join(", ")}${told && ` · ${told}`}`;
}

/** Attaches the handlers of pointers on the plane. */
export function attach() {
  const stage = $("stage");
  let [doing, pressed, origin] = [null, null, null];
  const point = ({ clientX, clientY }) => {
    const { left, top } = stage.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  const clamp = ([x, y]) => [Math.min(frame.x + frame.w, Math.max(frame.x, x)), Math.min(frame.y + frame.h, Math.max(frame.y, y))];
  const at = (spot) => toParameters(...clamp(point(spot)));

  stage.addEventListener("dblclick", (event) => zoom(3, at(event)));
  gestures(stage, {
    zoom: (by, spot) => zoom(by, at(spot), true),
    press(event, held) {
      stage.setPointerCapture(event.pointerId);
      $("plane").focus({ preventScroll: true });
      if (held > 0) {
        // A pinch that begins at the ring does not move it.
        if (doing === "place") state.update({ place: origin }, true);
        shown.box = null;
        doing = "pinch";
      } else if (event.shiftKey || boxing) {
        doing = "box";
        shown.box = [...clamp(point(event)), ...clamp(point(event))];
      } else if (event.target.id === "handle" && event.button === 0) {
        // The drag holds the ring itself, without an offset of the pointer.
        doing = "place";
        origin = state.get().place;
        state.update({ place: at(event) }, true);
      } else doing = "point";
      pressed = point(event);
      event.preventDefault();
    },
    hover: (event) => tell(...point(event)),
    drag(before, event) {
      if (doing === "place") state.update({ place: at(event) }, true);
      else if (doing === "box") {
        shown.box = [shown.box[0], shown.box[1], ...clamp(point(event))];
        redraw();
      } else if (doing === "point" && Math.hypot(...point(event).map((each, k) => each - pressed[k])) > STILL) doing = "move";
      if (doing === "move") move((before.clientX - event.clientX) / frame.w, (event.clientY - before.clientY) / frame.h, true);
    },
    pinch(by, centre, [across, down]) {
      move(-across / frame.w, down / frame.h, true);
      zoom(by, at(centre), true);
    },
    release(event, held) {
      if (doing === "box" && shown.box) {
        const [ax, ay, bx, by] = shown.box;
        shown.box = null;
        if (boxing) startBox();
        if (Math.min(Math.abs(bx - ax), Math.abs(by - ay)) > STILL && event.type === "pointerup") {
          const [[a, c], [b, d]] = [toParameters(Math.min(ax, bx), Math.max(ay, by)), toParameters(Math.max(ax, bx), Math.min(ay, by))];
          state.update({ view: { primary: [a, b], secondary: [c, d] } });
        } else redraw();
      } else if (doing === "point" && event.type === "pointerup") state.update({ place: at(event) });
      else if (held === 0) state.update({});
      if (held === 0) doing = null;
    },
  });
  stage.addEventListener("pointerleave", () => ($("pointer").textContent = ""));
}

// Straightened coordinates: near a resonance all curves lie on one line of the plane, and here they are apart. The
// figure is the one that `unfold` draws, of the resonance nearest to the middle of the view.
import { $, rested } from "./dom.js";
import { file, Latest } from "./api.js";
import { diagram } from "./diagram.js";
import { modelOf, viewOf } from "./model.js";
import { frame } from "./plane.js";
import * as state from "./state.js";

/** The distance in pixels below which curves lie on one line. */
const MERGED = 2;

const latest = new Latest({ failed: ({ message }) => ($("straightened").removeAttribute("aria-busy"), tell(message)) });
/** The resonance of the figure, and the key of its request. */
let [shown, asked] = [null, ""];

function tell(words) {
  $("straightened-message").textContent = words;
  $("straightened-message").hidden = words === "";
}

/** The resonance nearest to the middle of the view, and whether its curves lie on one line there; or null. */
function nearest() {
  const { primary: [a, b], secondary: [c, d] } = viewOf(state.get());
  const far = ({ primary, secondary }) => Math.hypot((primary - a) / (b - a) - 0.5, (secondary - c) / (d - c) - 0.5);
  const found = diagram.resonances.filter(({ theorem_holds }) => theorem_holds).sort((one, other) => far(one) - far(other))[0];
  if (!found) return null;
  const bend = Math.max(...[found.c_sn, found.c_pd].map(Math.abs));
  return { ...found, merged: ((bend * ((d - c) / 2) ** 2) / (b - a)) * frame.w < MERGED };
}

/** Whether the figure is shown: on request, or automatically if the curves lie on one line. */
const isOn = (value, found) => value.straight ?? found?.merged ?? false;

export const toggle = () => state.update({ straight: !isOn(state.get(), nearest()) });

/** The request for the figure. */
export const wanted = () => shown && { straightened: [shown.primary, shown.secondary] };

const follow = rested(250, () => {
  const value = state.get();
  const found = nearest();
  const on = isOn(value, found);
  document.querySelector('[data-command="straighten"]').setAttribute("aria-pressed", on);
  $("straightened").hidden = !on;
  if (!on) return latest.stop();
  if (!found) return asked === "" && tell("The view contains no resonance at which a theorem holds.");
  const { p, n, primary, secondary } = found;
  const key = JSON.stringify([modelOf(value), p, n]);
  if (key === asked) return;
  asked = key;
  shown = null;
  tell("");
  $("straightened-what").textContent = `p = ${p}, n = ${n}`;
  const body = { model: modelOf(value), view: viewOf(value), what: "svg", columns: "one", of: { straightened: [primary, secondary] } };
  $("straightened").setAttribute("aria-busy", "true");
  latest.now(async (signal) => {
    const blob = await file("export", body, signal);
    if (signal.aborted) return;
    const figure = $("straightened-figure");
    URL.revokeObjectURL(figure.src);
    figure.src = URL.createObjectURL(blob);
    figure.alt = `Curves that leave the resonance p = ${p}, n = ${n} in straightened coordinates`;
    shown = found;
    $("straightened").removeAttribute("aria-busy");
  });
});

export { follow };

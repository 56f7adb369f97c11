// The inks of elements without a meaning of their own. Those of curves, regions, points and motions are in kinds.js,
// which the program writes: a colour has one meaning everywhere.
import { $, make } from "./dom.js";
import { APPROXIMATION, DOTTED, INKS, KINDS, LOOKS } from "./kinds.js";

const NEUTRAL = {
  light: { paper: "#ffffff", ink: "#1e1d1b", muted: "#63615b", faint: "#d9d6ce", wall: "#6e6e6e" },
  dark: { paper: "#1b1e23", ink: "#e7e5df", muted: "#a09e97", faint: "#3a3f47", wall: "#9a9a9a" },
};

const theme = () => (document.documentElement.dataset.theme === "dark" ? "dark" : "light");
export const inks = () => ({ ...NEUTRAL[theme()], ...INKS[theme()] });

/** The pen of a curve, dotted where it bounds no region: colour, width and dashes in pixels of the page. */
export function penOf({ kind, source }, bounds = true) {
  const look = LOOKS[kind];
  if (!bounds || source === "dotted") return { ...DOTTED, colour: look[theme()].curve };
  return source === "quadratic" ? { ...APPROXIMATION, colour: look[theme()].quadratic } : { ...look, colour: look[theme()].curve };
}

/** Lists the kinds of curves in the legend. */
export function listKinds() {
  const line = (kind) => make("svg", { viewBox: "0 0 28 10", "aria-hidden": "true" }, make("path", { class: kind, d: "M1 5h26" }));
  $("kinds").replaceWith(...KINDS.map((kind) => make("li", {}, line(kind), LOOKS[kind].legend)));
}

/** Draws the samples of the legend like the plane; the approximation to SN stands for all of them. */
export function drawSamples() {
  const { calm, stable, place } = inks();
  document.documentElement.style.setProperty("--place", place);
  for (const [kind, ink] of [["calm", calm], ["mps", stable]]) {
    document.querySelectorAll(`.area.${kind}`).forEach((sample) => (sample.style.background = ink));
  }
  for (const sample of document.querySelectorAll(".legend path[class]:not(.fill)")) {
    const kind = sample.getAttribute("class");
    const { colour, width, dashes } = kind in LOOKS ? penOf({ kind }) : penOf({ kind: "SN", source: kind });
    Object.assign(sample.style, { stroke: colour, strokeWidth: width, strokeDasharray: dashes.join(" ") || "none" });
  }
}

/** The ink of a curve, and of labels about it; undefined for other kinds. */
export const curveInk = (kind) => LOOKS[kind]?.[theme()].curve;
export const wordInk = (kind) => (kind === "graz" ? LOOKS[kind][theme()].quadratic : curveInk(kind));

/** The ink of motion with a number of loops, 0 without impacts; the last ink stands for that number or more. */
export const loopsInk = (p, ink = inks()) => ink.loops[Math.min(p, ink.loops.length - 1)];
/** The ink of a solution with so many impacts in p periods. */
export const solutionInk = ({ p, impacts }, ink = inks()) => (impacts > 1 ? ink.several : loopsInk(p, ink));
/** The names of numbers of loops with an ink of their own. */
export const loopsNames = () => inks().loops.map((_, p, { length }) => (p === 0 ? "no impacts" : `p ${p + 1 < length ? "=" : "≥"} ${p}`));

/** The inks of attractors, by kind, as in the simulated plane. */
export function attractorInks(attractors) {
  const ink = inks();
  return attractors.map(({ motion, periods, impacts, rests }) => {
    if (motion === "non-impacting") return ink.loops[0];
    if (motion !== "periodic") return ["chaotic", "unsettled"].includes(motion) ? ink.irregular : ink.wall;
    return !rests && Math.round(impacts * periods) === 1 ? loopsInk(periods, ink) : ink.periodic;
  });
}

/** Calls the function when the theme changes between light and dark. */
export const onTheme = (act) => new MutationObserver(act).observe(document.documentElement, { attributeFilter: ["data-theme"] });

// The inks of what has no meaning of its own. Those of curves, regions, points and motions stand in kinds.js, which the
// program writes: a colour means one thing wherever it is.
import { APPROXIMATION, DOTTED, INKS, LOOKS } from "./kinds.js";

const NEUTRAL = {
  light: { paper: "#ffffff", ink: "#1e1d1b", muted: "#63615b", faint: "#d9d6ce", wall: "#6e6e6e" },
  dark: { paper: "#1b1e23", ink: "#e7e5df", muted: "#a09e97", faint: "#3a3f47", wall: "#9a9a9a" },
};

const theme = () => (document.documentElement.dataset.theme === "dark" ? "dark" : "light");
export const inks = () => ({ ...NEUTRAL[theme()], ...INKS[theme()] });

/** How a curve is drawn, dotted where it bounds no region: colour, width and dashes in pixels of the page. */
export function penOf({ kind, source }, bounds = true) {
  const look = LOOKS[kind];
  if (!bounds || source === "dotted") return { ...DOTTED, colour: look[theme()].curve };
  return source === "quadratic" ? { ...APPROXIMATION, colour: look[theme()].quadratic } : { ...look, colour: look[theme()].curve };
}

/** Draws the samples in the legend as the plane is drawn; approximations are shown by that to SN. */
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

/** The ink of a curve's points, and of words about it; undefined for what is no curve. */
export const curveInk = (kind) => LOOKS[kind]?.[theme()].curve;
export const wordInk = (kind) => (kind === "graz" ? LOOKS[kind][theme()].quadratic : curveInk(kind));

/** The ink of motion with so many loops, 0 without impacts; the last is that of so many or more. */
export const loopsInk = (p, ink = inks()) => ink.loops[Math.min(p, ink.loops.length - 1)];
/** How numbers of loops with an ink of their own are called. */
export const loopsNames = () => inks().loops.map((_, p, { length }) => (p === 0 ? "no impacts" : `p ${p + 1 < length ? "=" : "≥"} ${p}`));

/** The inks of attractors: what they are, as in the simulated plane. */
export function attractorInks(attractors) {
  const ink = inks();
  return attractors.map(({ kind, loops }) => {
    if (kind === "non-impacting") return ink.loops[0];
    if (loops) return loopsInk(loops, ink);
    return kind === "periodic" ? ink.periodic : ["chaotic", "unsettled"].includes(kind) ? ink.irregular : ink.wall;
  });
}

/** Calls the function whenever light turns to dark or back. */
export const onTheme = (act) => new MutationObserver(act).observe(document.documentElement, { attributeFilter: ["data-theme"] });

// The inks of what no figure shows, on light and on dark. Those of curves, regions, points and branches stand in kinds.js,
// which the program writes.
import { APPROXIMATION, INKS, LOOKS } from "./kinds.js";

const OWN = {
  light: {
    paper: "#ffffff", ink: "#1e1d1b", muted: "#63615b", faint: "#d9d6ce",
    place: "#c2185b", kept: "#00796b", wall: "#6e6e6e", cloud: "rgba(45,70,105,0.55)",
  },
  dark: {
    paper: "#1b1e23", ink: "#e7e5df", muted: "#a09e97", faint: "#3a3f47",
    place: "#ff79ad", kept: "#4fd1bd", wall: "#9a9a9a", cloud: "rgba(160,190,230,0.5)",
  },
};

/** Tiles: p = 1, 2, ... (after Okabe and Ito); non-impacting; other periodic motion; the rest. */
const LOOPS = ["#e69f00", "#56b4e9", "#cc79a7", "#009e73", "#f0e442"];
const TILES = {
  light: { loops: LOOPS, calm: "#d6d6d6", periodic: "#9a8fd0", irregular: "#4a4652" },
  dark: { loops: ["#c98a00", "#4a9fd0", "#b86a95", "#008f68", "#d6cb3a"], calm: "#4b5058", periodic: "#7d72b8", irregular: "#0c0b10" },
};

const theme = () => (document.documentElement.dataset.theme === "dark" ? "dark" : "light");
export const inks = () => ({ ...OWN[theme()], ...INKS[theme()] });
export const tileInks = () => TILES[theme()];

/** How a curve is drawn: colour, width and dashes in pixels of the page. */
export function penOf({ kind, source }) {
  const look = LOOKS[kind];
  return source === "quadratic" ? { ...APPROXIMATION, colour: look[theme()].quadratic } : { ...look, colour: look[theme()].curve };
}

/** Draws the samples in the legend as the plane is drawn; approximations are shown by that to SN. */
export function drawSamples() {
  const { calm, loops } = inks();
  for (const [kind, ink] of [["calm", calm], ["mps", loops]]) {
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

export const branchInk = (p) => inks().branch[p] ?? inks().branch[0];

/** Inks of attractors: an MPS has that of its branch, as far as it is free, and others have what is left. */
export function attractorInks(attractors) {
  const free = new Set([2, 4, 3, 1, 5, 6, 0]);
  const wanted = ({ kind, loops }) => (kind === "non-impacting" ? 0 : (loops ?? null));
  const inks = attractors.map((each) => (free.delete(wanted(each)) ? wanted(each) : null));
  return inks.map((p) => {
    const own = p ?? [...free][0] ?? 0;
    free.delete(own);
    return branchInk(own);
  });
}

/** Calls the function whenever light turns to dark or back. */
export const onTheme = (act) => new MutationObserver(act).observe(document.documentElement, { attributeFilter: ["data-theme"] });

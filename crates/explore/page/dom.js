// Elements and text.
import { begin } from "./busy.js";

export const $ = (id) => document.getElementById(id);

const SVG = "http://www.w3.org/2000/svg";
const SHAPES = new Set(["svg", "path", "circle", "line", "rect"]);

/** An element with attributes (listeners for `on...`) and children: elements or text. */
export function make(name, attributes = {}, ...children) {
  const made = SHAPES.has(name) ? document.createElementNS(SVG, name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

/** A number with a number of significant digits, a true minus sign, and a power of ten if it is far from one. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(Math.max(0, digits - 1)).replace("e+", "e").replace(/-/g, "−");
  return String(Number(value.toPrecision(digits))).replace(/-/g, "−");
}

/** A coordinate with the digits that a step of `width` requires. */
export function coordinate(value, width) {
  const decimals = Math.min(16, Math.max(0, 3 - Math.floor(Math.log10(width))));
  return (decimals > 100 ? String(value) : value.toFixed(decimals)).replace("-", "−");
}

/** Two Floquet multipliers: two real ones, or a pair. */
export function multipliers([first, second]) {
  if (Math.abs(first[1]) > 1e-12) return `${number(first[0], 3)} ± ${number(Math.abs(first[1]), 3)}i`;
  return `${number(first[0], 3)}, ${number(second[0], 3)}`;
}

/** "1 loop", "2 loops". */
export const count = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;

/** Calls the function after a pause, unless the returned function is called before; the page is busy until then. */
export function later(pause, act) {
  const end = begin();
  const timer = setTimeout(() => {
    try {
      act();
    } finally {
      end();
    }
  }, pause);
  return () => {
    clearTimeout(timer);
    end();
  };
}

/** Calls the function after no further calls for this long. */
export function rested(wait, act) {
  const call = (...args) => {
    call.cancel();
    call.cancel = later(wait, () => act(...args));
  };
  call.cancel = () => {};
  return call;
}

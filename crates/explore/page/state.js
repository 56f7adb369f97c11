// The state: one value that determines everything on the page. It is stored in the address, and each rest of it is a
// step of the browser's history.
//
//   example  file name of an example, or null if `text` is given
//   text     the oscillator's file as edited, or null
//   set      values of constants over the file's
//   loops    numbers p, or null for those of the file
//   view     { primary: [a, b], secondary: [c, d] }, or null for the ranges of the file
//   place    [primary, secondary] or null; kept: another place, or null
//   cut      the name of the axis that the cut holds fixed, "primary" or "secondary", or null
//   ordinate the quantity on the vertical axis of the cut, or null: x
//   follow   { at, p, impacts, stops } of the solution whose curve is drawn, or null; impacts are [velocity, phase], the slowest first, stops the walls that they hit, if there are two
//   overlay  whether simulation is laid over the plane
//   data     the file of measurements, { name, text }, or null
//   straight whether curves are shown in straightened coordinates, or null: where they lie on one line
//   edit     whether the editor is open
import { rested } from "./dom.js";

const EMPTY = { example: null, text: null, set: {}, loops: null, view: null, place: null, kept: null, cut: null, ordinate: null, follow: null, overlay: false, straight: null, data: null, edit: false };
/** The short names of the address. */
const SHORT = { example: "e", text: "t", set: "s", loops: "l", view: "v", place: "p", kept: "k", cut: "c", ordinate: "u", follow: "f", overlay: "o", straight: "h", data: "d", edit: "w" };
const SETTLES = 350;

let state = { ...EMPTY };
const listeners = [];

export const get = () => state;

/** `listener(state, changed, live)`: changed is the set of names; live is true during dragging. */
export const subscribe = (listener) => listeners.push(listener);

function publish(next, live) {
  const changed = new Set(Object.keys(EMPTY).filter((key) => JSON.stringify(next[key]) !== JSON.stringify(state[key])));
  if (changed.size === 0 && live) return;
  state = next;
  for (const listener of listeners) listener(state, changed, live);
}

const settle = rested(SETTLES, () => {
  const address = encode(state);
  if (address !== location.hash) history.pushState({ step: (history.state?.step ?? 0) + 1 }, "", address || location.pathname);
});

/** Changes a part of the state. */
export function update(patch, live = false) {
  publish({ ...state, ...patch }, live);
  settle();
}

export function encode(value) {
  const short = {};
  for (const [name, key] of Object.entries(SHORT)) {
    if (JSON.stringify(value[name]) !== JSON.stringify(EMPTY[name])) short[key] = value[name];
  }
  if (short.v) short.v = [...short.v.primary, ...short.v.secondary];
  if (Object.keys(short).length === 0) return "";
  const bytes = new TextEncoder().encode(JSON.stringify(short));
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return `#${btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
}

const finite = (list, length) => Array.isArray(list) && list.length === length && list.every(Number.isFinite);

/** Reads an address; invalid entries are omitted, since anybody can write one. */
export function decode(hash) {
  const value = { ...EMPTY };
  if (hash.length < 2) return value;
  let short;
  try {
    const text = atob(hash.slice(1).replace(/-/g, "+").replace(/_/g, "/"));
    short = JSON.parse(new TextDecoder().decode(Uint8Array.from(text, (letter) => letter.charCodeAt(0))));
  } catch {
    return null;
  }
  if (typeof short !== "object" || short === null) return null;
  if (typeof short.e === "string") value.example = short.e;
  if (typeof short.t === "string") value.text = short.t;
  if (short.s && typeof short.s === "object") value.set = Object.fromEntries(Object.entries(short.s).filter(([, number]) => Number.isFinite(number)));
  if (Array.isArray(short.l) && short.l.length > 0 && short.l.every((p) => Number.isInteger(p) && p > 0)) value.loops = short.l;
  if (finite(short.v, 4) && short.v[0] < short.v[1] && short.v[2] < short.v[3]) value.view = { primary: short.v.slice(0, 2), secondary: short.v.slice(2) };
  if (finite(short.p, 2)) value.place = short.p;
  if (finite(short.k, 2)) value.kept = short.k;
  if (short.c === "primary" || short.c === "secondary") value.cut = short.c;
  if (typeof short.u === "string") value.ordinate = short.u;
  const { at, p, impacts, stops } = short.f ?? {};
  if (finite(at, 2) && Number.isFinite(p) && Array.isArray(impacts) && impacts.length > 0 && impacts.every((impact) => finite(impact, 2))) value.follow = { at, p, impacts, ...(Array.isArray(stops) && stops.every((stop) => stop === 0 || stop === 1) ? { stops } : {}) };
  value.overlay = short.o === true;
  if (typeof short.d?.name === "string" && typeof short.d?.text === "string") value.data = { name: short.d.name, text: short.d.text };
  if (typeof short.h === "boolean") value.straight = short.h;
  value.edit = short.w === true;
  return value;
}

/** Takes the state from the address, as after going back; returns whether it could be read. */
export function fromAddress() {
  settle.cancel();
  const read = decode(location.hash);
  publish(read ?? { ...EMPTY }, false);
  return read !== null;
}

addEventListener("popstate", fromAddress);
addEventListener("pagehide", () => {
  const address = encode(state);
  if (address !== location.hash) history.replaceState(history.state, "", address || location.pathname);
});

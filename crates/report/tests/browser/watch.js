"use strict";
// Everything that makes a browser lay the page out is noted while the page is being read.
const EARLY = [];
for (const [owner, names] of [
  [Element.prototype, ["getBoundingClientRect", "getClientRects", "clientWidth", "clientHeight", "scrollWidth", "scrollHeight", "scrollLeft", "scrollTop"]],
  [HTMLElement.prototype, ["offsetWidth", "offsetHeight", "offsetLeft", "offsetTop"]],
  [SVGGraphicsElement.prototype, ["getBBox", "getCTM", "getScreenCTM"]],
  [Range.prototype, ["getBoundingClientRect"]],
  [window, ["getComputedStyle"]],
]) {
  for (const name of names) {
    const asked = Object.getOwnPropertyDescriptor(owner, name);
    const key = asked.get ? "get" : "value";
    const ask = asked[key];
    asked[key] = function (...given) {
      if (document.readyState === "loading") EARLY.push(name);
      return ask.apply(this, given);
    };
    Object.defineProperty(owner, name, asked);
  }
}

"use strict";
// Wide formulas are set smaller, on the screen as far as it stays easy to read, on paper as far as it takes.

const SMALLEST_ON_SCREEN = 0.78;
/** Width of claims on paper, and size of the type there as part of that on the screen: see print.css. */
const PAPER = { width: 640, type: 0.667 };

function fitFormulas(all) {
  const formulas = all.filter((formula) => formula.clientWidth > 0);
  for (const formula of formulas) formula.style.removeProperty("--fit");
  // All are measured before any is changed, so that the page is laid out once.
  const ink = (formula) => {
    const range = document.createRange();
    range.selectNodeContents(formula.firstElementChild);
    return range.getBoundingClientRect().width;
  };
  const widths = formulas.map((formula) => [formula.clientWidth, ink(formula)]);
  formulas.forEach((formula, index) => {
    const [room, width] = widths[index];
    if (width > room) formula.style.setProperty("--fit", Math.max(SMALLEST_ON_SCREEN, (0.99 * room) / width));
    formula.style.setProperty("--fit-on-paper", Math.min(1, PAPER.width / (width * PAPER.type)));
  });
}
const formulas = [...document.querySelectorAll(".formula")];
/** Formulas that have come near the window, so that they are set. */
const near = new Set();
const comes = new IntersectionObserver(
  (entries) => {
    const come = entries.filter((entry) => entry.isIntersecting && !near.has(entry.target)).map((entry) => entry.target);
    come.forEach((formula) => near.add(formula));
    fitFormulas(come);
  },
  { rootMargin: "100%" },
);
// Not before the page is there: it would have to be laid out for this.
addEventListener("load", () => document.fonts.ready.then(() => formulas.forEach((formula) => comes.observe(formula))));
addEventListener("resize", () => fitFormulas([...near]));
addEventListener("beforeprint", () => fitFormulas(formulas));

"use strict";
// Wide formulas are set smaller, on the screen as far as it stays easy to read, on paper as far as it takes.

const SMALLEST_ON_SCREEN = 0.78;
/** Width of claims on paper, and size of the type there as part of that on the screen: see print.css. */
const PAPER = { width: 640, type: 0.667 };

function fitFormulas() {
  const formulas = [...document.querySelectorAll(".formula")].filter((formula) => formula.clientWidth > 0);
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
addEventListener("resize", fitFormulas);
document.fonts.ready.then(fitFormulas);

"use strict";
// The filters of the ledger, and links into what is filtered or folded away.

const filters = document.getElementById("claim-filters");
const claims = [...document.querySelectorAll(".claim")];

/** Words of LaTeX that only place what stands beside them. */
const PLACING = /\\(?:left|right|middle|[bB]igg?|d?tfrac|mathcal|mathrm|mathbb|text|operatorname|rm|begin|end|q?quad|displaystyle|[,;!: ])(?![a-zA-Z])/g;
const LETTERS = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", epsilon: "ε", varepsilon: "ε", zeta: "ζ", eta: "η", theta: "θ", kappa: "κ", lambda: "λ", mu: "μ",
  nu: "ν", xi: "ξ", pi: "π", rho: "ρ", sigma: "σ", tau: "τ", phi: "φ", varphi: "φ", chi: "χ", psi: "ψ", omega: "ω", infty: "∞", cdot: "", times: "×",
};

/** A formula without what only sets it, so that LaTeX, signs and names of letters are one: `c_{SN,p}`, `cSN,p`, `omega`. */
function bare(text) {
  return text
    .replace(PLACING, "")
    .toLowerCase()
    .replace(/\\?([a-z]+)/g, (word, name) => LETTERS[name] ?? name)
    .normalize("NFKC")
    .replace(/ϵ/g, "ε")
    .replace(/−/g, "-")
    .replace(/[\s{}_^\\$~&*]/g, "");
}

/** What a claim says, in words and as bare formulas, put together once it is asked for. */
const said = new Map();
function saidBy(claim) {
  if (!said.has(claim)) {
    const formulas = [...claim.querySelectorAll("[data-tex], math")];
    const texts = formulas.map((one) => one.dataset.tex ?? one.textContent);
    said.set(claim, { words: claim.textContent.toLowerCase(), formulas: texts.map(bare) });
  }
  return said.get(claim);
}

function filterClaims() {
  const wanted = Object.fromEntries([...new FormData(filters)].map(([name, value]) => [name, value.trim()]));
  const words = wanted.text.toLowerCase();
  const formula = bare(wanted.text);
  const says = (claim) => {
    const { words: text, formulas } = saidBy(claim);
    return text.includes(words) || (formula !== "" && formulas.some((one) => one.includes(formula)));
  };
  let left = 0;
  for (const claim of claims) {
    const state = wanted.state === "" || claim.dataset.state === wanted.state;
    const misprint = wanted.state === "misprint" && "misprint" in claim.dataset;
    const fits =
      (wanted.kind === "" || claim.dataset.kind === wanted.kind) &&
      (wanted.part === "" || claim.dataset.part === wanted.part) &&
      (state || misprint) &&
      (words === "" || says(claim));
    claim.hidden = !fits;
    if (fits) left += 1;
  }
  const output = filters.querySelector("output");
  output.textContent = left === claims.length ? `${left} claims` : `${left} of ${claims.length} claims`;
}

if (filters) {
  filters.addEventListener("input", filterClaims);
  filters.addEventListener("submit", (event) => event.preventDefault());
  // The fields are empty only after the event.
  filters.addEventListener("reset", () => setTimeout(filterClaims));
}

/** Opens and shows what the address points at, wherever it is. */
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  for (let folded = target.closest("details"); folded; folded = folded.parentElement.closest("details")) folded.open = true;
  if (target.hidden && filters) {
    filters.reset();
    filterClaims();
  }
  target.scrollIntoView();
}
addEventListener("hashchange", reveal);
if (location.hash) reveal();

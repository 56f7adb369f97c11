"use strict";
// The filters of the ledger, links into what is filtered or folded away, and the section that is being read.

const filters = document.getElementById("claim-filters");
const claims = [...document.querySelectorAll(".claim")];

function filterClaims() {
  const wanted = Object.fromEntries([...new FormData(filters)].map(([name, value]) => [name, value.trim()]));
  const words = wanted.text.toLowerCase();
  let left = 0;
  for (const claim of claims) {
    const state = wanted.state === "" || claim.dataset.state === wanted.state;
    const misprint = wanted.state === "misprint" && "misprint" in claim.dataset;
    const fits =
      (wanted.kind === "" || claim.dataset.kind === wanted.kind) &&
      (wanted.part === "" || claim.dataset.part === wanted.part) &&
      (state || misprint) &&
      (words === "" || claim.textContent.toLowerCase().includes(words));
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

const seen = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) {
      const link = document.querySelector(`.bar a[href="#${entry.target.id}"]`);
      if (entry.isIntersecting) link?.setAttribute("aria-current", "true");
      else link?.removeAttribute("aria-current");
    }
  },
  { rootMargin: "-40% 0px -59% 0px" },
);
document.querySelectorAll("main > section").forEach((section) => seen.observe(section));

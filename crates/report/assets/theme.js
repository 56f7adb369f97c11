"use strict";
// Light and dark: what the system prefers, until the button says otherwise. Runs before the page is drawn.
{
  const root = document.documentElement;
  root.classList.add("js");
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const CHOICES = ["auto", "light", "dark"];
  let choice = "auto";
  try {
    choice = localStorage.getItem("grazing-theme") || "auto";
  } catch {
    // A page from disk may have no storage; the choice then lasts as long as the page.
  }

  const apply = () => {
    root.dataset.theme = choice === "auto" ? (dark.matches ? "dark" : "light") : choice;
    const button = document.getElementById("theme");
    if (!button) return;
    // The word is left out where there is little room.
    const word = document.createElement("span");
    word.textContent = "Theme: ";
    button.replaceChildren(word, choice);
    button.setAttribute("aria-label", `Theme: ${choice}`);
  };
  if (!CHOICES.includes(choice)) choice = "auto";
  apply();
  dark.addEventListener("change", apply);
  document.addEventListener("DOMContentLoaded", () => {
    apply();
    document.getElementById("theme").addEventListener("click", () => {
      const next = { auto: dark.matches ? "light" : "dark", light: dark.matches ? "dark" : "auto", dark: dark.matches ? "auto" : "light" };
      choice = next[choice];
      try {
        localStorage.setItem("grazing-theme", choice);
      } catch {
        // As above.
      }
      apply();
    });
  });
}

// Names as symbols. The server sends titles in the markup of the printed figures, "$\mathcal{A}$ (N)"; constants are
// written as in the file, "omega_1". Both become pieces [text, "italic" | "sub" | "sup" | ""].
import { make } from "./dom.js";

const GREEK = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", epsilon: "ε", varepsilon: "ε", zeta: "ζ", eta: "η", theta: "θ", vartheta: "θ", iota: "ι",
  kappa: "κ", lambda: "λ", mu: "μ", nu: "ν", xi: "ξ", pi: "π", rho: "ρ", sigma: "σ", tau: "τ", upsilon: "υ", phi: "φ", varphi: "φ", chi: "χ",
  psi: "ψ", omega: "ω", Gamma: "Γ", Delta: "Δ", Theta: "Θ", Lambda: "Λ", Xi: "Ξ", Pi: "Π", Sigma: "Σ", Phi: "Φ", Psi: "Ψ", Omega: "Ω",
};
const SCRIPT = { A: "𝒜", P: "𝒫", V: "𝒱" };
const SIGNS = { cdot: "·", times: "×", circ: "°", "%": "%", ",": "\u2009", " ": " " };

/** The pieces of a formula without its dollars. */
function formula(text, place = "") {
  const pieces = [];
  const put = (word, style) => pieces.push([word, place || style]);
  for (const [, below, above, roman, script, command, letter, other] of text.matchAll(
    /_\{((?:[^{}]|\{[^{}]*\})*)\}|\^\{((?:[^{}]|\{[^{}]*\})*)\}|\\(?:mathrm|text)\{([^{}]*)\}|\\mathcal\{(\w)\}|\\([A-Za-z]+|.)|([A-Za-z])|([^{}])/gu,
  )) {
    if (below !== undefined) pieces.push(...formula(below, "sub"));
    else if (above !== undefined) pieces.push(...formula(above, "sup"));
    else if (roman !== undefined) put(roman, "");
    else if (script) put(SCRIPT[script] ?? script, SCRIPT[script] ? "" : "italic");
    else if (command) put(GREEK[command] ?? SIGNS[command] ?? command, GREEK[command] ? "italic" : "");
    else if (letter) put(letter, "italic");
    else put(other.replace("-", "−"), "");
  }
  return pieces;
}

/** The pieces of a title. */
export function titlePieces(title) {
  const braced = title.replace(/([_^])([A-Za-z0-9])/g, "$1{$2}");
  return braced.split("$").flatMap((part, index) => (index % 2 === 1 ? formula(part) : part === "" ? [] : [[part, ""]]));
}

/** The pieces of a constant's name: a Latin or Greek letter with the rest as index; words stay words. */
export function namePieces(name) {
  const parts = /^([A-Za-z]+?)(?:_(\w+)|(\d+))?$/.exec(name);
  const letter = parts && (GREEK[parts[1]] ?? (parts[1].length === 1 ? parts[1] : null));
  if (!letter) return [[name.replace(/_/g, " "), ""]];
  const index = parts[2] ?? parts[3];
  return index ? [[letter, "italic"], [index.replace(/_/g, " "), "sub"]] : [[letter, "italic"]];
}

/** The symbol of an axis, without its unit. */
export function axisPieces({ title, name, unit }) {
  if (!title) return namePieces(name);
  const bare = unit && title.lastIndexOf(" (") > 0 ? title.slice(0, title.lastIndexOf(" (")) : title;
  return bare.includes("$") ? titlePieces(bare) : namePieces(bare);
}

const TAGS = { italic: "i", sub: "sub", sup: "sup" };

/** Pieces as elements. */
export const elements = (pieces) => pieces.map(([text, style]) => (TAGS[style] ? make(TAGS[style], {}, text) : text));

/** Pieces as plain text. */
export const plain = (pieces) => pieces.map(([text]) => text).join("");

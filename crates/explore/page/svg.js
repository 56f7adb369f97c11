// A context that writes SVG: the part of a canvas context that the pictures of the page use.

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
const short = (value) => String(Math.round(100 * value) / 100);
const KEPT = ["fillStyle", "strokeStyle", "lineWidth", "globalAlpha", "font", "textAlign", "dashes", "move", "clips"];

export class SvgContext {
  constructor(width, height) {
    const ruler = document.createElement("canvas").getContext("2d");
    Object.assign(this, { width, height, ruler, parts: [], defs: [], path: "", saved: [], textBaseline: "", lineJoin: "" });
    Object.assign(this, { fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, globalAlpha: 1, font: "10px serif", textAlign: "left", dashes: [], move: "", clips: [] });
  }

  text() {
    const { width, height } = this;
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"><defs>${this.defs.join("")}</defs>${this.parts.join("")}</svg>\n`;
  }

  put(element) {
    const moved = this.move ? `<g transform="${this.move}">${element}</g>` : element;
    this.parts.push(this.clips.reduceRight((inner, id) => `<g clip-path="url(#${id})">${inner}</g>`, moved));
  }

  define(name, attributes, content) {
    const id = `${name}${this.defs.length}`;
    this.defs.push(`<${name} id="${id}" ${attributes}>${content}</${name}>`);
    return id;
  }

  save() {
    this.saved.push(KEPT.map((name) => this[name]));
  }

  restore() {
    this.saved.pop()?.forEach((value, at) => (this[KEPT[at]] = value));
  }

  translate(x, y) {
    this.move += `translate(${short(x)} ${short(y)})`;
  }

  rotate(angle) {
    this.move += `rotate(${short((180 * angle) / Math.PI)})`;
  }

  beginPath() {
    this.path = "";
  }

  moveTo(x, y) {
    this.path += `M${short(x)} ${short(y)}`;
  }

  lineTo(x, y) {
    this.path += `${this.path ? "L" : "M"}${short(x)} ${short(y)}`;
  }

  closePath() {
    this.path += "Z";
  }

  rect(x, y, w, h) {
    this.path += `M${short(x)} ${short(y)}h${short(w)}v${short(h)}h${short(-w)}Z`;
  }

  /** A whole circle: there are no other arcs. */
  arc(x, y, r) {
    this.path += `M${short(x - r)} ${short(y)}a${short(r)} ${short(r)} 0 1 0 ${short(2 * r)} 0a${short(r)} ${short(r)} 0 1 0 ${short(-2 * r)} 0`;
  }

  clip() {
    this.clips = [...this.clips, this.define("clipPath", "", `<path d="${this.path}"/>`)];
  }

  setLineDash(dashes) {
    this.dashes = dashes;
  }

  fill(rule = "nonzero") {
    if (this.path) this.put(`<path d="${this.path}" fill="${this.fillStyle}" fill-rule="${rule}" opacity="${this.globalAlpha}"/>`);
  }

  stroke() {
    if (this.path) this.put(`<path d="${this.path}" fill="none" stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}" stroke-dasharray="${this.dashes.join(" ") || "none"}" opacity="${this.globalAlpha}"/>`);
  }

  fillRect(x, y, w, h) {
    this.put(`<rect x="${short(x)}" y="${short(y)}" width="${short(w)}" height="${short(h)}" fill="${this.fillStyle}" opacity="${short(this.globalAlpha)}"/>`);
  }

  strokeRect(x, y, w, h) {
    this.path = "";
    this.rect(x, y, w, h);
    this.stroke();
  }

  measureText(text) {
    this.ruler.font = this.font;
    return this.ruler.measureText(text);
  }

  fillText(text, x, y) {
    const anchor = { center: "middle", right: "end" }[this.textAlign] ?? "start";
    this.put(`<text xml:space="preserve" x="${short(x)}" y="${short(y)}" text-anchor="${anchor}" fill="${this.fillStyle}" opacity="${this.globalAlpha}" textLength="${short(this.measureText(text).width)}" lengthAdjust="spacingAndGlyphs" style="font:${escaped(this.font)}">${escaped(text)}</text>`);
  }

  /** A pattern, which is always a tile. */
  createPattern(tile) {
    const side = tile.width / 2;
    const id = this.define("pattern", `width="${side}" height="${side}" patternUnits="userSpaceOnUse"`, `<image href="${tile.toDataURL()}" width="${side}" height="${side}"/>`);
    return { toString: () => `url(#${id})`, setTransform() {} };
  }

  drawImage(sheet, x, y, w, h) {
    this.put(`<image href="${sheet.toDataURL()}" x="${short(x)}" y="${short(y)}" width="${short(w)}" height="${short(h)}" preserveAspectRatio="none" style="image-rendering:pixelated" opacity="${this.globalAlpha}"/>`);
  }
}

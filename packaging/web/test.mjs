// Compares the page without a server with the server: the same requests get the same answers, byte for byte; and, if
// there is a Chromium, the page opens and draws.
// node packaging/web/test.mjs FOLDER GRAZING: the folder of the page, and the program.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, program] = process.argv.slice(2);
const duffing = await readFile(new URL("../../examples/duffing.toml", import.meta.url), "utf8");

/** A program that ends together with this one. */
function begun(name, flags, stdio) {
  const child = spawn(name, flags, { stdio });
  process.on("exit", () => child.kill());
  return child;
}

// The server of the program.
const server = begun(program, ["explore", "--no-browser"], ["ignore", "pipe", "inherit"]);
const address = await new Promise((resolve) => server.stdout.once("data", (text) => resolve(String(text).split("\n")[0])));
const served = async (path, body) => {
  const answer = await fetch(address + path, { method: "POST", headers: { "Content-Type": "application/json", Connection: "close" }, body });
  return { status: answer.status, kind: answer.headers.get("content-type"), content: await answer.text() };
};

// The program in a worker, as the page runs it.
const compiled = await WebAssembly.compile(await readFile(join(folder, "grazing.wasm")));
for (const { module } of WebAssembly.Module.imports(compiled)) assert.equal(module, "page", "the program wants what no page has");
let told = () => {};
globalThis.postMessage = (message) => told(message);
await import(pathToFileURL(join(folder, "worker.js")));
const alone = (path, body) =>
  new Promise((resolve) => {
    const events = [];
    const text = (bytes) => new TextDecoder().decode(bytes);
    told = ({ lost, event, status, kind, content }) => {
      assert.ok(!lost, path);
      if (event) events.push(text(event));
      else resolve({ status, kind, content: events.length > 0 ? events.join("") : text(content) });
    };
    globalThis.onmessage({ data: { compiled, path, body } });
  });

/**
 * Events without times and sorted, since threads send them in any order; cells of the plane one by one, since the
 * number sent at once depends on the time that they take.
 */
function settled({ kind, content }) {
  if (kind !== "text/event-stream") return content;
  const events = content.split("\n\n").filter((event) => !/^event: (progress|done)\n|^$/.test(event));
  const cells = (event) => {
    const tiles = /^event: tiles\ndata: (.*)$/.exec(event);
    return tiles ? JSON.parse(tiles[1]).cells.map((cell) => JSON.stringify(cell)) : [event];
  };
  return events.flatMap(cells).sort();
}

/** Sends a request to both, and returns both answers. */
async function same(path, asked) {
  const body = typeof asked === "string" ? asked : JSON.stringify(asked);
  const [there, here] = [await served(path, body), await alone(path, body)];
  assert.equal(here.status, there.status, path);
  assert.equal(here.kind, there.kind, path);
  const [left, right] = [here, there].map(settled);
  assert.ok(right.length > 0);
  assert.deepEqual(left, right, path);
  return right;
}

const event = (events, name) => events.filter((event) => event.startsWith(`event: ${name}\n`)).flatMap((event) => JSON.parse(event.split("data: ")[1]));

/** All that the page asks for, in a view with a resonance and with more regions than some. */
async function requests(model, view, some) {
  const { text } = model;
  await same("check", { text });
  const diagram = await same("diagram", { model, view });
  assert.ok(event(diagram, "regions").length > some);
  const [shown] = event(diagram, "curves").filter(({ kind, starts }) => kind === "SN" && starts);
  const middle = shown.points.length >> 1;
  const exact = JSON.parse(await same("exact", { model, view, kind: "SN", p: shown.p, start: shown.starts[middle], at: shown.points[middle] }));
  const at = [0.5 * (view.primary[0] + view.primary[1]), 0.5 * (view.secondary[0] + view.secondary[1])];
  const place = JSON.parse(await same("place", { model, at, states: 8 }));
  assert.ok(place.attractors.length > 0);
  await same("follow", { model, view, at: exact.at, p: shown.p, velocity: exact.velocity, phase: exact.phase });
  // A cut is simulated at hundreds of values, which is slow where motion is integrated.
  if (text === null) await same("cut", { model, fixed: "secondary", at: at[1], range: view.primary });
  await same("tiles", { model, view, columns: 12, rows: 9, periods: 120 });
}

await requests({ text: null }, { primary: [0, 1.3], secondary: [0.35, 1.02] }, 3);
await requests({ text: duffing, set: { zeta: 0.1 }, loops: [1] }, { primary: [0.6, 0.75], secondary: [0.74, 0.78] }, 1);
// Mistakes have the same messages.
await same("check", { text: duffing.replace("kappa*x^3", "kapa*x^3") });
await same("check", "{}{");
await same("place", { model: { text: null }, at: [1] });
await same("nothing", {});
console.log("the page without a server answers as the server does");
server.kill();

// The page in a browser, from a server of static files.
const KINDS = { ".css": "text/css", ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
const files = createServer(async (request, response) => {
  const name = new URL(request.url, "http://localhost").pathname.slice(1) || "index.html";
  const content = await readFile(join(folder, name)).catch(() => null);
  response.writeHead(content ? 200 : 404, { "Content-Type": KINDS[extname(name)] ?? "application/octet-stream" }).end(content);
});
await new Promise((resolve) => files.listen(0, "127.0.0.1", resolve));
const page = `http://127.0.0.1:${files.address().port}/`;
const browser = await started();
if (browser) {
  await browser.ask("Page.navigate", { url: page });
  // The result of a function once the page is idle.
  const settledPage = (said) =>
    `new Promise((ready) => { const look = async () => document.documentElement?.hasAttribute("data-busy") ?? true ? setTimeout(look, 100) : ready(await (${said})()); setTimeout(look, 1000); })`;
  const [title, curves, regions, text] = await browser.value(
    settledPage("async () => { const { diagram } = await import('./diagram.js'); return [document.title, diagram.curves.size, diagram.regions.length, document.getElementById('progress-text').textContent]; }"),
  );
  assert.ok(curves > 20 && regions > 10, `${title}: ${curves} curves, ${regions} regions: ${text}`);
  await browser.value("import('./state.js').then((state) => state.update({ place: [0.6, 0.7] }))");
  const place = await browser.value(settledPage("() => document.getElementById('places').textContent"));
  assert.match(place, /MPS, 1 loop 100 %/);
  if (process.env.SCREENSHOT) {
    const { data } = await browser.ask("Page.captureScreenshot", {});
    await (await import("node:fs/promises")).writeFile(process.env.SCREENSHOT, Buffer.from(data, "base64"));
  }
  console.log(`the page comes up without a server: ${curves} curves, ${regions} regions`);
  browser.end();
} else console.log("there is no Chromium: the page was not opened");
files.close();

/** A browser controlled through pipes; none if it is not installed. */
async function started() {
  for (const name of ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]) {
    const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--window-size=1400,900", "--remote-debugging-pipe", "about:blank"];
    const child = begun(name, flags, ["ignore", "ignore", "ignore", "pipe", "pipe"]);
    if (!(await new Promise((there) => child.once("spawn", () => there(true)).once("error", () => there(false))))) continue;
    const [, , , down, up] = child.stdio;
    const waiting = new Map();
    let rest = "";
    up.on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      for (const { id, result, error } of messages.map((message) => JSON.parse(message))) {
        waiting.get(id)?.(error ? Promise.reject(new Error(error.message)) : result);
        waiting.delete(id);
      }
    });
    let count = 0;
    const send = (method, params, sessionId) =>
      new Promise((resolve) => {
        waiting.set(++count, resolve);
        down.write(`${JSON.stringify({ id: count, method, params, sessionId })}\0`);
      });
    const { targetInfos } = await send("Target.getTargets", {});
    const { targetId } = targetInfos.find(({ type }) => type === "page");
    const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
    const ask = (method, params) => send(method, params, sessionId);
    const value = async (expression) => {
      const { result, exceptionDetails } = await ask("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
      if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
      return result.value;
    };
    return { ask, value, end: () => child.kill() };
  }
  return null;
}

// Counts what a page does while its constants are dragged, from within and without changing the page.
use("diagram").then(([d]) => {
  const watched = { frames: 0, longest: 0, answers: 0, gone: 0, slowest: 0, drawn: d.diagram.version, wrong: [], sums: {} };
  window.watched = watched;
  const wrong = (what) => watched.wrong.push(String(what));
  addEventListener("error", ({ message }) => wrong(message));
  addEventListener("unhandledrejection", ({ reason }) => wrong(reason));
  const words = document.getElementById("progress-text");
  new MutationObserver(() => words.classList.contains("bad") && wrong(words.textContent)).observe(words, { attributes: true, childList: true });

  // A frame is a drawn diagram that is complete, even if coarse.
  const paint = window.requestAnimationFrame.bind(window);
  let last = performance.now();
  window.requestAnimationFrame = (draw) =>
    paint((time) => {
      draw(time);
      if (d.diagram.version === watched.drawn) return;
      const now = performance.now();
      watched.longest = Math.max(watched.longest, now - last);
      last = now;
      watched.drawn = d.diagram.version;
      watched.frames += 1;
    });

  /** FNV-1a of the bits of numbers. */
  const sum = (numbers) => new Uint8Array(Float64Array.from(numbers).buffer).reduce((hash, byte) => Math.imul(hash ^ byte, 16777619), -2128831035) >>> 0;
  const read = (text, began, { coarse, model }) => {
    watched.answers += 1;
    watched.slowest = Math.max(watched.slowest, performance.now() - began);
    if (!text.includes("event: done\n")) wrong(text.slice(-200));
    if (!coarse) return;
    // The last lists are that of all curves, and that of the approximations to them.
    const lists = text.split("\n\n").filter((event) => event.startsWith("event: curves\n"));
    const curves = JSON.parse(lists.at(-2).split("\ndata: ")[1]);
    const [key, found] = [JSON.stringify(model.set), sum(curves.flatMap(({ points }) => points.flat()))];
    if ((watched.sums[key] ??= found) !== found) wrong(`${key}: two diagrams`);
  };
  const ask = window.fetch.bind(window);
  window.fetch = async (path, options) => {
    if (path !== "./diagram") return ask(path, options);
    const began = performance.now();
    const gone = (error) => (error.name === "AbortError" ? (watched.gone += 1) : wrong(error));
    const answer = await ask(path, options).catch((error) => {
      gone(error);
      throw error;
    });
    answer.clone().text().then((text) => read(text, began, JSON.parse(options.body))).catch(gone);
    return answer;
  };
})

// Talking to the server: one answer, or a stream of events. Who aborts a request ends its computation.

/** What the server refuses, in its own words. */
export class Refused extends Error {}

async function send(path, body, signal) {
  const options = body === undefined ? { signal } : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), signal };
  let answer;
  try {
    answer = await fetch(`./${path}`, options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused("The program does not answer. Is `grazing explore` still running?");
  }
  if (!answer.ok) {
    const told = await answer.json().catch(() => ({}));
    throw new Refused(told.message ?? `The program answered with status ${answer.status}.`);
  }
  return answer;
}

export const ask = async (path, body, signal) => (await send(path, body, signal)).json();

export const file = async (path, body, signal) => (await send(path, body, signal)).blob();

/** Reads a stream of events; `on[name](data)` is called for each. */
export async function stream(path, body, on, signal) {
  const answer = await send(path, body, signal);
  const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return;
    const blocks = (rest + value).split(/\r?\n\r?\n/);
    rest = blocks.pop();
    for (const block of blocks) {
      let name = "message";
      const data = [];
      for (const line of block.split(/\r?\n/)) {
        if (line.startsWith("event:")) name = line.slice(6).trim();
        else if (line.startsWith("data:")) data.push(line.slice(5));
      }
      if (data.length === 0) continue;
      const told = JSON.parse(data.join("\n"));
      if (name === "error") throw new Refused(told.message);
      on[name]?.(told);
    }
  }
}

/**
 * One computation at a time: a new one aborts the last. `live` ones come at most every `pause` milliseconds, and let
 * the one before them finish if it does so within `patience`, so that something is seen while a hand moves.
 */
export class Latest {
  constructor({ pause = 0, patience = 0, failed = () => {} } = {}) {
    Object.assign(this, { pause, patience, failed, begun: -1e9, running: null, waiting: 0 });
  }

  stop() {
    clearTimeout(this.waiting);
    this.running?.abort();
    this.running = null;
  }

  /** Runs `job(signal)` now. */
  now(job) {
    this.stop();
    const controller = new AbortController();
    this.running = controller;
    this.begun = performance.now();
    const own = () => this.running === controller;
    return job(controller.signal)
      .catch((error) => {
        if (error.name !== "AbortError" && own()) this.failed(error);
      })
      .finally(() => {
        if (own()) this.running = null;
      });
  }

  /** Runs the last job that was given, when its turn comes. */
  live(job) {
    clearTimeout(this.waiting);
    const turn = () => {
      const passed = performance.now() - this.begun;
      if (passed < this.pause) this.waiting = setTimeout(turn, this.pause - passed);
      else if (this.running && passed < this.patience) this.waiting = setTimeout(turn, 15);
      else this.now(job);
    };
    turn();
  }
}

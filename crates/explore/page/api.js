// Requests to the program: one answer, or a stream of events. Aborting a request ends its computation.
import { begin } from "./busy.js";
import { later } from "./dom.js";
import { LOST, reach } from "./reach.js";

/** An error of the program, with its own message. */
export class Refused extends Error {}

async function send(path, body, signal) {
  const options = body === undefined ? { signal } : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), signal };
  let answer;
  try {
    answer = await reach(path, options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused(LOST);
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
 * One computation at a time: a new one aborts the last. `live` ones start at most every `pause` milliseconds, and let
 * the live one before them finish, so that something is drawn during dragging. It is aborted after `patience`, or twice
 * the time of the last one; after a failure the next one has twice the time, so that one finishes however many others
 * the program serves.
 */
export class Latest {
  constructor({ pause = 0, patience = 0, failed = () => {} } = {}) {
    Object.assign(this, { pause, patience, bears: patience, failed, begun: -1e9, running: null, isLive: false, unwait: () => {} });
  }

  stop() {
    this.unwait();
    this.running?.abort();
    this.running = null;
  }

  /** Runs `job(signal)` now. */
  now(job, isLive = false) {
    this.stop();
    const controller = new AbortController();
    const begun = performance.now();
    Object.assign(this, { running: controller, isLive, begun });
    const own = () => this.running === controller;
    const end = begin();
    return job(controller.signal)
      .then(() => {
        if (isLive) this.bears = Math.max(this.patience, 2 * (performance.now() - begun));
      })
      .catch((error) => {
        if (error.name !== "AbortError" && own()) this.failed(error);
      })
      .finally(() => {
        if (own()) this.running = null;
        end();
      });
  }

  /** Runs the job that was passed last, when its turn comes. */
  live(job) {
    this.next(job, true);
  }

  /** Runs a job after dragging, which may only have paused: the live one before it may finish, too. */
  rested(job) {
    this.next(job, false);
  }

  next(job, isLive) {
    this.unwait();
    const passed = performance.now() - this.begun;
    const before = this.running && this.isLive;
    if (isLive && passed < this.pause) this.unwait = later(this.pause - passed, () => this.next(job, isLive));
    else if (before && passed < this.bears) this.unwait = later(15, () => this.next(job, isLive));
    else {
      if (before) this.bears *= 2;
      this.now(job, isLive);
    }
  }
}

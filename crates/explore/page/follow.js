// The curve through a solution at the place along which the velocity of its slowest impact is constant.
import { number } from "./dom.js";
import { ask, Latest } from "./api.js";
import { resay, say } from "./diagram.js";
import { modelOf, viewOf } from "./model.js";
import * as state from "./state.js";

const latest = new Latest({ failed: ({ message }) => ((failed = true), say(`Not followed: ${message}`, true)) });
let [curves, asked, failed] = [[], "", false];
let changed = () => {};
export const onFollowed = (act) => (changed = act);

/** The pieces of the curve, as curves of the diagram. */
export const followed = () => curves;

export function follow(value, live) {
  if (live) return;
  const body = value.follow && { model: modelOf(value), view: viewOf(value), ...value.follow };
  if (failed && JSON.stringify(body) !== asked) {
    failed = false;
    resay();
  }
  if (!body) {
    latest.stop();
    if (curves.length > 0) changed();
    [curves, asked] = [[], ""];
    return;
  }
  const of = JSON.stringify(body.model);
  if (JSON.stringify(body) === asked) return;
  asked = JSON.stringify(body);
  latest.now(async (signal) => {
    const found = await ask("follow", body, signal);
    if (signal.aborted) return;
    const [[velocity]] = body.impacts;
    const name = `velocity ${number(velocity, 3)}`;
    const property = `${body.impacts.length > 1 ? "lowest " : ""}impact velocity = ${number(velocity, 6)}`;
    curves = found.map((curve, at) => ({ ...curve, key: `followed ${at}`, followed: true, name, property, of }));
    changed();
  });
}

/** Whether a solution is the followed one. */
export const isFollowed = (known, at) => {
  const { follow: own } = state.get();
  return own !== null && own.p === known.p && own.impacts.join() === known.impacts.join() && own.at.join() === at.join();
};

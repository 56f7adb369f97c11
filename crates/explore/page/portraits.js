// Motion at a place in three pictures: phase portrait, time series, and impacts by phase and velocity.
import { chart, font, trace } from "./axes.js";
import { number } from "./dom.js";
import { description } from "./model.js";
import { inks } from "./palette.js";

/** The most and the fewest forcing periods of the time series. */
const LONGEST = 12;
const SHORTEST = 4;
/** The room around the drawing, as a share of its size. */
const ROOM = 0.07;

/** The range of values with some room. */
function extent(values, room = ROOM) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return [-1, 1];
  const more = high > low ? room * (high - low) : Math.max(1e-9, 0.1 * Math.abs(high) || 1);
  return [low - more, high + more];
}

/** A canvas with axes, or null. */
function picture(canvas, x, y) {
  const ink = inks();
  const made = chart(canvas, () => MARGIN, { x, y }, ink, SIZE);
  return made && { ...made, ink };
}

/** The size of the numbers at the axes. */
const SIZE = 11;
/** Room for the longest numbers, so that frames stay where they are. */
const MARGIN = { left: 60, right: 8, top: 8, bottom: 36 };

function line(context, points, colour, width, dashes = []) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dashes);
  context.lineJoin = "round";
  context.beginPath();
  trace(context, points);
  context.stroke();
  context.setLineDash([]);
}

/**
 * The titles of x, as it is measured in the page, and of v: from the wall unless that is x = 0 with the motion below
 * it.
 */
export const heightTitle = () => ({ title: [["x", "italic"], [description.from_the_wall ? " from the wall" : "", ""]], unit: description.units.length });
const speedTitle = (name) => {
  const { length, time } = description.units;
  return { title: name, unit: length && time ? `${length}/${time}` : null };
};

/** Shades the space behind the wall between two corners of a picture. */
function shadeWall({ context, ink }, [left, top], [right, bottom]) {
  context.globalAlpha = 0.16;
  context.fillStyle = ink.wall;
  context.fillRect(Math.min(left, right), Math.min(top, bottom), Math.abs(right - left), Math.abs(bottom - top));
  context.globalAlpha = 1;
}

/** The flights up to a time. */
const upTo = (orbit, end) => orbit.map((flight) => flight.filter(([t]) => t <= end)).filter((flight) => flight.length > 0);

/**
 * Draws the pictures. `orbits` is [{ orbit, ink, wide, dashed, periods }], with the number of periods after which the
 * orbit repeats, or null, and with `repeats`, whether the given orbit begins again at its end; `strikes` is [{ strikes,
 * ink }]; canvases is { phase, time, strikes }. `beyond` is where the other of two walls is at even steps of a period.
 */
export function drawPortraits(canvases, { orbits, strikes, period, beyond = [] }) {
  const starts = orbits.map(({ orbit }) => orbit[0]?.[0]?.[0] ?? 0);
  const all = orbits.flatMap(({ orbit }) => orbit.flat());
  const xs = extent([...all.map(([, x]) => x), 0, ...beyond]);
  const still = beyond.length > 0 && Math.max(...beyond) - Math.min(...beyond) < 1e-9 * (xs[1] - xs[0]);
  const vs = extent(all.map(([, , v]) => v));
  const x = { range: xs, ...heightTitle(), at: 11 };

  const phase = picture(canvases.phase, x, { range: vs, ...speedTitle([["v", "italic"]]), at: 11 });
  if (phase) {
    const { context, to, ink } = phase;
    shadeWall(phase, to([0, vs[0]]), to([xs[1], vs[1]]));
    line(context, [to([0, vs[0]]), to([0, vs[1]])], ink.wall, 1);
    if (still) {
      shadeWall(phase, to([xs[0], vs[0]]), to([beyond[0], vs[1]]));
      line(context, [to([beyond[0], vs[0]]), to([beyond[0], vs[1]])], ink.wall, 1);
    }
    line(context, [to([xs[0], 0]), to([xs[1], 0])], ink.faint, 1);
    orbits.forEach(({ orbit: all, ink: colour, wide, dashed, periods }, which) => {
      // Only once round a closed orbit: dashes drawn over dashes are not visible.
      const orbit = periods ? upTo(all, starts[which] + (periods + 1e-3) * period) : all;
      orbit.forEach((flight, index) => {
        line(context, flight.map(([, px, v]) => to([px, v])), colour, wide, dashed ? [4, 3] : []);
        const next = orbit[index + 1];
        if (next?.length && flight.length) line(context, [flight.at(-1), next[0]].map(([, px, v]) => to([px, v])), colour, Math.min(wide, 0.8), [2, 2]);
      });
    });
    phase.end();
  }

  const lengths = orbits.map(({ orbit }, index) => (orbit.at(-1)?.at(-1)?.[0] ?? 0) - starts[index]);
  const turns = orbits.every(({ periods }) => periods) ? Math.max(0, ...orbits.map(({ periods }) => 2 * periods)) : Math.round(Math.max(...lengths) / period);
  const most = Math.min(LONGEST, Math.max(SHORTEST, turns));
  const time = picture(canvases.time, { range: [0, most], title: [["t", "italic"], [" / ", ""], ["T", "italic"], [`,  `, ""], ["T", "italic"], [` = ${number(period, 4)}${description.units.time ? ` ${description.units.time}` : ""}`, ""]] }, x);
  if (time) {
    const { context, to, ink } = time;
    shadeWall(time, to([0, 0]), to([most, xs[1]]));
    line(context, [to([0, 0]), to([most, 0])], ink.wall, 1);
    const other = (step) => to([step / beyond.length, beyond[step % beyond.length]]);
    if (beyond.length > 0) line(context, Array.from({ length: Math.floor(most * beyond.length) + 1 }, (_, step) => other(step)), ink.wall, 1);
    orbits.forEach(({ orbit, ink: colour, wide, dashed, repeats }, index) => {
      const turns = repeats && lengths[index] > 0 ? Math.ceil((most * period) / lengths[index] - 1e-6) : 1;
      // In whole periods from phase zero.
      const whole = period * Math.floor(starts[index] / period);
      for (let turn = repeats ? -1 : 0; turn < Math.min(turns, LONGEST); turn += 1) {
        const shift = whole - turn * lengths[index];
        for (const flight of upTo(orbit, starts[index] + most * period)) line(context, flight.map(([t, px]) => to([(t - shift) / period, px])), colour, wide, dashed ? [4, 3] : []);
      }
    });
    time.end();
  }

  const struck = strikes.flatMap((each) => each.strikes);
  const top = struck.length ? 1.08 * Math.max(...struck.map(([v]) => Math.abs(v))) : 1;
  const sign = struck.some(([v]) => v < 0) ? -1 : 1;
  // Phases are shifted so that the impacts are close together: those on both sides of phase 0 are neighbours.
  const spread = (list) => (list.length ? Math.max(...list) - Math.min(...list) : 0);
  const about = ([, z]) => (z > Math.PI ? z - 2 * Math.PI : z);
  const turned = spread(struck.map(about)) < spread(struck.map(([, z]) => z));
  const from = turned ? -Math.PI : 0;
  const impacts = picture(canvases.strikes, { range: [from - 0.25, from + 2 * Math.PI + 0.25], title: [["phase", ""]], unit: "rad" }, { range: sign > 0 ? [0, top] : [-top, 0], ...speedTitle([["impact velocity", ""]]), at: 11 });
  if (impacts) {
    const { context, to, ink, frame } = impacts;
    for (const { strikes: list, ink: colour } of strikes) {
      context.fillStyle = colour;
      // The more impacts, the fainter, down to the opacity at which a single one is visible.
      const size = list.length > 60 ? 1.4 : 3;
      context.globalAlpha = list.length > 60 ? Math.max(0.5, 1 - list.length / 8000) : 1;
      for (const strike of list) {
        context.beginPath();
        context.arc(...to([turned ? about(strike) : strike[1], strike[0]]), size, 0, 2 * Math.PI);
        context.fill();
      }
      context.globalAlpha = 1;
    }
    if (struck.length === 0) {
      context.fillStyle = ink.muted;
      context.font = font(13, true);
      context.textAlign = "center";
      context.fillText("no impacts", frame.x + frame.w / 2, frame.y + frame.h / 2);
    }
    impacts.end();
  }
}

// What an oscillator does at a place, in three pictures: phase portrait, time series, and impacts by phase and velocity.
import { chart, font, trace } from "./axes.js";
import { inks } from "./palette.js";

/** Forcing periods of the time series: most, and least. */
const LONGEST = 12;
const SHORTEST = 4;
/** Room about what is drawn, in parts of it. */
const ROOM = 0.07;

/** The least and the largest with some room. */
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

/** A canvas with axes; gives what draws in it, or null. */
function picture(canvas, x, y) {
  const ink = inks();
  const made = chart(canvas, () => MARGIN, { x, y }, ink, SIZE);
  return made && { ...made, ink };
}

/** Of the numbers at the axes. */
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

/** Thin lines within the wall, on the side away from the motion. */
function shadeWall(context, edge, away, colour) {
  context.globalAlpha = 0.16;
  context.fillStyle = colour;
  context.beginPath();
  trace(context, [...edge, ...away], true);
  context.fill();
  context.globalAlpha = 1;
}

/** Flights of at most so many periods. */
const upTo = (orbit, end) => orbit.map((flight) => flight.filter(([t]) => t <= end)).filter((flight) => flight.length > 0);

/**
 * Draws the pictures. `orbits` is [{ orbit, ink, wide, dashed, periods }], with the periods after which it repeats, or null, and whether what is
 * given `repeats` at its end; `strikes` is [{ strikes, ink }]; canvases is { phase, time, strikes }.
 */
export function drawPortraits(canvases, { orbits, strikes, wall, period }) {
  const starts = orbits.map(({ orbit }) => orbit[0]?.[0]?.[0] ?? 0);
  const all = orbits.flatMap(({ orbit }) => orbit.flat());
  const wallX = wall.map(([, x]) => x);
  const xs = extent([...all.map(([, x]) => x), ...wallX]);
  const vs = extent(all.map(([, , v]) => v));
  const mean = all.reduce((sum, [, x]) => sum + x, 0) / Math.max(1, all.length);
  const above = wallX.reduce((sum, x) => sum + x, 0) / wallX.length >= mean;
  const x = { range: xs, title: [["x", "italic"]], at: 11 };

  const phase = picture(canvases.phase, x, { range: vs, title: [["v", "italic"]], at: 11 });
  if (phase) {
    const { context, to, ink, frame } = phase;
    const [near, far] = above ? [Math.min(...wallX), xs[1]] : [Math.max(...wallX), xs[0]];
    const [a, b] = [to([near, 0])[0], to([far, 0])[0]];
    // A wall that moves is lighter where it is only at times.
    for (const edge of new Set([a, to([above ? Math.max(...wallX) : Math.min(...wallX), 0])[0]])) {
      shadeWall(context, [[edge, frame.y], [edge, frame.y + frame.h]], [[b, frame.y + frame.h], [b, frame.y]], ink.wall);
    }
    line(context, [[a, frame.y], [a, frame.y + frame.h]], ink.wall, 1);
    line(context, [to([xs[0], 0]), to([xs[1], 0])], ink.faint, 1);
    orbits.forEach(({ orbit: all, ink: colour, wide, dashed, periods }, which) => {
      // Once round, if it comes again: dashes over dashes are none.
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
  const time = picture(canvases.time, { range: [0, most], title: [["t", "italic"], [" / ", ""], ["T", "italic"]] }, x);
  if (time) {
    const { context, to, ink } = time;
    const edge = [];
    for (let turn = -1; turn <= most + 1; turn += 1) for (const [t, px] of wall) edge.push(to([turn + (t - wall[0][0]) / period, px]));
    const rim = above ? xs[1] : xs[0];
    shadeWall(context, edge, [to([most + 1, rim]), to([-1, rim])], ink.wall);
    line(context, edge, ink.wall, 1);
    orbits.forEach(({ orbit, ink: colour, wide, dashed, repeats }, index) => {
      const turns = repeats && lengths[index] > 0 ? Math.ceil((most * period) / lengths[index] - 1e-6) : 1;
      // In whole periods from phase zero, as the wall is drawn.
      const whole = period * Math.floor(starts[index] / period);
      for (let turn = repeats ? -1 : 0; turn < Math.min(turns, LONGEST); turn += 1) {
        const shift = whole - turn * lengths[index];
        for (const flight of upTo(orbit, starts[index] + most * period)) line(context, flight.map(([t, px]) => to([(t - shift) / period, px])), colour, wide, dashed ? [4, 3] : []);
      }
    });
    time.end();
  }

  const struck = strikes.flatMap((each) => each.strikes);
  const top = struck.length ? 1.08 * Math.max(...struck.map(([, v]) => Math.abs(v))) : 1;
  const sign = struck.some(([, v]) => v < 0) ? -1 : 1;
  // Counted from where the impacts stand together: those about phase 0 are neighbours.
  const spread = (list) => (list.length ? Math.max(...list) - Math.min(...list) : 0);
  const about = ([z]) => (z > Math.PI ? z - 2 * Math.PI : z);
  const turned = spread(struck.map(about)) < spread(struck.map(([z]) => z));
  const from = turned ? -Math.PI : 0;
  const impacts = picture(canvases.strikes, { range: [from - 0.25, from + 2 * Math.PI + 0.25], title: [["phase of impact", ""]] }, { range: sign > 0 ? [0, top] : [-top, 0], title: [["velocity", ""]], at: 11 });
  if (impacts) {
    const { context, to, ink, frame } = impacts;
    for (const { strikes: list, ink: colour } of strikes) {
      context.fillStyle = colour;
      const size = list.length > 60 ? 1.3 : 3;
      context.globalAlpha = list.length > 60 ? 0.7 : 1;
      for (const place of list) {
        context.beginPath();
        context.arc(...to([turned ? about(place) : place[0], place[1]]), size, 0, 2 * Math.PI);
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

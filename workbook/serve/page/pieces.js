// Positions of an axis from the pieces that the server gave, so that a line follows the pointer without it.

/**
 * @typedef {{from: number, to: number, x: number[]}} Piece  s = sum x[k] u^k from 0 to 1, in the phase's own time 0..1
 * @typedef {{index: number, from: number|null, to: number|null, lift: number|null, law: string}} Phase
 * @typedef {{index: number, name: string, unit: string, shift: number, phases: Phase[]}} Axis
 * @typedef {{start: number, pieces: Piece[][], stale?: boolean, error?: string|null}} Figure
 * @typedef {{path: (string|number)[], value: number}} Change
 */

const SAMPLES = 32; // of a phase: a chord is then within a tenth of a picture's point

/** The rest of a number after division, never negative. @param {number} value @param {number} length */
export const wrapped = (value, length) => ((value % length) + length) % length;

/** What a signal holds, or the value itself. @param {any} given @returns {any} */
export const held = (given) => (given?.peek ? given.value : given);

/** The share of its lift that a phase has done. @param {Piece[]|undefined} pieces @param {number} time 0..1 */
export function shareOf(pieces, time) {
  if (time <= 0) return 0;
  if (time >= 1) return 1;
  const piece = pieces?.find((one) => time <= one.to);
  if (!piece) return time;
  const u = (time - piece.from) / (piece.to - piece.from);
  return piece.x.reduceRight((sum, coefficient) => sum * u + coefficient, 0);
}

/** Whether a phase has all its figures. @param {Phase} phase */
export const isWhole = ({ from, to }) => from !== null && to !== null && to > from;

/**
 * A function of an axis' own time (0 to the period's length) that returns its position.
 * @param {Axis} axis @param {Figure|undefined} figure @param {number} length
 */
export function positions(axis, figure, length) {
  const moves = axis.phases.filter(isWhole).map((phase) => {
    const { from, to } = /** @type {{from: number, to: number}} */ (phase);
    const pieces = figure?.pieces?.[axis.phases.indexOf(phase)];
    const share = (/** @type {number} */ time) => shareOf(pieces, (time - from) / (to - from));
    const before = share(length); // below 1 where it goes on past the period's end
    const tail = before < 1 ? (/** @type {number} */ time) => share(time + length) - before : () => 0;
    return { lift: phase.lift ?? 0, at: (/** @type {number} */ time) => share(time) + tail(time) };
  });
  const start = figure?.start ?? 0;
  return (/** @type {number} */ time) => moves.reduce((sum, { lift, at }) => sum + lift * at(time), start);
}

/**
 * The line of an axis over the period, as runs of [angle, position]: two runs where its shift parts it.
 * @param {Axis} axis @param {Figure|undefined} figure @param {number} length @returns {[number, number][][]}
 */
export function lineOf(axis, figure, length) {
  const at = positions(axis, figure, length);
  const shift = wrapped(axis.shift ?? 0, length);
  const times = new Set([0, length, length - shift]);
  for (const { from, to } of /** @type {{from: number, to: number}[]} */ (axis.phases.filter(isWhole))) {
    for (let k = 0; k <= SAMPLES; k += 1) {
      const time = from + ((to - from) * k) / SAMPLES;
      times.add(time > length ? time - length : time);
    }
  }
  const sorted = [...times].sort((a, b) => a - b);
  const run = (/** @type {number[]} */ some, /** @type {number} */ by) =>
    some.map((time) => /** @type {[number, number]} */ ([time + by, at(time)]));
  const early = run(
    sorted.filter((time) => time >= length - shift),
    shift - length,
  );
  const late = run(
    sorted.filter((time) => time <= length - shift),
    shift,
  );
  return shift ? [early, late] : [late];
}

/** A design with changes entered, in copies of what they touch. @param {any} design @param {Change[]} changes */
export function changed(design, changes) {
  const copy = { ...design };
  for (const { path, value } of changes) {
    const inAxis = path[0] === "axes" && path[2] !== "load";
    const list = path.slice(0, -2).join();
    if (inAxis) copy.axes = copy.axes.map((/** @type {Axis} */ one) => (one.index === path[1] ? entered(one, path.slice(2), value) : one));
    else copy.bars = copy.bars.map((/** @type {any} */ bar) => (bar.path.join() === list ? barWith(bar, path.slice(-2), value) : bar));
  }
  return copy;
}

/** A bar with an edge entered. @param {any} bar @param {(string|number)[]} place @param {number} value */
function barWith(bar, [k, edge], value) {
  const on = bar.on.map((/** @type {number[]} */ span, /** @type {number} */ n) => (n === k ? span.with(edge === "start" ? 0 : 1, value) : span));
  return { ...bar, on };
}

/** An axis with a value entered. @param {Axis} axis @param {(string|number)[]} path @param {number} value */
function entered(axis, [key, k, edge], value) {
  if (key === "shift") return { ...axis, shift: value };
  const name = { start: "from", stop: "to" }[edge] ?? edge;
  return { ...axis, phases: axis.phases.map((phase) => (phase.index === k ? { ...phase, [name]: value } : phase)) };
}

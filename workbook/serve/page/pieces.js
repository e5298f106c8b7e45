// Positions of an axis from the pieces that the server gave, so that a line follows the pointer without it.
import { isWhole, wrapped } from "./timing_rows.js";

/**
 * @typedef {import("./timing_rows.js").Row} Row
 * @typedef {{from: number, to: number, x: number[]}} Piece  s = sum x[k] u^k from 0 to 1, in the phase's own time 0..1
 * @typedef {{start: number, pieces: Piece[][], stale?: boolean, error?: string|null}} Figure
 */

const SAMPLES = 32; // of a phase: a chord is then within a tenth of a picture's point

/** The share of its lift that a phase has done. @param {Piece[]|undefined} pieces @param {number} time 0..1 */
export function shareOf(pieces, time) {
  if (time <= 0) return 0;
  if (time >= 1) return 1;
  const piece = pieces?.find((one) => time <= one.to);
  if (!piece) return time;
  const u = (time - piece.from) / (piece.to - piece.from);
  return piece.x.reduceRight((sum, coefficient) => sum * u + coefficient, 0);
}

/**
 * A function of an axis' own time (0 to the period's length) that returns its position.
 * @param {Row} axis @param {Figure|undefined} figure @param {number} length
 */
export function positions(axis, figure, length) {
  const moves = axis.spans.filter(isWhole).map(({ from, to, lift, index }) => {
    const pieces = figure?.pieces?.[index];
    const share = (/** @type {number} */ time) => shareOf(pieces, (time - from) / (to - from));
    const before = share(length); // below 1 where it goes on past the period's end
    const tail = before < 1 ? (/** @type {number} */ time) => share(time + length) - before : () => 0;
    return { lift, at: (/** @type {number} */ time) => share(time) + tail(time) };
  });
  const start = figure?.start ?? 0;
  return (/** @type {number} */ time) => moves.reduce((sum, { lift, at }) => sum + lift * at(time), start);
}

/**
 * The line of an axis over the period, as runs of [angle, position]: two runs where its shift parts it.
 * @param {Row} axis @param {Figure|undefined} figure @param {number} length @returns {[number, number][][]}
 */
export function lineOf(axis, figure, length) {
  const at = positions(axis, figure, length);
  const shift = wrapped(axis.shift, length);
  const times = new Set([0, length, length - shift]);
  for (const { from, to } of axis.spans.filter(isWhole)) {
    for (let k = 0; k <= SAMPLES; k += 1) {
      const time = from + ((to - from) * k) / SAMPLES;
      times.add(time > length ? time - length : time);
    }
  }
  const sorted = [...times].sort((a, b) => a - b);
  const run = (/** @type {number[]} */ some, /** @type {number} */ by) =>
    some.map((time) => /** @type {[number, number]} */ ([time + by, at(time)]));
  const early = sorted.filter((time) => time >= length - shift);
  const late = sorted.filter((time) => time <= length - shift);
  return shift ? [run(early, shift - length), run(late, shift)] : [run(late, shift)];
}

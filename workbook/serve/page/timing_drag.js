// What a drag or a key comes to: where an edge, a span, a lift or an axis may go, and the changes that say so.
import { short } from "./colors.js";
import { isWhole, wrapped } from "./timing_rows.js";

/**
 * @typedef {import("./timing_rows.js").Row} Row
 * @typedef {import("./timing_rows.js").Span} Span
 * @typedef {{path: (string|number)[], value: number}} Change
 * @typedef {{row: string, kind: "from"|"to"|"span"|"lift"|"shift", k: number}} Target
 * @typedef {{time: number, lift: number}} Way  how far, in the period's unit and in the axis' own
 * @typedef {{isFine: boolean, isPush?: boolean, reach: number}} Snap  reach: how near another edge holds, in the period's unit
 * @typedef {{changes: Change[], words: string, guide: number|null, stop?: Span|null, pushed?: Span[]}} Move  stop: what is in the way
 */

/** The nearest of 1, 2, 5 with a power of ten. @param {number} value */
export function niceStep(value) {
  const ten = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].reduce((best, n) => (Math.abs(n * ten - value) < Math.abs(best - value) ? n * ten : best), ten);
}

const plain = (/** @type {number} */ value) => Number(value.toPrecision(10));
const round = (/** @type {number} */ value, /** @type {number} */ step) => plain(Math.round(value / step) * step);

/** The other spans of a row before or behind a span, the nearest first, told in its turn. @param {Row} row @param {Span} span @param {number} length @param {number} way 1: behind it, -1: before */
function othersOf(row, span, length, way) {
  const turns = row.isRing ? [-length, 0, length] : [0];
  const all = row.spans.filter((one) => one !== span && isWhole(one)).flatMap((one) =>
    turns.map((turn) => ({ one, near: (way > 0 ? one.from : one.to) + turn, width: one.to - one.from })),
  );
  const edge = way > 0 ? span.to : span.from;
  const beyond = all.filter(({ near }) => way * (near - edge) >= -1e-9).sort((a, b) => way * (a.near - b.near));
  return beyond.filter(({ one }, n) => beyond.findIndex((other) => other.one === one) === n);
}

/** Between which places a span may be: as far as its neighbours, or as far as it can push them. @param {Row} row @param {Span} span @param {number} length */
export function roomOf(row, span, length, isPush = false) {
  const most = Math.max(length, ...row.spans.filter(isWhole).map((one) => one.to));
  const ends = row.isRing ? [span.to - length, span.from + length] : [0, most];
  return [-1, 1].map((way, n) => {
    const others = othersOf(row, span, length, way);
    if (isPush) return ends[n] - way * others.reduce((sum, { width }) => sum + width, 0);
    return others.length ? Math[way > 0 ? "min" : "max"](ends[n], others[0].near) : ends[n];
  });
}

/** By how much each other span of a row goes away before one that comes. @param {Row} row @param {Span} span @param {number[]} ends where it goes @param {number} length */
function pushedBy(row, span, ends, length) {
  return [-1, 1].flatMap((way, n) => {
    let edge = ends[n];
    return othersOf(row, span, length, way).flatMap(({ one, near, width }) => {
      const by = edge - near;
      edge = Math[way > 0 ? "max" : "min"](edge, near) + way * width;
      return way * by > 1e-9 ? [{ one, by }] : [];
    });
  });
}

/** The edges of all other spans, in the own time of a row. @param {Row[]} rows @param {Row} row @param {Span} span @param {number} length */
function edgesFor(rows, row, span, length) {
  const edges = rows.flatMap(({ spans, shift }) => spans.filter((one) => one !== span && isWhole(one)).flatMap(({ from, to }) => [from + shift, to + shift]));
  return edges.flatMap((edge) => [-length, 0, length].map((turn) => wrapped(edge, length) - row.shift + turn));
}

/** A place drawn to another edge within reach, else to a whole step. @param {number} value @param {number[]} edges @param {Snap} snap @param {number} step */
function snapped(value, edges, { isFine, reach }, step) {
  if (isFine) return { value: round(value, step / 10), edge: null };
  const [edge] = edges.filter((each) => Math.abs(each - value) <= reach).sort((a, b) => Math.abs(a - value) - Math.abs(b - value));
  return edge === undefined ? { value: round(value, step), edge: null } : { value: plain(edge), edge };
}

/**
 * The changes that a way from where a target was comes to, with words for the pointer and the edge that held it.
 * @param {Row[]} rows as they were when the drag began @param {Target} target @param {Way} way @param {Snap} snap
 * @param {{length: number, unit: string, ms?: number|null}} period @returns {Move}
 */
export function movedBy(rows, target, way, snap, period) {
  const row = /** @type {Row} */ (rows.find((one) => one.id === target.row));
  const { length, unit } = period;
  const step = niceStep(length / 360);
  const span = row.spans[target.k];
  if (target.kind === "shift") {
    const value = plain(wrapped(round(row.shift + way.time, snap.isFine ? step / 10 : step), length));
    return { changes: [{ path: ["axes", row.index, "shift"], value }], words: `later by ${value}${space(unit)}`, guide: null };
  }
  const path = [...row.path, span.index];
  if (target.kind === "lift") {
    const fine = niceStep(Math.max(Math.abs(span.lift), 1) / 100) / (snap.isFine ? 10 : 1);
    const value = round(span.lift + way.lift, fine);
    return { changes: [{ path: [...path, "lift"], value }], words: `lift ${value}${space(row.unit)}`, guide: null };
  }
  const [low, high] = roomOf(row, span, length, snap.isPush);
  const edges = edgesFor(rows, row, span, length);
  const put = (/** @type {number} */ value) => plain(row.isRing && (value < 0 || value > length) ? wrapped(value, length) : value);
  const isSpan = target.kind === "span";
  const first = snapped(span.from + way.time, edges, snap, step);
  const last = snapped(span.to + way.time, edges, snap, step);
  const near = target.kind === "to" || (isSpan && first.edge === null && last.edge !== null) ? last : first;
  const by = near === last ? last.value - span.to : first.value - span.from;
  const [least, most, width] = [low - span.from, high - span.to, span.to - span.from - step / 10];
  const moved = [
    target.kind === "to" ? 0 : Math.min(Math.max(by, least), isSpan ? most : width),
    target.kind === "from" ? 0 : Math.min(Math.max(by, isSpan ? least : -width), most),
  ];
  const ends = [span.from + moved[0], span.to + moved[1]];
  const pushes = snap.isPush ? pushedBy(row, span, ends, length) : [];
  const wanted = target.kind === "from" ? moved[0] : moved[1];
  const sign = Math.sign(by);
  const [stop] = !snap.isPush && wanted !== by ? othersOf(row, span, length, sign).filter(({ near: edge }) => Math.abs(edge - ends[sign > 0 ? 1 : 0]) < 1e-6) : [];
  /** @param {Span} one @param {number} n @param {number} value */
  const edgeChange = (one, n, value) => ({ path: [...row.path, one.index, n ? "stop" : "start"], value: put(value) });
  const changes = [0, 1].filter((n) => isSpan || (n === 1) === (target.kind === "to")).map((n) => edgeChange(span, n, ends[n]));
  changes.push(...pushes.flatMap(({ one, by: far }) => [edgeChange(one, 0, one.from + far), edgeChange(one, 1, one.to + far)]));
  const [values, n] = [ends.map(put), target.kind === "to" ? 1 : 0];
  const at = isSpan ? `${values[0]} to ${values[1]}${space(unit)}` : `${target.kind} ${values[n]}${space(unit)}${timeAt(period, row.shift + ends[n])}`;
  const told = (/** @type {string} */ words, /** @type {{one: Span}[]} */ of) =>
    of.length ? ` · ${words} ${row.isAxis ? "phase" : "bar"} ${of.map(({ one }) => one.index + 1).join(", ")}` : "";
  const guide = near.edge === null ? null : wrapped(near.edge + row.shift, length);
  const words = `${at}${told("Ctrl pushes", stop ? [stop] : [])}${told("pushes", pushes)}`;
  return { changes, words, guide, stop: stop?.one ?? null, pushed: pushes.map(({ one }) => one) };
}

/** An angle as the time at the rate, as words. @param {{length: number, ms?: number|null}} period @param {number} angle */
export const timeAt = ({ length, ms }, angle) =>
  ms ? ` · ${short((wrapped(angle, length) / length) * ms)} ms` : "";

/** A unit as it stands after a number. @param {string} unit */
export const space = (unit) => (unit === "°" || !unit ? unit : ` ${unit}`);

// What a drag or a key comes to: where an edge, a span, a lift or an axis may go, and the changes that say so.
import { wrapped } from "./pieces.js";

/**
 * @typedef {{from: number, to: number, lift?: number|null, index: number, law?: string}} Span
 * @typedef {{id: string, path: (string|number)[], name: string, unit: string, shift: number, isRing: boolean, isAxis: boolean,
 *            index: number, spans: Span[], item: any}} Row  an axis with its phases, or a switch or window with its bars
 * @typedef {{row: string, kind: "from"|"to"|"span"|"lift"|"shift", k: number}} Target
 * @typedef {{time: number, lift: number}} Way  how far, in the period's unit and in the axis' own
 * @typedef {{isFine: boolean, reach: number}} Snap  reach: how near another edge holds, in the period's unit
 * @typedef {import("./pieces.js").Change} Change
 */

/** The nearest of 1, 2, 5 with a power of ten. @param {number} value */
export function niceStep(value) {
  const ten = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].reduce((best, n) => (Math.abs(n * ten - value) < Math.abs(best - value) ? n * ten : best), ten);
}

const plain = (/** @type {number} */ value) => Number(value.toPrecision(10));
const round = (/** @type {number} */ value, /** @type {number} */ step) => plain(Math.round(value / step) * step);
const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
  Math.min(Math.max(value, low), high);

/** The rows of a design: axes with their phases, then switches and windows with their bars. @param {any} design @returns {Row[]} */
export function rowsOf(design) {
  const { length } = design.period;
  const axes = design.axes
    .filter((/** @type {any} */ axis) => axis.shown !== false)
    .map((/** @type {any} */ axis) => ({
      id: `axis-${axis.index}`,
      path: ["axes", axis.index, "phases"],
      name: axis.name,
      unit: axis.unit,
      shift: axis.shift ?? 0,
      isRing: false,
      isAxis: true,
      index: axis.index,
      spans: axis.phases,
      item: axis,
    }));
  const bars = ["switches", "windows"].flatMap((list) =>
    (design[list] ?? []).map((/** @type {any} */ bar) => ({
      id: `${list}-${bar.index}`,
      path: bar.path ?? [list, bar.index, "on"],
      name: bar.name,
      unit: "",
      shift: 0,
      item: bar,
      isRing: true,
      isAxis: false,
      index: bar.index,
      spans: bar.on.map(([from, to], /** @type {number} */ index) => ({
        from,
        to: to < from ? to + length : to,
        index,
      })),
    })),
  );
  return [...axes, ...bars];
}

/** Between which places a span may be, from the end before it to the begin after it. @param {Row} row @param {Span} span @param {number} length */
export function roomOf(row, span, length) {
  const others = row.spans.filter((one) => one !== span && one.from !== null && one.to !== null && one.to > one.from);
  const turns = row.isRing ? [-length, 0, length] : [0];
  const all = others.flatMap((one) => turns.map((turn) => ({ from: one.from + turn, to: one.to + turn })));
  const edges = row.isRing ? [span.to - length, span.from + length] : [0, Math.max(length, span.to)];
  const low = Math.max(edges[0], ...all.filter((one) => one.to <= span.from + 1e-9).map((one) => one.to));
  const high = Math.min(edges[1], ...all.filter((one) => one.from >= span.to - 1e-9).map((one) => one.from));
  return [low, high];
}

/** The edges of all other spans, in the own time of a row. @param {Row[]} rows @param {Row} row @param {Span} span @param {number} length */
function edgesFor(rows, row, span, length) {
  const places = rows.flatMap((other) =>
    other.spans
      .filter((one) => one !== span)
      .flatMap((one) => [one.from, one.to].filter((edge) => edge !== null).map((edge) => edge + other.shift)),
  );
  return places.flatMap((place) => [-length, 0, length].map((turn) => wrapped(place, length) - row.shift + turn));
}

/** A place drawn to another edge within reach, else to a whole step. @param {number} value @param {number[]} edges @param {Snap} snap @param {number} step */
function snapped(value, edges, { isFine, reach }, step) {
  if (isFine) return { value: round(value, step / 10), edge: null };
  const edge = edges.reduce(
    (/** @type {number|null} */ best, one) =>
      Math.abs(one - value) <= reach && (best === null || Math.abs(one - value) < Math.abs(best - value)) ? one : best,
    null,
  );
  return edge === null ? { value: round(value, step), edge } : { value: plain(edge), edge };
}

/**
 * The changes that a way from where a target was comes to, with words for the pointer and the edge that held it.
 * @param {Row[]} rows as they were when the drag began @param {Target} target @param {Way} way @param {Snap} snap
 * @param {{length: number, unit: string}} period @returns {{changes: Change[], words: string, guide: number|null}}
 */
export function movedBy(rows, target, way, snap, period) {
  const row = /** @type {Row} */ (rows.find((one) => one.id === target.row));
  const { length, unit } = period;
  const step = niceStep(length / 360);
  const span = row.spans[target.k];
  if (target.kind === "shift") {
    const value = snap.isFine ? round(row.shift + way.time, step / 10) : round(row.shift + way.time, step);
    const shift = plain(wrapped(value, length));
    return {
      changes: [{ path: ["axes", row.index, "shift"], value: shift }],
      words: `later by ${shift}${space(unit)}`,
      guide: null,
    };
  }
  const path = [...row.path, span.index];
  if (target.kind === "lift") {
    const fine = niceStep(Math.max(Math.abs(span.lift ?? 0), 1) / 100) / (snap.isFine ? 10 : 1);
    const value = round((span.lift ?? 0) + way.lift, fine);
    return { changes: [{ path: [...path, "lift"], value }], words: `lift ${value}${space(row.unit)}`, guide: null };
  }
  const [low, high] = roomOf(row, span, length);
  const edges = edgesFor(rows, row, span, length);
  const put = (/** @type {number} */ value) =>
    plain(row.isRing && (value < 0 || value > length) ? wrapped(value, length) : value);
  if (target.kind === "span") {
    const first = snapped(span.from + way.time, edges, snap, step);
    const last = snapped(span.to + way.time, edges, snap, step);
    const isLast = first.edge === null && last.edge !== null;
    const by = clamp(isLast ? last.value - span.to : first.value - span.from, low - span.from, high - span.to);
    const [from, to] = [put(span.from + by), put(span.to + by)];
    const edge = isLast ? last.edge : first.edge;
    return {
      changes: [
        { path: [...path, "start"], value: from },
        { path: [...path, "stop"], value: to },
      ],
      words: `${from} to ${to}${space(unit)}`,
      guide: edge === null ? null : wrapped(edge + row.shift, length),
    };
  }
  const near = snapped(span[target.kind] + way.time, edges, snap, step);
  const ends = target.kind === "from" ? [low, span.to - step / 10] : [span.from + step / 10, high];
  const value = put(clamp(near.value, ends[0], ends[1]));
  return {
    changes: [{ path: [...path, target.kind === "from" ? "start" : "stop"], value }],
    words: `${target.kind} ${value}${space(unit)}`,
    guide: near.edge === null ? null : wrapped(near.edge + row.shift, length),
  };
}

/** A unit as it stands after a number. @param {string} unit */
export const space = (unit) => (unit === "°" || !unit ? unit : ` ${unit}`);

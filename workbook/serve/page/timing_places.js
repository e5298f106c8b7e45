// Where everything in the timing diagram stands, and what is at a place in it.
import { lineOf } from "./pieces.js";
import { periodOf } from "./state.js";
import { isWhole, rowsOf, wrapped } from "./timing_rows.js";

/**
 * @typedef {import("./timing_rows.js").Row} Row
 * @typedef {import("./timing_drag.js").Target} Target
 * @typedef {{row: Row, y: number, height: number, runs: [number, number][][], low: number, high: number,
 *            toY: (position: number) => number, figure: any, before: [number, number][][], handles: Handle[]}} Place
 * @typedef {{kind: "from"|"to"|"span"|"lift", k: number, x: number, y: number, at: number}} Handle  drawn at x, true at `at`
 * @typedef {{left: number, right: number, width: number, length: number, x: (angle: number) => number, places: Place[], height: number}} Layout
 */

export const LEFT = 100;
export const RIGHT = 18;
export const HANDLE = 16; // px: how wide a handle is, with the room between it and the next
const LANES = { least: 38, most: 84, share: 0.25 }; // px, and of the window's height for all lanes
const BAR = 26;
const GAP = 46;
const FAR = 5; // times the least gap that is asked for: gaps beyond are far, and cut off
const NEAR = 5; // px at which the line of an edge is taken where no handle is

/** @type {WeakMap<object, {figure: any, length: number, runs: [number, number][][], low: number, high: number}>} */
const lines = new WeakMap();
const NONE = { runs: [], low: 0, high: 0 };

/** The line of an axis with its range, worked out once for as long as nothing of it changes. @param {Row} row @param {any} figure @param {number} length */
function lineFor(row, figure, length) {
  let line = lines.get(row.item);
  if (line?.figure !== figure || line?.length !== length) {
    const runs = lineOf(row, figure, length);
    const positions = runs.flat().map(([, position]) => position);
    line = { figure, length, runs, low: Math.min(...positions), high: Math.max(...positions) };
    lines.set(row.item, line);
  }
  return line;
}

/** The latest lines of axes whose phases all have their begin and end, by their names. @type {Map<string, any>} */
const latest = new Map();

/** The line of an axis as it is edited: of an unfinished one the latest. @param {Row} row @param {any} figure @param {number} length */
function editedLine(row, figure, length) {
  if (row.spans.every(isWhole)) latest.set(row.name, lineFor(row, figure, length));
  return latest.get(row.name) ?? lineFor(row, figure, length);
}

/** The line of a gap, and how much of it is near enough to be drawn. @param {any} gap */
function lineOfGap(gap) {
  const most = Math.max(...gap.y);
  const high = Math.max(Math.min(most, Math.max(FAR * gap.need, gap.least + (most - gap.least) / 3)), gap.least + 1e-9);
  return { runs: [gap.x.map((/** @type {number} */ x, /** @type {number} */ n) => [x, gap.y[n]])], low: Math.min(0, gap.least), high };
}

/**
 * @param {Row[]} rows @param {any} figures @param {{length: number}} period @param {number} width
 * @param {{axis: number, phase: number|null}|null} selected
 * @param {{row: string, low: number, high: number}|null} scale of the lane that is being dragged
 * @param {any} saved the figures of the saved design, and its data @returns {Layout}
 */
export function layOut(rows, figures, { length }, width, selected, scale, saved = null) {
  const [left, right] = [LEFT, Math.max(width - RIGHT, LEFT + 100)];
  const x = (/** @type {number} */ angle) => left + (angle / length) * (right - left);
  const count = rows.filter((row) => row.isAxis).length;
  const lane = Math.round(Math.min(Math.max((innerHeight * LANES.share) / (count || 1), LANES.least), LANES.most));
  const isLike = Boolean(saved?.data) && periodOf(saved.data).length === length;
  const past = isLike ? rowsOf(saved.data).filter((row) => row.isAxis) : [];
  let y = 4;
  const places = rows.map((row) => {
    const height = row.isAxis ? lane : row.isGap ? GAP : BAR;
    const figure = row.isAxis ? figures?.axes?.[row.index] : null;
    const before = row.isAxis && isLike ? savedLine(past, saved.axes, row, length) : NONE;
    const place = placeOf(row, figure, length, y, height, before, scale?.row === row.id ? scale : null);
    /** @type {Handle[]|undefined} */
    let handles; // of few rows that are drawn or pointed at
    Object.defineProperty(place, "handles", { get: () => (handles ??= handlesOf(place, { x, length }, selected)) });
    y += height + (row.isAxis || row.isGap ? 4 : 0);
    return place;
  });
  return { left, right, width, length, x, places, height: y + 4 };
}

/** The line of an axis as it was saved: of its name, or its place. @param {Row[]} past @param {any} figures @param {Row} row @param {number} length */
function savedLine(past, figures, row, length) {
  const axis = past.find((one) => one.name === row.name) ?? past[row.index];
  const figure = figures[axis?.index];
  return figure?.pieces && axis.unit === row.unit ? lineFor(axis, figure, length) : NONE;
}

/** @param {Row} row @param {any} figure @param {number} length @param {number} y @param {number} height @param {any} before @param {any} scale @returns {Place} */
function placeOf(row, figure, length, y, height, before, scale) {
  const line = row.isAxis ? editedLine(row, figure, length) : row.isGap ? lineOfGap(row.item) : NONE;
  const also = before.runs.length ? before : line;
  const low = Math.min(line.low, also.low, scale?.low ?? Infinity);
  const high = Math.max(line.high, also.high, scale?.high ?? -Infinity);
  const [top, room] = [y + 16, height - 20];
  const share = (/** @type {number} */ position) => (high > low ? Math.max(0, (high - position) / (high - low)) : 1);
  const toY = (/** @type {number} */ position) => (row.isAxis || row.isGap ? top + room * share(position) : y + height / 2);
  return { row, y, height, runs: line.runs, low, high, toY, figure, before: before.runs, handles: [] };
}

/** The angle of the machine at which an edge stands; a span's end on the period's end, not its begin. @param {Row} row @param {number} edge @param {number} length */
export const angleOf = (row, edge, length, isEnd = false) => wrapped(edge + row.shift, length) || (isEnd ? length : 0);

/** What of the period a span covers: two stretches where it goes on past the end. @param {Row} row @param {any} span @param {number} length */
export function stretchesOf(row, span, length) {
  const [from, to] = [angleOf(row, span.from, length), angleOf(row, span.to, length, true)];
  if (span.to - span.from >= length) return [[0, length]];
  return (from < to ? [[from, to]] : [[from, length], [0, to]]).filter(([a, b]) => b > a);
}

/** The position that a lane's line has at an angle. @param {Place} place @param {number} angle */
export function positionOf({ runs }, angle) {
  const run = runs.find((one) => angle >= one[0][0] && angle <= one[one.length - 1][0]);
  const next = run?.findIndex(([at]) => at >= angle) ?? -1;
  if (!run || next < 0) return 0;
  const [to, after] = run[next];
  const [from, before] = run[Math.max(next - 1, 0)];
  return to > from ? before + ((after - before) * (angle - from)) / (to - from) : after;
}

/** The handles of a row, drawn so far apart that none covers another. @param {Place} place @param {any} layout @param {any} selected @returns {Handle[]} */
function handlesOf(place, { x, length }, selected) {
  const { row } = place;
  const all = row.spans.flatMap((span, k) => {
    if (!isWhole(span)) return [];
    const made = (/** @type {Handle["kind"]} */ kind, /** @type {number} */ angle) => {
      const at = x(angle);
      return { kind, k, x: at, y: place.toY(row.isAxis ? positionOf(place, angle) : 0), at };
    };
    const isChosen = row.isAxis && selected?.axis === row.index && selected.phase === span.index;
    const inner = row.isAxis ? (isChosen ? ["lift"] : []) : ["span"];
    const middle = angleOf(row, (span.from + span.to) / 2, length);
    return [
      made("from", angleOf(row, span.from, length)),
      ...inner.map((kind) => made(/** @type {"lift"|"span"} */ (kind), middle)),
      made("to", angleOf(row, span.to, length, true)),
    ];
  });
  return spread(all.sort((a, b) => a.at - b.at || Number(a.kind === "from") - Number(b.kind === "from")));
}

/** Handles moved as little as keeps them apart: the means of those that press on each other. @param {Handle[]} handles */
function spread(handles) {
  /** @type {{sum: number, count: number}[]} */
  const groups = [];
  handles.forEach((handle, n) => {
    let group = { sum: handle.at - n * HANDLE, count: 1 };
    for (let last = groups.at(-1); last && last.sum / last.count > group.sum / group.count; last = groups.at(-1)) {
      groups.pop();
      group = { sum: last.sum + group.sum, count: last.count + group.count };
    }
    groups.push(group);
  });
  const means = groups.flatMap(({ sum, count }) => Array(count).fill(sum / count));
  return handles.map((handle, n) => ({ ...handle, x: means[n] + n * HANDLE }));
}

/** The place of a row at a height. @param {Layout} layout @param {number} y */
export const placeAt = (layout, y) => layout.places.find((place) => y >= place.y && y < place.y + place.height + 4);

/** What is at a point of a row: the nearest handle, else the span. @param {Layout} layout @param {Place} place @param {number} x @param {number} y @returns {Target|null} */
export function targetAt(layout, { row, handles }, x, y) {
  if (x < layout.left - HANDLE) return row.isAxis ? { row: row.id, kind: "shift", k: -1 } : null;
  const far = (/** @type {Handle} */ one) => Math.hypot(one.x - x, one.y - y);
  const [nearest] = [...handles].sort((a, b) => far(a) - far(b));
  if (nearest && far(nearest) <= HANDLE * 0.7) return { row: row.id, kind: nearest.kind, k: nearest.k };
  const edge = handles.find((one) => one.kind !== "lift" && one.kind !== "span" && Math.abs(one.at - x) <= NEAR);
  if (edge) return { row: row.id, kind: edge.kind, k: edge.k };
  const angle = ((x - layout.left) / (layout.right - layout.left)) * layout.length;
  const k = row.spans.findIndex((span) => isWhole(span) && stretchesOf(row, span, layout.length).some(([a, b]) => angle >= a && angle <= b));
  return k < 0 ? null : { row: row.id, kind: "span", k };
}

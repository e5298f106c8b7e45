// The rows of the timing diagram: axes with their phases, each with the bars of its forces; clearances, switches.
import { periodOf } from "./state.js";

/**
 * @typedef {{from: number, to: number, lift: number, law: string, index: number}} Span  from and to are null where they are missing
 * @typedef {{id: string, path: (string|number)[], name: string, unit: string, shift: number, isRing: boolean, isAxis: boolean, isGap: boolean,
 *            index: number, spans: Span[], item: any}} Row  item: what it is of in the description, or a gap
 */

const PLAIN = { isRing: false, isAxis: false, isGap: false, index: -1, shift: 0, unit: "", spans: [] };
const number = (value) => (typeof value === "number" ? value : null);

/** The rest of a number after division, never negative. @param {number} value @param {number} length */
export const wrapped = (value, length) => ((value % length) + length) % length;

/** Whether a span has its begin and its end. @param {Span} span */
export const isWhole = ({ from, to }) => from !== null && to !== null && to > from;

/** Phases of an axis, or the times of a switch or a force. @returns {Span[]} */
const spansOf = (list) => (list ?? []).map((each, index) => {
  const [from, to] = (Array.isArray(each) ? each : [each?.start, each?.stop]).map(number);
  return { from, to, lift: number(each?.lift) ?? 0, law: each?.law ?? "DWL", index };
});

function barsOf(path, name, item, on, length, index = -1) {
  const spans = spansOf(on).map((span) => (span.to < span.from ? { ...span, to: span.to + length } : span));
  return { ...PLAIN, id: path.slice(0, -1).join("-"), path, name, item, isRing: true, index, spans };
}

/** The rows of a description and of the gaps of its clearances. @param {any} tree @param {Record<string, any>} gaps @returns {Row[]} */
export function rowsOf(tree, gaps = {}) {
  const { length } = periodOf(tree);
  const axes = (tree?.axes ?? []).flatMap((item, index) => {
    const [name, windows] = [item.name ?? `axis ${index + 1}`, item.load?.windows];
    const own = { id: `axis-${index}`, path: ["axes", index, "phases"], name, unit: item.unit ?? "mm", shift: number(item.shift) ?? 0 };
    const axis = { ...PLAIN, ...own, isAxis: true, index, spans: spansOf(item.phases), item };
    return windows?.length ? [axis, barsOf(["axes", index, "load", "windows"], `${name} force`, windows, windows, length, index)] : [axis];
  });
  const near = Object.entries(gaps).map(([k, item]) => (
    { ...PLAIN, id: `gap-${k}`, path: ["clearances", Number(k)], name: item.name, unit: item.unit, item, isGap: true }));
  const switches = (tree?.switches ?? []).map((item, k) => barsOf(["switches", k, "on"], item.name ?? `switch ${k + 1}`, item, item.on, length));
  return [...axes, ...near, ...switches];
}

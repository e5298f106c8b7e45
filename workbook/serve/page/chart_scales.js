// What a chart shows of its figures: its ranges, the limits within them, and values at an angle.

import { short } from "./colors.js";

/**
 * @typedef {{value: number, label: string, kind: "peak"|"continuous"|"speed"|"reducer", x?: number[], y?: number[]}} Limit
 * @typedef {{key: string, title: string, unit: string, x: number[], y: number[], x_title: string, limits?: Limit[],
 *            points?: {x: number, y: number, label: string}[], at?: number[]}} Chart  at: the angle of each point of torque against speed
 */

const FAR = 2.5; // times what the data reach: a limit beyond is told, and drawn nowhere
const INCREMENTS = [1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720];

/** Whether a chart is over the cycle, not over speed. @param {Chart} chart */
export const isOverCycle = (chart) => chart.key !== "Tn";

const reachOf = (/** @type {number[]} */ values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
const isAcross = (/** @type {Limit} */ limit, /** @type {Chart} */ chart) =>
  limit.kind === "speed" && !isOverCycle(chart);

/**
 * The limits of a chart on the sides where its data are, each with its name where that is not named yet on the other side.
 * @param {Chart} chart @returns {{limit: Limit, isAcross: boolean, isFar: boolean, name: string}[]}
 */
export function limitsOf(chart) {
  const limits = (chart.limits ?? []).map((limit) => {
    const values = isAcross(limit, chart) ? chart.x : chart.y;
    const reach = reachOf(values);
    const isBeside = Boolean(limit.x) || limit.value >= 0 || values.some((value) => value < -0.02 * reach);
    const isNamed =
      limit.value >= 0 || !(chart.limits ?? []).some((other) => other.label === limit.label && other.value > 0);
    const name = /\d/.test(limit.label) ? limit.label : `${limit.label} ${short(limit.value)}`;
    const isFar = Math.abs(limit.value) > FAR * (reach || Infinity);
    return { limit, isBeside, isAcross: isAcross(limit, chart), isFar, name: isNamed ? name : "" };
  });
  return limits.filter((one) => one.isBeside && (!one.isFar || one.name));
}

/** The range of values, with those of limits that are near, and a little room. @param {number[]} values @param {number[]} more @returns {[number, number]} */
function padded(values, more) {
  const all = [...values, ...more].filter(Number.isFinite);
  const low = Math.min(0, ...all);
  const high = Math.max(0, ...all);
  const room = (high - low || 1) * 0.06;
  return [low < 0 ? low - room : 0, high > 0 || low === 0 ? high + room : 0];
}

/** The ranges of a chart with its saved one. @param {Chart} chart @param {Chart|undefined} saved @returns {{x: [number, number], y: [number, number]}} */
export function rangesOf(chart, saved) {
  const near = limitsOf(chart).filter(({ isFar }) => !isFar);
  const points = chart.points ?? [];
  const along = near.filter((one) => !one.isAcross).flatMap(({ limit }) => limit.y ?? [limit.value]);
  const y = padded([...chart.y, ...(saved?.y ?? []), ...points.map((point) => point.y)], along);
  if (isOverCycle(chart)) return { x: [chart.x[0], chart.x[chart.x.length - 1]], y };
  const across = near.filter((one) => one.isAcross).map(({ limit }) => limit.value);
  return { x: padded([...chart.x, ...(saved?.x ?? []), ...points.map((point) => point.x)], across), y };
}

/** The steps between the numbers of a scale over the cycle: parts of a turn where it is one. @param {number} length */
export const incrementsOf = (length) => (length >= 100 ? INCREMENTS : undefined);

/** The place among rising values at which a value stands, with the part of the way to the next. @param {number[]} values @param {number} value */
function placeOf(values, value) {
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle;
    else high = middle;
  }
  const width = values[high] - values[low];
  return { low, high, part: width ? Math.min(Math.max((value - values[low]) / width, 0), 1) : 0 };
}

/** The point of a chart at an angle of the cycle; null where the chart does not say at which angle its points are. @param {Chart|undefined} chart @param {number} angle */
export function pointAt(chart, angle) {
  const angles = chart && (isOverCycle(chart) ? chart.x : chart.at);
  if (!chart || !angles?.length) return null;
  const { low, high, part } = placeOf(angles, angle);
  const between = (/** @type {number[]} */ values) => values[low] + (values[high] - values[low]) * part;
  return { x: between(chart.x), y: between(chart.y) };
}

/** The angle of the point of torque against speed that is nearest, each direction measured by its range. @param {Chart} chart @param {number} x @param {number} y @param {{x: number[], y: number[]}} ranges */
export function angleNear(chart, x, y, ranges) {
  const [wide, high] = [ranges.x[1] - ranges.x[0], ranges.y[1] - ranges.y[0]];
  let [best, least] = [-1, Infinity];
  chart.x.forEach((one, n) => {
    const far = Math.hypot((one - x) / wide, (chart.y[n] - y) / high);
    if (far < least) [best, least] = [n, far];
  });
  return chart.at?.[best] ?? null;
}

/** The value of largest size, as the chart's title tells it. @param {Chart} chart */
export const peakOf = (chart) => chart.y.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);

// What a chart shows of its figures: its ranges, the limits within them, and values at an angle.

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
 * The lines of a chart's limits: across (over the speed) or along, on both sides where the data are.
 * @param {Chart} chart @returns {{limit: Limit, value: number, isAcross: boolean, isFar: boolean, isFirst: boolean}[]}
 */
export function limitsOf(chart) {
  return (chart.limits ?? []).flatMap((limit) => {
    const values = isAcross(limit, chart) ? chart.x : chart.y;
    const reach = reachOf(values);
    const isTwo = !limit.x && values.some((value) => value * Math.sign(limit.value) < -0.02 * reach);
    const isFar = Math.abs(limit.value) > FAR * (reach || Infinity);
    const sides = isTwo && !isFar ? [limit.value, -limit.value] : [limit.value];
    return sides.map((value, n) => ({ limit, value, isAcross: isAcross(limit, chart), isFar, isFirst: n === 0 }));
  });
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
  const along = near.filter((one) => !one.isAcross).flatMap(({ limit, value }) => [value, ...(limit.y ?? [])]);
  const y = padded([...chart.y, ...(saved?.y ?? []), ...points.map((point) => point.y)], along);
  if (isOverCycle(chart)) return { x: [chart.x[0], chart.x[chart.x.length - 1]], y };
  const across = near.filter((one) => one.isAcross).map(({ value }) => value);
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

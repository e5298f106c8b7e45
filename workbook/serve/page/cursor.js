// One cursor over all charts of an axis: a line or a point in each, and the values beside the titles.
import { effect, html } from "./html.js";
import { short } from "./colors.js";
import { angleNear, isOverCycle, peakOf, pointAt, rangesOf } from "./chart_scales.js";

/** Set the cursor to the angle that a chart is pointed at. @param {any} plot @param {any} shown its chart and saved chart @param {{value: number|null}} cursor */
export function pointFrom(plot, shown, cursor) {
  const { left, top } = plot.cursor;
  if (left < 0 || !plot.over.matches(":hover")) return;
  const [x, y] = [plot.posToVal(left, "x"), plot.posToVal(top, "y")];
  cursor.value = isOverCycle(shown.chart) ? x : angleNear(shown.chart, x, y, rangesOf(shown.chart, shown.saved));
}

/** Draw the cursor over a chart whenever it moves; returns what ends that. @param {any} plot @param {() => any} shown @param {{value: number|null}} cursor */
export function followCursor(plot, shown, cursor) {
  const mark = document.createElement("div");
  plot.over.append(mark);
  return effect(() => {
    const { chart } = shown();
    const point = cursor.value === null ? null : pointAt(chart, cursor.value);
    mark.hidden = point === null;
    mark.className = isOverCycle(chart) ? "mark" : "mark point";
    if (!point) return;
    const x = plot.valToPos(isOverCycle(chart) ? cursor.value : point.x, "x");
    mark.hidden = x < 0 || x > plot.over.clientWidth;
    mark.style.transform = isOverCycle(chart)
      ? `translateX(${x}px)`
      : `translate(${x - 4.5}px, ${plot.valToPos(point.y, "y") - 4.5}px)`;
  });
}

/** The values of a chart at the cursor, or its peak. @param {{chart: any, saved: any, cursor: {value: number|null}}} given */
export function Readout({ chart, saved, cursor }) {
  const at = cursor.value;
  const [now, before] = at === null ? [null, null] : [pointAt(chart, at), pointAt(saved, at)];
  if (!now) return html`<output>${isOverCycle(chart) && `peak ${short(peakOf(chart))}`}</output>`;
  const speed = isOverCycle(chart) ? "" : ` at ${short(now.x)}`;
  const is = short(now.y);
  return html`<output>${is}${speed}${before && short(before.y) !== is ? `, saved ${short(before.y)}` : ""}</output>`;
}

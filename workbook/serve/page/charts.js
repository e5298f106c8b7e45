// The charts of an axis: motion, drive or both, with limits and the saved design dashed.
import { html, useEffect, useRef, useSignal } from "./html.js";
import uPlot from "./vendor/uplot.js";
import { drawAll, FONT } from "./chart_drawing.js";
import { incrementsOf, isOverCycle, rangesOf } from "./chart_scales.js";
import { classOf, colorAt, followScheme, short } from "./colors.js";
import { followCursor, pointFrom, Readout } from "./cursor.js";

const MOTION = ["y", "v", "a", "j"];
const CHOICES = ["motion", "drive", "both"];

/** @param {HTMLElement} box @param {() => any} shown @param {any} cursor @param {any} view what of the cycle is shown, for all charts */
function plotIn(box, shown, cursor, view) {
  const { chart } = shown();
  const isOver = isOverCycle(chart);
  const values = (_, /** @type {number[]} */ numbers) => numbers.map(short);
  const grid = { stroke: () => colorAt(box, "--grid"), width: 1 };
  const axis = { font: FONT, stroke: () => colorAt(box, "--soft"), ticks: { show: false }, grid, gap: 4, values };
  const incrs = isOver ? incrementsOf(chart.x[chart.x.length - 1] - chart.x[0]) : undefined;
  return new /** @type {any} */ (uPlot)(
    {
      width: box.clientWidth,
      height: box.clientHeight,
      legend: { show: false },
      pxAlign: 0,
      padding: [8, 18, 0, 0],
      scales: {
        x: { time: false, range: (_, low, high) => (isOver ? [low, high] : rangesOf(shown().chart, shown().saved).x) },
        y: { range: () => rangesOf(shown().chart, shown().saved).y },
      },
      series: [{}, { scale: "y", paths: () => null, points: { show: false } }],
      axes: [{ ...axis, size: 22, ...(incrs ? { incrs } : {}) }, { ...axis, size: 50, space: 20 }],
      cursor: { x: false, y: false, points: { show: false }, drag: { x: isOver, y: false, dist: 5 } },
      hooks: {
        draw: [(plot) => drawAll(plot, shown())],
        setCursor: [(plot) => pointFrom(plot, shown(), cursor)],
        setScale: [(plot, key) => {
          const { min, max } = plot.scales.x;
          if (key === "x" && isOver && (view.peek()?.[0] !== min || view.peek()[1] !== max)) view.value = [min, max];
        }],
      },
    },
    dataOf(chart),
    box,
  );
}

/** What uPlot needs to know of the data: where the scale along begins and ends. @returns {any} */
const dataOf = (chart) => [[chart.x[0], chart.x[chart.x.length - 1]].sort((a, b) => a - b), [0, 0]];

function Chart({ chart, saved, cursor, view }) {
  const box = useRef(null);
  const plot = useRef(/** @type {any} */ (null));
  const shown = useRef(/** @type {any} */ ({ chart, saved }));
  shown.current = { chart, saved };
  useEffect(() => {
    const made = plotIn(/** @type {any} */ (box.current), () => shown.current, cursor, view);
    plot.current = made;
    const ends = [followCursor(made, () => shown.current, cursor), followScheme(() => made.redraw())];
    const observer = new ResizeObserver(([{ contentRect }]) => made.setSize(contentRect));
    observer.observe(/** @type {any} */ (box.current));
    made.over.addEventListener("pointerleave", () => (cursor.value = null));
    return () => {
      observer.disconnect();
      ends.forEach((end) => end());
      made.destroy();
    };
  }, []);
  useEffect(() => {
    const { x, y } = rangesOf(chart, saved);
    plot.current.batch(() => {
      plot.current.setData(dataOf(chart), false);
      plot.current.setScale("y", { min: y[0], max: y[1] });
      if (!isOverCycle(chart)) plot.current.setScale("x", { min: x[0], max: x[1] });
      plot.current.redraw(false, true);
    });
  }, [chart, saved]);
  const range = view.value;
  useEffect(() => {
    if (range && isOverCycle(chart)) plot.current.setScale("x", { min: range[0], max: range[1] });
  }, [range]);
  const unit = isOverCycle(chart) ? chart.unit : `${chart.unit.split(" over ")[0]}, ${chart.x_title}`;
  return html`<figure class="chart">
    <h3><span title=${chart.title}>${chart.title} [${unit}]</span><${Readout} chart=${chart} saved=${saved} cursor=${cursor} /></h3>
    <div class="plot" ref=${box}></div>
  </figure>`;
}

/** @param {{index: number, axis: any, figures: any, saved: any, cursor: any, chosen: {value: string}}} props */
export function AxisCharts({ index, axis, figures, saved, cursor, chosen }) {
  const view = useSignal(/** @type {[number, number]|null} */ (null));
  const name = axis.name ?? `axis ${index + 1}`;
  const figure = figures.value.axes[index];
  const before = saved.value.axes[index];
  const isShown = ({ key }) => chosen.value === "both" || MOTION.includes(key) === (chosen.value === "motion");
  const all = (figure?.charts ?? []).filter(isShown);
  const missing = figure?.error ?? (all.length ? "" : figure?.charts ? `no charts of ${chosen.value} yet` : "being worked out …");
  return html`<section class=${`panel charts ${classOf(index)}${figure?.stale ? " stale" : ""}`} aria-label=${`Charts of ${name}`}>
    <h2><span class="dot"></span>${name} <small>${axis.group}${before ? ", compared with the design as saved (dashed)" : ""}</small>
      <span class="choice" role="group" aria-label="Charts">${CHOICES.map((choice) => html`<button aria-pressed=${chosen.value === choice}
        onClick=${() => (chosen.value = choice)}>${choice}</button>`)}</span></h2>
    ${missing && html`<p class="missing">${missing}</p>`}
    <div class="all" tabindex="0" role="group" aria-label=${`Charts of ${name}, ${chosen.value}`}>
      ${all.map((chart) => html`<${Chart} key=${`${index} ${chart.key}`} ...${{ chart, cursor, view }}
        saved=${before?.charts?.find((one) => one.key === chart.key)} />`)}
    </div>
  </section>`;
}

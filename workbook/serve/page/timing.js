// The timing diagram: a lane for each axis, switches as bars, all of it to be dragged.
import { html, useEffect, useRef, useSignal } from "./html.js";
import { classOf, short } from "./colors.js";
import { periodOf, put } from "./state.js";
import { niceStep, space, timeAt } from "./timing_drag.js";
import { Gap } from "./timing_gap.js";
import { useHands } from "./timing_hands.js";
import { Lane } from "./timing_lane.js";
import { layOut, positionOf, stretchesOf } from "./timing_places.js";
import { rowsOf } from "./timing_rows.js";

const TICK = 38; // px that a number on the scale takes

/** The angles with a line and a number: each 30° of a turn, else a round part of the period. @param {number} length */
function ticksOf(length) {
  const step = length % 360 === 0 ? length / 12 : niceStep(length / 10);
  const count = Math.floor(length / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, k) => Number((k * step).toPrecision(6)));
}

/** The line under the pointer with the position of every axis there, on the side where there is room. */
function Cursor({ cursor, layout }) {
  if (cursor.value === null) return null;
  const x = layout.x(cursor.value);
  const isLeft = x > layout.right - 90;
  const value = (place) => html`<text class=${classOf(place.row.index)} x=${x + (isLeft ? -6 : 6)} y=${place.y + place.height / 2 + 4}
    text-anchor=${isLeft ? "end" : "start"}>${short(positionOf(place, cursor.value))}${space(place.row.unit)}</text>`;
  return html`<g class="cursor"><path d=${`M${x} 0V${layout.height}`} />${layout.places.filter(({ row }) => row.isAxis).map(value)}</g>`;
}

/** The numbers of a scale: as many as there is room for. @param {number[]} ticks @param {(tick: number) => number} x */
function numbersAt(ticks, x) {
  const every = [1, 2, 3, 4, 6].find((n) => n * (x(ticks[1]) - x(ticks[0])) >= TICK) ?? 12;
  return ticks.filter((_, n) => n % every === 0);
}

/** The scale above the lanes, degrees and ms at the rate, with the numbers of the line under the pointer. */
function Scale({ cursor, layout, period }) {
  const now = cursor.value;
  const { ms, length } = period;
  const xOfTime = (/** @type {number} */ time) => layout.x((time / ms) * length);
  const row = (/** @type {number[]} */ ticks, /** @type {(tick: number) => number} */ x, /** @type {number} */ y) =>
    numbersAt(ticks, x).map((tick) => {
      const isUnder = now !== null && Math.abs(x(tick) - layout.x(now)) < TICK * 1.2;
      return html`<text x=${x(tick)} y=${y} class=${isUnder ? "faint" : ""}>${tick}</text>`;
    });
  return html`<svg class="scale" width=${layout.width} height=${ms ? 34 : 20} aria-hidden="true">
    <text class="unit" x="8" y="14">${period.unit}</text> ${row(ticksOf(length), layout.x, 14)}
    ${ms && html`<text class="unit" x="8" y="29">ms</text>${row(ticksOf(ms), xOfTime, 29)}`}
    ${now !== null && html`<text class="now" x=${layout.x(now)} y="14">${short(now)}${space(period.unit)}</text>`}
    ${now !== null && ms && html`<text class="now" x=${layout.x(now)} y="29">${timeAt(period, now).slice(3)}</text>`}
  </svg>`;
}

/** Over the lanes: the neighbour at which a drag stops, and those that it pushes. */
function Marks({ drag, rows, layout }) {
  const row = rows.find((one) => one.id === drag.target.row);
  const place = layout.places.find((one) => one.row.id === drag.target.row);
  const marked = [...(drag.pushed ?? []), ...(drag.stop ? [drag.stop] : [])];
  return marked.flatMap(({ index }) => {
    const span = row.spans.find((one) => one.index === index);
    return stretchesOf(row, span, layout.length).map(([a, b]) => html`<rect class=${drag.stop ? "mark stop" : "mark"}
      x=${layout.x(a)} y=${place.y + 1} width=${layout.x(b) - layout.x(a)} height=${place.height - 2} rx="3" />`);
  });
}

/** What is dragged, as a number at the pointer. */
function Bubble({ drag, layout }) {
  const width = drag.words.length * 7 + 16;
  const x = Math.min(drag.pointer.x + 14, layout.width - 4 - width);
  const y = Math.max(drag.pointer.y - 34, 2);
  return html`<g class="bubble"><rect x=${x} y=${y} width=${width} height="22" rx="4" />
    <text x=${x + width / 2} y=${y + 15}>${drag.words}</text></g>`;
}

/** The width of an element, followed. @param {{current: any}} ref */
function useWidth(ref) {
  const size = useSignal({ width: 900, height: 0 });
  useEffect(() => {
    const measure = () => (size.value = { width: ref.current.clientWidth, height: innerHeight });
    const observer = new ResizeObserver(measure);
    observer.observe(ref.current);
    addEventListener("resize", measure);
    return () => {
      observer.disconnect();
      removeEventListener("resize", measure);
    };
  }, []);
  return size.value.width;
}

/** Scroll lanes until a place is in view, below the scale. @param {any} box @param {{y: number, height: number}} place */
function reveal(box, { y, height }) {
  const scale = box.firstElementChild.clientHeight;
  box.scrollTop = Math.min(Math.max(box.scrollTop, y + height + scale + 8 - box.clientHeight), y);
}

/** Draw only lanes of which something changed: Preact passes over an element that it was given before. @param {(place: any) => [any, any]} draw */
function useLanes(draw) {
  const drawn = useRef(new Map());
  return (places, /** @type {number} */ width) =>
    places.map((place) => {
      const [chosen, element] = draw(place);
      const { row, y, height, figure, low, high } = place;
      const state = [row.item, y, height, figure, low, high, width, chosen, place.before];
      const before = drawn.current.get(row.id);
      if (before && state.every((one, n) => one === before.state[n])) return before.element;
      drawn.current.set(row.id, { state, element });
      return element;
    });
}

/**
 * @param {{data: any, figures: any, saved: any, selected: any, cursor: any,
 *          propose: (changes: import("./timing_drag.js").Change[], commit: boolean) => void}} props
 */
export function TimingDiagram({ data, figures, saved, selected, cursor, propose }) {
  const [box, svg] = [useRef(null), useRef(null)];
  const drag = useSignal(/** @type {any} */ (null));
  const width = useWidth(box);
  const now = drag.value;
  const tree = (now?.changes ?? []).reduce((all, { path, value }) => put(all, path, value), data.value);
  const period = periodOf(tree);
  const shown = figures.value;
  const rows = rowsOf(tree, shown.gaps);
  const scale = now?.target.kind === "lift" ? now.scale : null;
  const layout = layOut(rows, shown, period, width, selected.value, scale, saved.value);
  const axis = selected.value?.axis;
  useEffect(() => {
    const place = layout.places.find(({ row }) => row.isAxis && row.index === axis);
    if (place) reveal(box.current, place);
  }, [axis]);
  const hands = useHands({ svg, rows, layout, period, selected, cursor, drag, propose });
  const key = useRef(/** @type {any} */ (null));
  key.current = hands.key;
  const onKey = useRef((...given) => key.current(...given)).current;
  const lanesOf = useLanes((place) => {
    const chosen = selected.value?.axis === place.row.index && place.row.isAxis ? selected.value : null;
    const onSelect = () => selected.peek()?.axis === place.row.index || (selected.value = { axis: place.row.index, phase: null });
    if (place.row.isGap) return [null, html`<${Gap} key=${place.row.id} ...${{ place, layout, period }} />`];
    return [chosen, html`<${Lane} key=${place.row.id} ...${{ place, layout, period, selected: chosen, onSelect, onKey }} />`];
  });
  return html`<section class="panel timing" aria-label="Timing diagram">
    <h2>Timing diagram
      <small>drag an edge, a phase, a lift; Ctrl pushes the next, Shift moves the axis, Alt finely, Esc back; or by arrow keys</small></h2>
    <div class="lanes" ref=${box}>
      <${Scale} cursor=${cursor} layout=${layout} period=${period} />
      <svg ref=${svg} width=${width} height=${layout.height} ...${hands.svg} class=${now ? "dragging" : ""}>
        <g class="grid">${ticksOf(period.length).map((angle) => html`<path d=${`M${layout.x(angle)} 0V${layout.height}`} />`)}</g>
        ${lanesOf(layout.places, width)}
        ${now?.guide != null && html`<path class="guide" d=${`M${layout.x(now.guide)} 0V${layout.height}`} />`}
        ${now?.hasMoved && html`<${Marks} drag=${now} rows=${rows} layout=${layout} />`}
        <${Cursor} cursor=${cursor} layout=${layout} />
        ${now?.hasMoved && html`<${Bubble} drag=${now} layout=${layout} />`}
      </svg>
    </div>
  </section>`;
}

// The timing diagram: a lane for each axis, switches as bars, all of it to be dragged.
import { html, useEffect, useMemo, useRef, useSignal } from "./html.js";
import { classOf, short } from "./colors.js";
import { changed, held } from "./pieces.js";
import { niceStep, rowsOf, space } from "./timing_drag.js";
import { useHands } from "./timing_hands.js";
import { Lane } from "./timing_lane.js";
import { layOut, positionOf } from "./timing_places.js";

const TICK = 38; // px that a number on the scale takes

/** The angles with a line and a number: each 30° of a turn, else a round part of the period. @param {number} length */
export function ticksOf(length) {
  const step = length % 360 === 0 ? length / 12 : niceStep(length / 10);
  const count = Math.floor(length / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, k) => Number((k * step).toPrecision(6)));
}

/** The line under the pointer with the position of every axis there. */
function Cursor({ cursor, layout }) {
  if (cursor.value === null) return null;
  const x = layout.x(cursor.value);
  return html`<g class="cursor"
    ><path d=${`M${x} 0V${layout.height}`} /> ${layout.places
      .filter((/** @type {any} */ { row }) => row.isAxis)
      .map(
        (/** @type {any} */ place) =>
          html`<text class=${classOf(place.row.index)} x=${layout.right + 8} y=${place.y + place.height / 2 + 4}
            >${short(positionOf(place, cursor.value))}${space(place.row.unit)}</text
          >`,
      )}</g
  >`;
}

/** The scale above the lanes, with the number of the line under the pointer. */
function Scale({ cursor, layout, period }) {
  const now = cursor.value;
  const room = now === null ? null : layout.x(now);
  const ticks = ticksOf(period.length);
  const apart = layout.x(ticks[1]) - layout.x(ticks[0]);
  const every = [1, 2, 3, 4, 6].find((n) => n * apart >= TICK) ?? 12;
  return html`<svg class="scale" width=${layout.right + 86} height="22" aria-hidden="true">
    ${ticks
      .filter((_, n) => n % every === 0)
      .map(
        (angle) =>
          html`<text
            x=${layout.x(angle)}
            y="15"
            class=${room !== null && Math.abs(layout.x(angle) - room) < TICK ? "faint" : ""}
            >${angle}</text
          >`,
      )}
    ${room !== null && html`<text class="now" x=${room} y="15">${short(/** @type {number} */ (now))}${space(period.unit)}</text>`}
  </svg>`;
}

/** What is dragged, as a number at the pointer. */
function Bubble({ drag, layout }) {
  const width = drag.words.length * 7 + 16;
  const x = Math.min(drag.pointer.x + 14, layout.right + 80 - width);
  const y = Math.max(drag.pointer.y - 34, 2);
  return html`<g class="bubble"
    ><rect x=${x} y=${y} width=${width} height="22" rx="4" /><text x=${x + width / 2} y=${y + 15}
      >${drag.words}</text
    ></g
  >`;
}

/** The width of an element, followed. @param {{current: any}} ref */
function useWidth(ref) {
  const size = useSignal({ width: 900, height: 0 });
  useEffect(() => {
    const measure = () => {
      size.value = { width: ref.current.clientWidth, height: innerHeight };
    };
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

/** Draw only lanes of which something changed: Preact passes over an element that it was given before. @param {(place: any) => [any, any]} draw */
function useLanes(draw) {
  const drawn = useRef(new Map());
  return (/** @type {any[]} */ places, /** @type {number} */ width) =>
    places.map((place) => {
      const [chosen, element] = draw(place);
      const { row, y, height, figure, low, high } = place;
      const state = [row.item, y, height, figure, low, high, width, chosen];
      const before = drawn.current.get(row.id);
      if (before && state.every((one, n) => one === before.state[n])) return before.element;
      drawn.current.set(row.id, { state, element });
      return element;
    });
}

/**
 * @param {{design: any, figures: any, selected: any, cursor: any,
 *          propose: (changes: import("./pieces.js").Change[], commit: boolean) => void}} props
 */
export function TimingDiagram({ design, figures, selected, cursor, propose }) {
  const [box, svg] = [useRef(null), useRef(null)];
  const drag = useSignal(/** @type {any} */ (null));
  const width = useWidth(box);
  const given = held(design);
  const now = drag.value;
  const { period } = given;
  const rows = rowsOf(now ? changed(given, now.changes) : given);
  const layout = layOut(
    rows,
    held(figures),
    period,
    width,
    selected.value,
    now?.target.kind === "lift" ? now.scale : null,
  );
  const hands = useHands({ svg, rows, layout, period, selected, cursor, drag, propose });
  const key = useRef(hands.key);
  key.current = hands.key;
  const onKey = useMemo(
    () =>
      (/** @type {any} */ ...given) =>
        /** @type {any} */ (key.current)(...given),
    [],
  );
  const lanesOf = useLanes((place) => {
    const chosen = selected.value?.axis === place.row.index && place.row.isAxis ? selected.value : null;
    const onSelect = () =>
      selected.peek()?.axis === place.row.index || (selected.value = { axis: place.row.index, phase: null });
    return [
      chosen,
      html`<${Lane} key=${place.row.id} ...${{ place, layout, period, selected: chosen, onSelect, onKey }} />`,
    ];
  });
  return html`<section class="panel timing" aria-label="Timing diagram">
    <h2>
      Timing diagram
      <small>drag an edge, a phase, a lift; Shift the axis, Alt finely, Esc back; or by arrow keys</small>
    </h2>
    <div class="lanes" ref=${box}>
      <${Scale} cursor=${cursor} layout=${layout} period=${period} />
      <svg ref=${svg} width=${width} height=${layout.height} ...${hands.svg} class=${now ? "dragging" : ""}>
        <g class="grid">
          ${ticksOf(period.length).map((angle) => html`<path d=${`M${layout.x(angle)} 0V${layout.height}`} />`)}
        </g>
        ${lanesOf(layout.places, width)}
        ${now?.guide != null && html`<path class="guide" d=${`M${layout.x(now.guide)} 0V${layout.height}`} />`}
        <${Cursor} cursor=${cursor} layout=${layout} />
        ${now?.hasMoved && html`<${Bubble} drag=${now} layout=${layout} />`}
      </svg>
    </div>
  </section>`;
}

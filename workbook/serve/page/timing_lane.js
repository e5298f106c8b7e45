// A row of the timing diagram: the lane of an axis with its line, or the bars of a switch.
import { html } from "./html.js";
import { classOf } from "./colors.js";
import { roomOf, space } from "./timing_drag.js";
import { idOf } from "./timing_hands.js";
import { stretchesOf } from "./timing_places.js";
import { isWhole } from "./timing_rows.js";

const LETTER = 7.4; // px, about, of a letter
const NAMES = { from: "from", to: "to", lift: "lift", span: "all of it", shift: "shift" };

/** The line's path. @param {any} place @param {(angle: number) => number} x */
export function pathOf({ runs, toY }, x) {
  return runs.flatMap((run) => run.map(([angle, position], n) => `${n ? "L" : "M"}${x(angle).toFixed(1)} ${toY(position).toFixed(1)}`)).join("");
}

/** The attributes with which a target is a slider for keys and for screen readers. */
function slider({ row }, target, period, key) {
  const span = row.spans[target.k];
  const unit = target.kind === "lift" ? row.unit : period.unit;
  const value = target.kind === "shift" ? row.shift : span[target.kind === "span" ? "from" : target.kind];
  const [low, high] = target.kind === "lift" ? [-1e9, 1e9] : span ? roomOf(row, span, period.length) : [0, period.length];
  const place = span ? `, ${row.isAxis ? "phase" : "bar"} ${target.k + 1}` : "";
  return {
    id: idOf(target),
    role: "slider",
    tabindex: 0,
    "aria-label": `${row.name}${place}, ${NAMES[/** @type {keyof NAMES} */ (target.kind)]}`,
    "aria-valuenow": value,
    "aria-valuemin": low,
    "aria-valuemax": high,
    "aria-valuetext": target.kind === "span" ? `${span.from} to ${span.to}${space(unit)}` : `${value}${space(unit)}`,
    onKeyDown: (/** @type {KeyboardEvent} */ event) => key(event, target),
  };
}

/** A handle where it is drawn, with a line to where it truly is. */
const Handle = ({ place, handle, period, onKey }) => {
  const target = { row: place.row.id, kind: handle.kind, k: handle.k };
  const { x, y, at } = handle;
  return html`<g class=${`handle ${handle.kind}`} ...${slider(place, target, period, onKey)}>
    ${Math.abs(x - at) > 1 && html`<path class="leader" d=${`M${at} ${y}L${x} ${y}`} />`}
    ${handle.kind === "lift"
      ? html`<rect x=${x - 7} y=${y - 7} width="14" height="14" rx="2" transform=${`rotate(45 ${x} ${y})`} />`
      : html`<circle cx=${x} cy=${y} r="7" />`}
  </g>`;
};

export const clipped = (/** @type {string} */ text, /** @type {number} */ room) =>
  text.length * LETTER > room ? `${text.slice(0, Math.max(Math.floor(room / LETTER) - 1, 1))}…` : text;

/** The law and lift of a phase at its line, as far as there is room for them. @param {any} span @param {string} unit @param {number} room */
function labelOf(span, unit, room) {
  const lift = String(span.lift).replace("-", "−");
  const all = [`${span.law} ${lift}${space(unit)}`, `${span.law} ${lift}`, lift];
  return all.find((text) => text.length * LETTER <= room) ?? "";
}

/** The shaded room of a phase, or the bar of a switch. */
function Span({ place, span, k, layout, period, isTold, isChosen, onKey }) {
  const { row, y, height } = place;
  const stretches = stretchesOf(row, span, layout.length);
  const [from, to] = [...stretches].sort((a, b) => b[1] - b[0] - (a[1] - a[0]))[0];
  const room = layout.x(to) - layout.x(from);
  const target = { row: row.id, kind: "span", k };
  return html`<g class=${isChosen ? "span chosen" : "span"} ...${isTold ? slider(place, target, period, onKey) : {}}>
    ${stretches.map(([a, b]) => html`<rect x=${layout.x(a)} y=${row.isAxis ? y : y + 5} width=${Math.max(layout.x(b) - layout.x(a), 1)}
      height=${row.isAxis ? height : height - 10} rx="4" />`)}
    ${row.isAxis && html`<text class="label" x=${layout.x((from + to) / 2)} y=${y + 12}>${labelOf(span, row.unit, room - 14)}</text>`}
  </g>`;
}

/** The line of an axis, and dashed that of the saved design where it is another. */
function Lines({ place, x }) {
  const [now, before] = [pathOf(place, x), pathOf({ runs: place.before, toY: place.toY }, x)];
  return html`${before && before !== now && html`<path class="saved" d=${before} />`}<path class="line" d=${now} />`;
}

/** @param {{place: any, layout: any, period: any, selected: any, onSelect: () => void, onKey: any}} given */
export function Lane({ place, layout, period, selected, onSelect, onKey }) {
  const { row, y, height, figure } = place;
  const isSelected = row.isAxis && selected?.axis === row.index;
  const isTold = isSelected || !row.isAxis;
  const spans = row.spans.map((span, k) => ({ span, k })).filter(({ span }) => isWhole(span));
  const missing = row.isAxis && (figure?.error ?? (spans.length < row.spans.length ? "a phase lacks its begin or end" : ""));
  const name = clipped(row.name, 88);
  const middle = y + height / 2 + 4;
  const shift = { row: row.id, kind: "shift", k: -1 };
  const lead = row.isAxis ? { ...slider(place, shift, period, onKey), onFocus: onSelect } : {};
  const classes = `lane ${row.isAxis ? classOf(row.index) : row.index < 0 ? "bars" : `bars ${classOf(row.index)}`}${isSelected ? " selected" : ""}${figure?.stale || missing ? " stale" : ""}`;
  return html`<g class=${classes}>
    <rect class="ground" x="0" y=${y - 2} width=${layout.width} height=${height + 4} />
    <g class="name" ...${lead}><rect x="2" y=${y + 2} width="94" height=${height - 4} rx="4" /><title>${row.name}</title>
      <text x="8" y=${middle}>${name}</text></g>
    ${spans.map(({ span, k }) => html`<${Span} key=${k} ...${{ place, span, k, layout, period, isTold, onKey }}
      isChosen=${isSelected && selected.phase === span.index} />`)}
    ${row.isAxis && html`<${Lines} place=${place} x=${layout.x} />`}
    ${missing && html`<text class="missing" x=${layout.left + 6} y=${y + height - 6}>${clipped(missing, layout.right - layout.left)}<title>${missing}</title></text>`}
    ${isTold && place.handles.filter((one) => one.kind !== "span").map((handle) => html`<${Handle} key=${`${handle.kind}${handle.k}`} ...${{ place, handle, period, onKey }} />`)}
  </g>`;
}

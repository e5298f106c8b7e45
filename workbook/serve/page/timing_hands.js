// Pointer and keys in the timing diagram: both come to the same changes.
import { batch, useEffect } from "./html.js";
import { movedBy, niceStep, roomOf } from "./timing_drag.js";
import { placeAt, targetAt } from "./timing_places.js";

/**
 * @typedef {import("./timing_drag.js").Target} Target
 * @typedef {{target: Target, rows: any[], scale: {row: string, low: number, high: number}, x: number, y: number, hasMoved: boolean,
 *            changes: any[], words: string, guide: number|null, pointer: {x: number, y: number}, perLift: number,
 *            stop?: any, pushed?: any[]}} Drag
 */

const START = 3; // px that a pointer moves before it drags: less is a click
const REACH = 6; // px at which an edge snaps to another
const SHAPES = { from: "ew-resize", to: "ew-resize", span: "grab", lift: "ns-resize", shift: "grab" };

/** Whether changes enter other values than there are. @param {any[]} changes @param {any[]} rows */
function isOther(changes, rows) {
  return changes.some(({ path, value }) => {
    const key = path.at(-1);
    if (key === "shift") return value !== rows.find((one) => one.isAxis && one.index === path[1])?.shift;
    const span = rows.find((one) => path.slice(0, -2).join() === one.path.join())?.spans[path.at(-2)];
    return value !== span?.[key === "start" ? "from" : key === "stop" ? "to" : key];
  });
}

/**
 * The handlers of the diagram. @param {{svg: {current: any}, rows: any[], layout: any, period: any, selected: any, cursor: any,
 * drag: {value: Drag|null, peek: () => Drag|null}, propose: (changes: any[], commit: boolean) => void}} given
 */
export function useHands({ svg, rows, layout, period, selected, cursor, drag, propose }) {
  const point = (event) => {
    const box = svg.current.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const angleAt = (/** @type {number} */ x) => ((x - layout.left) / (layout.right - layout.left)) * period.length;

  const cancel = () =>
    batch(() => {
      if (drag.peek()?.hasMoved) propose([], false);
      drag.value = null;
    });
  useEffect(() => {
    const heard = (/** @type {KeyboardEvent} */ event) => {
      if (event.key !== "Escape" || !drag.peek()) return;
      event.preventDefault();
      event.stopPropagation();
      cancel();
    };
    addEventListener("keydown", heard, true);
    return () => removeEventListener("keydown", heard, true);
  });

  const down = (event) => {
    const { x, y } = point(event);
    const place = placeAt(layout, y);
    if (event.button || !place) return;
    event.preventDefault();
    let target = targetAt(layout, place, x, y);
    const phase = target && target.kind !== "shift" ? place.row.spans[target.k].index : null;
    if (place.row.index >= 0) selected.value = { axis: place.row.index, phase: place.row.isAxis ? phase : null };
    else selected.value = { ...selected.value, part: place.row.path.slice(0, 2) };
    if (event.shiftKey && place.row.isAxis) target = { row: place.row.id, kind: "shift", k: -1 };
    if (!target) return;
    svg.current.setPointerCapture(event.pointerId);
    const scale = { row: place.row.id, low: place.low, high: place.high };
    const perLift = (place.high - place.low || Math.abs(place.row.spans[target.k]?.lift) || 1) / (place.height - 20);
    drag.value = { target, rows, scale, perLift, x, y, hasMoved: false, changes: [], words: "", guide: null, pointer: { x, y } };
    requestAnimationFrame(() => document.getElementById(idOf(/** @type {Target} */ (target)))?.focus({ preventScroll: true }));
  };

  const move = (event) => {
    const { x, y } = point(event);
    const now = drag.peek();
    if (!now) {
      const place = placeAt(layout, y);
      const target = place && targetAt(layout, place, x, y);
      svg.current.style.cursor = target ? SHAPES[target.kind] : "";
      const angle = angleAt(x);
      cursor.value = angle >= 0 && angle <= period.length ? angle : null;
      return;
    }
    if (!now.hasMoved && Math.hypot(x - now.x, y - now.y) < START) return;
    const way = { time: angleAt(x) - angleAt(now.x), lift: (now.y - y) * now.perLift };
    const snap = { isFine: event.altKey, isPush: event.ctrlKey || event.metaKey, reach: angleAt(REACH) - angleAt(0) };
    const result = movedBy(now.rows, now.target, way, snap, period);
    batch(() => {
      cursor.value = null; // it stands where the drag began
      drag.value = { ...now, ...result, hasMoved: true, pointer: { x, y } };
      propose(isOther(result.changes, now.rows) ? result.changes : [], false);
    });
  };

  const up = () => {
    const now = drag.peek();
    if (!now) return;
    batch(() => {
      if (now.hasMoved) propose(isOther(now.changes, now.rows) ? now.changes : [], isOther(now.changes, now.rows));
      drag.value = null;
    });
  };

  const leave = () => {
    if (!drag.peek()) cursor.value = null;
  };
  const key = (/** @type {KeyboardEvent} */ event, /** @type {Target} */ target) => {
    const moved = keyed(event, target, rows, period);
    if (!moved) return;
    event.preventDefault();
    const { changes } = movedBy(rows, moved.target, moved.way, { isFine: true, isPush: event.ctrlKey || event.metaKey, reach: 0 }, period);
    if (isOther(changes, rows)) propose(changes, true);
  };
  return { svg: { onPointerDown: down, onPointerMove: move, onPointerUp: up, onPointerCancel: cancel, onPointerLeave: leave }, key };
}

/** The target and way that a key means, or null. @param {KeyboardEvent} event @param {Target} target @param {any[]} rows @param {any} period */
function keyed(event, target, rows, period) {
  const row = rows.find((one) => one.id === target.row);
  const span = row.spans[target.k];
  const isUpright = event.key === "ArrowUp" || event.key === "ArrowDown";
  const sign = { ArrowRight: 1, ArrowUp: 1, PageUp: 10, ArrowLeft: -1, ArrowDown: -1, PageDown: -10 }[event.key] ?? 0;
  const many = (event.altKey ? 0.1 : 1) * sign;
  const time = many * niceStep(period.length / 360);
  if (target.kind === "from" || target.kind === "to") {
    const [low, high] = roomOf(row, span, period.length);
    if (event.key === "Home") return { target, way: { time: low - span[target.kind], lift: 0 } };
    if (event.key === "End") return { target, way: { time: high - span[target.kind], lift: 0 } };
  }
  if (!sign) return null;
  if (event.shiftKey && row.isAxis) return { target: { ...target, kind: /** @type {const} */ ("shift") }, way: { time, lift: 0 } };
  const isLift = target.kind === "lift" || (target.kind === "span" && row.isAxis && isUpright);
  if (!isLift) return { target, way: { time, lift: 0 } };
  const lift = many * niceStep(Math.max(Math.abs(span.lift), 1) / 100);
  return { target: { ...target, kind: /** @type {const} */ ("lift") }, way: { time: 0, lift } };
}

/** The id of the element that stands for a target. @param {Target} target */
export const idOf = ({ row, kind, k }) => `${row}-${kind}-${k < 0 ? "all" : k}`;

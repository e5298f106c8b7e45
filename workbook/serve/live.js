// Show beside a description what it comes to, as it is typed; drag the edges of phases in its timing diagram.
import { area as text, ask, changed, follow } from "./text.js";

const panel = document.getElementById("live");
let held = null; // the edge or lane that is dragged, or moved by keys

follow(async () => {
  const words = await ask("/live");
  if (words === null) return;
  panel.innerHTML = words;
  if (!held) return;
  held.handle = find(held);
  held.handle?.focus({ preventScroll: true });
});

// --- edges of phases, and lanes

function edgeOf(handle) {
  const { value, step, across, places, edge, before } = handle.dataset;
  const pairs = places.split(" ").map((place) => place.split("-").map(Number));
  const axis = edge.slice(0, edge.lastIndexOf(" "));
  const lane = handle.matches(".lane");
  return { handle, axis, lane, before, value: Number(value), step: Number(step), across: Number(across), places: pairs };
}

function find({ axis, lane, value }) {
  const wanted = `${axis} ${lane ? "lane" : value}`;
  return [...panel.querySelectorAll("[data-edge]")].find((one) => one.dataset.edge === wanted);
}

/** Whether the numbers of an edge are still in the text where they were. */
function stands({ places, value }) {
  return places.every(([begin, end]) => Number(text.value.slice(begin, end)) === value);
}

/** The edge of an event's handle, with Shift the lane that it is on; null where the text has changed meanwhile. */
function edgeAt(event) {
  let handle = event.target.closest(".edge, .lane");
  if (handle && event.shiftKey) handle = find({ ...edgeOf(handle), lane: true }) ?? handle;
  if (!handle) return null;
  const edge = held?.handle === handle && stands(held) ? held : edgeOf(handle);
  return stands(edge) ? edge : null;
}

/** Keep the comment of an edge's line in its column after a number before it, which ends at a place, grew. */
function align(edge, at, grown) {
  const found = /^((?:[^"'#\n]|"[^"\n]*"|'[^'\n]*')*?)( +)#/.exec(text.value.slice(at));
  if (!found) return;
  const begin = at + found[1].length;
  const blanks = Math.max(1, found[2].length - grown);
  text.setRangeText(" ".repeat(blanks), begin, begin + found[2].length, "preserve");
  const later = blanks - found[2].length;
  edge.places = edge.places.map((place) => (place[0] > begin ? place.map((one) => one + later) : place));
}

function move(edge, value) {
  const steps = Math.max(edge.lane ? -Infinity : 0, Math.round(value / edge.step));
  const decimals = Math.max(1, Math.round(-Math.log10(edge.step)));
  const words = (steps * edge.step).toFixed(decimals);
  if (Number(words) === edge.value) return;
  const [begin, end] = edge.places[0];
  const grown = words.length - (end - begin);
  let longer = 0;
  edge.places = edge.places.map(([begin, end]) => {
    text.setRangeText(edge.before + words, begin + longer, end + longer, "preserve");
    const first = begin + longer + edge.before.length;
    longer += edge.before.length + words.length - (end - begin);
    return [first, first + words.length];
  });
  if (!edge.before) edge.places.forEach((_, k) => align(edge, edge.places[k][1], grown));
  edge.before = "";
  edge.value = Number(words);
  changed(edge.x === undefined);
}

panel.addEventListener("pointerdown", (event) => {
  const edge = edgeAt(event);
  if (!edge) return;
  event.preventDefault();
  panel.setPointerCapture(event.pointerId);
  held = Object.assign(edge, { x: event.clientX, from: edge.value, scale: edge.handle.ownerSVGElement.getScreenCTM().a });
});

panel.addEventListener("pointermove", (event) => {
  if (held?.x !== undefined) move(held, held.from + ((event.clientX - held.x) / held.scale) * held.across);
});

panel.addEventListener("pointerup", () => {
  if (held?.x === undefined) return;
  delete held.x;
  changed();
});

panel.addEventListener("keydown", (event) => {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  const edge = way && edgeAt(event);
  if (!edge) return;
  event.preventDefault();
  held = edge;
  move(held, held.value + way * held.step);
});

text.addEventListener("input", () => {
  held = null;
  changed();
});

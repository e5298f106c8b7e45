// Show beside a description what it comes to, as it is typed; drag the edges of phases in its timing diagram.
import { area as text, ask, changed, follow } from "./text.js";

const panel = document.getElementById("live");
let held = null; // the edge that is dragged, or moved by keys

follow(async () => {
  const words = await ask("/live");
  if (words === null) return;
  panel.innerHTML = words;
  if (held) find(held)?.focus({ preventScroll: true });
});

// --- edges of phases

function edgeOf(handle) {
  const { value, step, across, places, edge } = handle.dataset;
  const pairs = places.split(" ").map((place) => place.split("-").map(Number));
  return { axis: edge.slice(0, edge.lastIndexOf(" ")), value: Number(value), step: Number(step), across: Number(across), places: pairs };
}

function find(edge) {
  const wanted = `${edge.axis} ${edge.value}`;
  return [...panel.querySelectorAll(".edge")].find((one) => one.dataset.edge === wanted);
}

function move(edge, value) {
  const steps = Math.max(0, Math.round(value / edge.step));
  const decimals = Math.max(1, Math.round(-Math.log10(edge.step)));
  const words = (steps * edge.step).toFixed(decimals);
  if (Number(words) === edge.value) return;
  let longer = 0;
  edge.places = edge.places.map(([begin, end]) => {
    text.setRangeText(words, begin + longer, end + longer, "preserve");
    const place = [begin + longer, begin + longer + words.length];
    longer += words.length - (end - begin);
    return place;
  });
  edge.value = Number(words);
  changed();
}

panel.addEventListener("pointerdown", (event) => {
  if (!event.target.matches(".edge")) return;
  event.preventDefault();
  panel.setPointerCapture(event.pointerId);
  const svg = event.target.ownerSVGElement;
  held = { ...edgeOf(event.target), x: event.clientX, from: Number(event.target.dataset.value), scale: svg.getScreenCTM().a };
});

panel.addEventListener("pointermove", (event) => {
  if (!held || held.x === undefined) return;
  move(held, held.from + ((event.clientX - held.x) / held.scale) * held.across);
});

panel.addEventListener("pointerup", () => {
  if (held) delete held.x;
});

panel.addEventListener("keydown", (event) => {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!way || !event.target.matches(".edge")) return;
  event.preventDefault();
  const handle = edgeOf(event.target);
  if (!held || find(held) !== event.target) held = handle;
  move(held, held.value + way * held.step);
});

text.addEventListener("input", () => {
  held = null;
  changed();
});

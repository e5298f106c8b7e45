// The entries that a study varies, chosen by clicking them in the design, or by Enter.
import { html } from "./html.js";
import { save } from "./save.js";
import * as s from "./state.js";

async function goOn() {
  const keys = Object.keys(s.picked.value);
  if (!(await save())) return;
  const fields = new URLSearchParams(keys.map((key) => ["vary", key]));
  location.href = `/vary/${encodeURIComponent(s.file.value.name)}?${fields}`;
}

/** What is chosen so far, and the way on to the goals. */
export function Picking() {
  if (!s.picked.value) return null;
  const words = Object.values(s.picked.value);
  const told = words.length ? `Study of ${words.join("; ")}` : "Study: click the entries that vary";
  return html`<div class="notice"><div role="status">${told}</div>
    <button onClick=${goOn}>Choose goals …</button>
    <button onClick=${() => (s.picked.value = null)}>cancel</button></div>`;
}

/** Take a press on an entry, or Enter in it, as a choice, while a study's entries are chosen. @param {any} event */
export function pick(event) {
  const picked = s.picked.value;
  const place = event.target.closest(".in, .sel, .f, td");
  const entry = place?.matches("[data-path]") ? place : place?.querySelector("[data-path]");
  if (!picked || !entry || (event.type === "keydown" && event.key !== "Enter")) return;
  event.preventDefault();
  event.stopPropagation();
  if (event.type === "click") return; // which the press before it was
  const { [entry.dataset.path]: before, ...others } = picked;
  const axis = s.data.value.axes?.[s.selected.value.axis]?.name;
  const words = `${s.selected.value.part ? "" : `${axis}, `}${entry.ariaLabel}`;
  s.picked.value = before ? others : { ...picked, [entry.dataset.path]: words };
}

// A field: what is typed stays while it has the focus; Enter and Tab take it, Esc restores it, arrows step it.
import { html, useEffect, useLayoutEffect, useRef } from "./html.js";
import { commit } from "./journal.js";
import * as s from "./state.js";

let active = null; // how what is typed in the field with the focus is taken

/** Take what stands in the field with the focus. */
export const takeActive = () => active?.();

/** A number with the digits that it has, without those of its storage. */
export const shown = (value) =>
  value === null || value === undefined ? "" : typeof value === "number" ? String(Number(value.toPrecision(12))) : typeof value === "object" ? JSON.stringify(value) : String(value);

function stepped(words, unit, way, event) {
  const value = Number(words.replace(",", "."));
  if (words.trim() === "" || !Number.isFinite(value)) return null;
  const size = unit === "°" || value === 0 ? 1 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - 1);
  const step = size * (event.altKey ? 0.1 : event.shiftKey ? 10 : 1);
  return shown(value + way * step);
}

/** The unit of an entry where it is that of its axis or of the cycle. */
function unitOf(entry, path) {
  const axis = path[0] === "axes" ? (s.data.value.axes?.[path[1]]?.unit ?? "mm") : "";
  if (axis && ["lift", "position", "low", "high"].includes(entry.name)) return axis;
  if (entry.unit.includes("cycle's unit")) return s.period.value.unit;
  const units = entry.unit.split(" or ");
  return units.length > 1 ? units[axis === "°" ? 1 : 0] : entry.unit;
}

/** The input of an entry; ``label`` is read to those who do not see it. */
export function Input({ entry, path, label, wide }) {
  const place = useRef(null);
  const typed = useRef(null); // what was typed and not taken yet
  const key = s.keyOf(path);
  const value = s.get(s.data.value, path);
  const refusal = s.refused.value[key];
  const words = s.waiting.value[key] ?? refusal?.typed ?? shown(value);
  const wrong = refusal?.sentence ?? s.faults.value[key];
  const unit = unitOf(entry, path);
  useLayoutEffect(() => {
    const isTyping = typed.current !== null && document.activeElement === place.current;
    if (!isTyping && place.current.value !== words) place.current.value = words;
  });
  const take = () => {
    const now = typed.current;
    typed.current = null;
    if (now !== null && now !== words) commit([{ path, value: now }]);
  };
  const latest = useRef(take);
  latest.current = take;
  useEffect(() => () => latest.current(), []); // a field that goes away takes what was typed
  const onKeyDown = (event) => {
    if (event.key === "Enter") take();
    else if (event.key === "Escape") {
      typed.current = null;
      place.current.value = shown(value);
      if (refusal) s.refused.value = Object.fromEntries(Object.entries(s.refused.value).filter(([name]) => name !== key));
      event.stopPropagation();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      const next = entry.options.length ? null : stepped(place.current.value, unit, event.key === "ArrowUp" ? 1 : -1, event);
      if (next === null) return;
      event.preventDefault();
      typed.current = next;
      place.current.value = next;
      take();
    }
  };
  const events = {
    onInput: (event) => {
      typed.current = event.target.value;
    },
    onFocus: (event) => {
      active = () => latest.current();
      event.target.select();
    },
    onBlur: () => {
      take();
      active = null;
    },
    onKeyDown,
  };
  const about = [entry.note, entry.expected].filter(Boolean).join("; ");
  const list = entry.options.length ? `options-${entry.name}` : undefined;
  return html`<span class=${`in ${wrong ? "bad" : ""}`}>
    <input ref=${place} data-path=${key} data-picked=${s.isPicked(key)} class=${wide ? "words" : ""} aria-label=${label ?? entry.label} title=${about}
      placeholder=${entry.default === "none" ? "" : entry.default} spellcheck=${false} autocomplete="off" list=${list}
      aria-invalid=${wrong ? "true" : undefined} ...${events} />
    ${unit && !wide && html`<em>${unit}</em>`}
  </span>`;
}

/** A choice among words that are known. */
export function Choice({ entry, path, label }) {
  const value = s.get(s.data.value, path);
  const onChange = (event) => commit([{ path, value: event.target.value }]);
  const words = [...new Set([...(value === undefined ? [] : [value]), ...entry.options])];
  return html`<select class="in" data-path=${s.keyOf(path)} data-picked=${s.isPicked(s.keyOf(path))} aria-label=${label ?? entry.label} title=${entry.note || entry.expected}
      onChange=${onChange} value=${value ?? ""}>
    ${!entry.required && html`<option value="">${entry.default}</option>`}
    ${words.map((word) => html`<option value=${word} selected=${word === value}>${word}</option>`)}
  </select>`;
}

/** The sentence below an entry that is wrong. */
export function Wrong({ path }) {
  const key = s.keyOf(path);
  const words = s.refused.value[key]?.sentence ?? s.faults.value[key];
  return words ? html`<small class="wrong" role="alert">${words}</small>` : null;
}

const isLong = (entry) => entry.expected.startsWith("a text") || entry.expected.includes("list");

/** A row of the right side: label, input with its unit, and what is wrong. */
export function Field({ entry, path, label }) {
  const input = entry.options.length && entry.name !== "law" && !entry.expected.startsWith("a text") ? Choice : Input;
  return html`<div class="f">
    <label title=${entry.note}>${entry.label}</label>
    <${input} entry=${entry} path=${path} wide=${isLong(entry)} label=${label || undefined} />
    <${Wrong} path=${path} />
  </div>`;
}

// The choice of a law: by its picture and its name.
import { html, useEffect, useRef, useState } from "./html.js";
import { commit } from "./journal.js";
import { laws } from "./catalogue.js";
import * as s from "./state.js";

const picture = (shape) => shape && html`<svg viewBox="0 0 24 14" aria-hidden="true"><polyline fill="none" stroke="currentColor"
  points=${shape.map((y, k) => `${(1 + (22 * k) / (shape.length - 1)).toFixed(1)},${(13 - 12 * y).toFixed(1)}`).join(" ")} /></svg>`;

export function LawChoice({ path, label }) {
  const [isOpen, open] = useState(false);
  const place = useRef(null);
  const value = s.get(s.data.value, path);
  const own = Object.entries(s.data.value.laws ?? {}).filter(([name]) => !laws.value.some((law) => law.code === name));
  const all = [...laws.value, ...own.map(([name, entry]) => ({ code: name, title: `own, ${entry.family ?? ""}` }))];
  const known = all.find((law) => law.code === value);
  useEffect(() => {
    if (!isOpen) return undefined;
    place.current.querySelector(".chosen, .law-choice")?.focus();
    const away = (event) => place.current?.contains(event.target) || open(false);
    document.addEventListener("pointerdown", away);
    return () => document.removeEventListener("pointerdown", away);
  }, [isOpen]);
  const onKeyDown = (event) => {
    const choices = [...place.current.querySelectorAll(".law-choice")];
    const at = choices.indexOf(document.activeElement);
    const way = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") open(false);
    else if (way && isOpen) choices[(at + way + choices.length) % choices.length].focus();
    else return;
    event.preventDefault();
  };
  const take = (code) => {
    open(false);
    if (code !== value) commit([{ path, value: code }]);
  };
  return html`<span class="law" ref=${place} onKeyDown=${onKeyDown}>
    <button class="in" aria-label=${`${label}: ${value ?? "none"}`} aria-haspopup="listbox" aria-expanded=${isOpen} data-path=${s.keyOf(path)}
      title=${known?.title ?? ""} onClick=${() => open(!isOpen)}>${value ?? "–"} ${picture(known?.shape)}</button>
    ${isOpen && html`<div class="law-list" role="listbox" aria-label="Laws">${all.map((law) => html`<button key=${law.code} role="option"
      aria-selected=${law.code === value} class=${`law-choice ${law.code === value ? "chosen" : ""}`} onClick=${() => take(law.code)}>
      ${picture(law.shape)}<b>${law.code}</b> ${law.title}</button>`)}</div>`}
  </span>`;
}

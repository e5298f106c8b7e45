// The choice of a law: by its picture, its name, what it is for and what it comes to.
import { html, useEffect, useRef, useState } from "./html.js";
import { short } from "./colors.js";
import { commit } from "./journal.js";
import { useAway } from "./popup.js";
import * as s from "./state.js";

const USES = {
  DWL: "rests", ACS: "least acceleration, knocks at its ends", TVP: "ramps of a simple drive", CIC: "smooth, fast in the middle",
  CUB: "simple, knocks at its ends", MTP: "heavy loads, for all uses", OWN: "pieces of your own", LIN: "constant speed, between others",
  SHM: "from reversal to reversal", DHM: "from rest to a reversal", PO5: "smooth, for all uses", PO7: "smoothest, against vibration",
  MSN: "indexing, low peak torque", MTS: "as MTP, ends to choose", SCC: "shares of sine to choose", HAC: "rest to a reversal, low torque",
  SGS: "low top speed", SRT: "constant speed, soft ramps", SCV: "jerk-limited, of controllers", SPL: "through points of your own",
};

const picture = (shape) => shape && html`<svg viewBox="0 0 24 14" aria-hidden="true"><polyline fill="none" stroke="currentColor"
  points=${shape.map((y, k) => `${(1 + (22 * k) / (shape.length - 1)).toFixed(1)},${(13 - 12 * y).toFixed(1)}`).join(" ")} /></svg>`;

/** What a law comes to for unit rise in unit time. @param {any} law */
const figures = ({ v, a, j }) => (v ? `v ${short(v)} · a ${short(a)} · j ${j === null ? "∞" : short(j)}`.replaceAll(" ", "\u00a0") : "");

export function LawChoice({ path, label }) {
  const [isOpen, open] = useState(false);
  const place = useRef(/** @type {any} */ (null));
  const value = s.get(s.data.value, path);
  const own = Object.entries(s.data.value.laws ?? {}).filter(([name]) => !s.laws.value.some((law) => law.code === name));
  const all = [...s.laws.value, ...own.map(([name, entry]) => ({ code: name, title: `own, ${entry.family ?? ""}` }))];
  const known = all.find((law) => law.code === value);
  useEffect(() => {
    if (isOpen) (place.current.querySelector(".chosen") ?? place.current.querySelector(".law-choice"))?.focus();
  }, [isOpen]);
  useAway(place, isOpen, () => open(false));
  const close = () => {
    open(false);
    place.current.firstElementChild.focus();
  };
  const onKeyDown = (event) => {
    const choices = [...place.current.querySelectorAll(".law-choice")];
    const at = choices.indexOf(document.activeElement);
    const way = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape" && isOpen) close();
    else if (event.key === "Tab" && isOpen) return open(false);
    else if (way && isOpen) choices[(at + way + choices.length) % choices.length].focus();
    else return;
    event.preventDefault();
  };
  const take = (code) => {
    close();
    if (code !== value) commit([{ path, value: code }]);
  };
  return html`<span class="law" ref=${place} onKeyDown=${onKeyDown}>
    <button class="in" aria-label=${`${label}: ${value ?? "none"}`} aria-haspopup="listbox" aria-expanded=${isOpen} data-path=${s.keyOf(path)} data-picked=${s.isPicked(s.keyOf(path))}
      title=${known?.title ?? ""} onClick=${() => open(!isOpen)}>${value ?? "–"} ${picture(known?.shape)}</button>
    ${isOpen && html`<div class="law-list" role="listbox" aria-label="Laws">${all.map((law) => html`<button key=${law.code} role="option"
      aria-selected=${law.code === value} class=${`law-choice ${law.code === value ? "chosen" : ""}`} onClick=${() => take(law.code)}>
      ${picture(law.shape)}<span><b>${law.code}</b> ${law.title}<small>${[USES[law.code], figures(law)].filter(Boolean).join("; ")}</small></span></button>`)}</div>`}
  </span>`;
}

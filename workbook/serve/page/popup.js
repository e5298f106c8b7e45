// A list below the button that opens it: a choice in it, Esc and a click elsewhere close it.
import { html, useLayoutEffect, useRef, useState } from "./html.js";

/** Close what is open by Esc or a click outside of it. @param {{current: any}} place @param {boolean} isOpen @param {() => void} close */
export function useAway(place, isOpen, close) {
  useLayoutEffect(() => { // a key that follows at once counts
    if (!isOpen) return undefined;
    const away = (/** @type {any} */ event) => {
      if (event.type === "keydown" ? event.key === "Escape" : !place.current?.contains(event.target)) close();
    };
    for (const kind of ["pointerdown", "keydown"]) document.addEventListener(kind, away);
    return () => ["pointerdown", "keydown"].forEach((kind) => document.removeEventListener(kind, away));
  }, [isOpen]);
}

/** @param {{name: any, title?: string, kind?: string, rows: [string, () => void][], words?: string, opened?: () => void}} given  words: in place of rows where there are none */
export function Popup({ name, title, kind = "", rows, words = "", opened }) {
  const [isOpen, open] = useState(false);
  const place = useRef(/** @type {any} */ (null));
  useAway(place, isOpen, () => open(false));
  const press = () => {
    if (!isOpen) opened?.();
    open(!isOpen);
  };
  const take = (/** @type {() => void} */ act) => {
    open(false);
    act();
  };
  const hasList = rows.length > 0 || words !== "";
  return html`<span class="verdict" ref=${place}>
    <button class=${kind} title=${title} aria-expanded=${isOpen && hasList} disabled=${!hasList && !opened} onClick=${press}>${name}</button>
    ${isOpen && hasList && html`<div class="list">${rows.map(([text, act], k) => html`<button key=${k} onClick=${() => take(act)}>${text}</button>`)}${rows.length ? "" : words}</div>`}
  </span>`;
}

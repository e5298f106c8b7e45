// A motor or reducer: as entered, or from the catalogue as a table with figures and a filter.
import { html, useEffect, useRef, useState } from "./html.js";
import { commit } from "./journal.js";
import { products } from "./catalogue.js";
import { Wrong } from "./fields.js";
import * as s from "./state.js";

const COLUMNS = {
  motor: { rated_torque: "rated Nm", peak_torque: "peak Nm", max_speed: "rpm", inertia: "kg cm²" },
  reducer: { reduction: "ratio", efficiency: "η", peak_torque: "peak Nm", max_speed: "rpm" },
};
const figure = (value) => (typeof value === "number" ? Number(value.toPrecision(4)) : "");

export function Products({ path, kind }) {
  const [isOpen, open] = useState(false);
  const [filter, look] = useState("");
  const place = useRef(null);
  const value = s.get(s.data.value, path);
  const own = s.data.value.selection?.[`${kind}s`];
  const rows = Array.isArray(own) ? own : products.value[kind];
  const shown = rows.filter((row) => row.name.toLowerCase().includes(filter.toLowerCase()));
  useEffect(() => {
    if (isOpen) place.current.showModal();
  }, [isOpen]);
  const take = (name) => {
    open(false);
    if ((value ?? "") !== name) commit([{ path, value: name }]);
  };
  return html`<div class="sel"><span>${value || (kind === "motor" ? "as entered" : "as entered, or none")}</span>
      ${value && html`<button class="quiet" onClick=${() => take("")}>enter figures</button>`}
      <button class="quiet" onClick=${() => open(true)}>from the catalogue ▾</button></div><${Wrong} path=${path} />
    ${isOpen && html`<dialog ref=${place} onClose=${() => open(false)} aria-label=${`Choose a ${kind}`}>
      <h3>Choose a ${kind} <button class="quiet" aria-label="close" onClick=${() => open(false)}>×</button></h3>
      <input class="in words" aria-label="Filter" placeholder="filter by name" value=${filter} onInput=${(event) => look(event.target.value)} />
      <div class="scroll"><table><thead><tr><th scope="col">name</th>${Object.values(COLUMNS[kind]).map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
      <tbody>${shown.map((row) => html`<tr key=${row.name} class=${row.name === value ? "on" : ""}><td><button class="link" onClick=${() => take(row.name)}>${row.name}</button></td>
        ${Object.keys(COLUMNS[kind]).map((key) => html`<td class="number">${figure(row[key])}</td>`)}</tr>`)}</tbody></table></div>
    </dialog>`}`;
}

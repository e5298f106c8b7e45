// A motor or reducer: as entered, or from the catalogue as a table with figures, a filter, and what each would come to.
import { html, useEffect, useRef, useState } from "./html.js";
import { commit } from "./journal.js";
import { Field, Input, Wrong } from "./fields.js";
import { post } from "./server.js";
import * as s from "./state.js";

const COLUMNS = {
  motor: { rated_torque: "rated Nm", peak_torque: "peak Nm", max_speed: "rpm", inertia: "kg cm²" },
  reducer: { reduction: "ratio", efficiency: "η", max_torque: "peak Nm", max_speed: "rpm" },
};
const USES = { rms: "RMS", peak: "peak", speed: "speed" };
const FAILS = {
  yes: "can do it", reducer: "reducer too weak", speed: "too slow", peak: "peak too low", RMS: "RMS too low",
  large: "larger than needed", inertia: "inertia ratio",
};
const NAMES = { ratio: "reduction", peak_torque: "max_torque" }; // of a reducer's entries in the catalogue
const figure = (value) => (typeof value === "number" ? Number(value.toPrecision(4)) : "");
const share = (value) => (Number.isFinite(value) ? `${value < 10 ? (100 * value).toFixed(0) : "> 999"} %` : "–");
const sort = (value) => (value > 1 ? "bad" : value > 0.9 ? "warn" : "");

/** The products that may be chosen: those of the description, or those that come with motionbook. */
function rowsOf(kind) {
  const own = s.data.value.selection?.[`${kind}s`];
  return Array.isArray(own) ? own : s.products.value[kind];
}

/** An entry that does not count, as the catalogue's product in use has it. */
export function Unused({ entry, path, kind }) {
  const value = s.get(s.data.value, path);
  const product = rowsOf(kind).find((row) => row.name === s.get(s.data.value, [...path.slice(0, -1), "name"]));
  const own = product?.[kind === "reducer" ? (NAMES[entry.name] ?? entry.name) : entry.name];
  const isEntered = value !== undefined && value !== null;
  if (s.faults.value[s.keyOf(path)]) return html`<${Field} entry=${entry} path=${path} />`;
  if (!isEntered && (own === undefined || own === null)) return null;
  return html`<div class="f unused"><span>${entry.label}</span><output>${figure(own) || "–"} <em>${entry.unit}</em></output>
    ${isEntered && html`<small>entered ${figure(value)} ${entry.unit}, not used</small>`}</div>`;
}

/** The table of products. */
function Table({ kind, value, axis, take }) {
  const [filter, look] = useState("");
  const [isAll, showAll] = useState(true);
  const [uses, came] = useState(/** @type {any} */ (null));
  const text = s.text.value;
  useEffect(() => {
    let isLate = false;
    post("/products", { text, axis, kind }).then((given) => isLate || came(given), () => isLate || came({}));
    return () => {
      isLate = true;
    };
  }, [text]);
  const isFit = (row) => uses?.[row.name]?.verdict === "yes";
  const shown = rowsOf(kind).filter((row) => row.name.toLowerCase().includes(filter.toLowerCase()) && (isAll || isFit(row)));
  const has = uses && Object.keys(uses).length > 0;
  return html`<div class="look"><input class="in words" aria-label="Filter" placeholder="filter by name" value=${filter} onInput=${(event) => look(event.target.value)} />
      <label><input type="checkbox" checked=${!isAll} disabled=${!has} onChange=${() => showAll(!isAll)} /> only what can do it</label>
      <small role="status">${!uses ? "being worked out …" : has ? `what each comes to ${kind === "motor" ? "behind the reducer in use" : "with the motor in use"}` : "once the axis is complete, what each comes to stands here"}</small></div>
    <div class="scroll" tabindex="0" role="group" aria-label="Products"><table><thead><tr><th scope="col">name</th>${Object.values(COLUMNS[kind]).map((head) => html`<th scope="col">${head}</th>`)}
      ${has && html`${Object.values(USES).map((head) => html`<th scope="col">${head}</th>`)}<th scope="col">inertia ratio</th><th scope="col">verdict</th>`}</tr></thead>
    <tbody>${shown.map((row) => {
      const use = uses?.[row.name];
      return html`<tr key=${row.name} class=${row.name === value ? "on" : ""}><td><button class="link" onClick=${() => take(row.name)}>${row.name}</button></td>
        ${Object.keys(COLUMNS[kind]).map((key) => html`<td>${figure(row[key])}</td>`)}
        ${has && html`${Object.keys(USES).map((key) => html`<td class=${sort(use?.[key])}>${share(use?.[key])}</td>`)}<td>${figure(use?.inertia_ratio)}</td>
          <td class=${use?.verdict === "yes" ? "good" : "bad"}>${FAILS[use?.verdict] ?? ""}</td>`}</tr>`;
    })}</tbody></table></div>`;
}

/** A window over the page with a heading. */
function Window({ heading, close, children }) {
  const place = useRef(/** @type {any} */ (null));
  useEffect(() => place.current.showModal(), []);
  return html`<dialog ref=${place} onClose=${close} aria-label=${heading}>
    <h3>${heading} <button class="quiet" aria-label="close" onClick=${close}>×</button></h3>${children}</dialog>`;
}

/** The products that a design chooses among: those that come with motionbook, or its own as a table to be edited. */
export function Catalogue({ entry, path }) {
  const [isOpen, open] = useState(false);
  const kind = entry.name.slice(0, -1);
  const entered = s.get(s.data.value, path);
  const own = Array.isArray(entered) ? entered : null;
  const filled = (row) => Object.fromEntries(Object.entries(row).filter(([, value]) => value !== null));
  const does = (k, words, sign) => html`<button class="quiet" aria-label=${`${words} ${kind} ${k + 1}`} onClick=${() => commit([{ path: [...path, k], do: words }])}>${sign}</button>`;
  return html`<div class="sel"><span>${own ? `${own.length} of its own` : `${s.products.value[kind].length} that come with motionbook`}</span>
      <button class="quiet" onClick=${() => open(true)}>own catalogue ▾</button></div><${Wrong} path=${path} />
    ${isOpen && html`<${Window} heading=${`${entry.name[0].toUpperCase()}${entry.name.slice(1)} to choose among`} close=${() => open(false)}>
      ${own && html`<div class="scroll"><table class="own"><thead><tr>${entry.rows.map((row) => html`<th scope="col" title=${row.label}>${row.name.replaceAll("_", " ")}${row.unit && html`<br />${row.unit}`}</th>`)}<td></td></tr></thead>
        <tbody>${own.map((_, k) => html`<tr key=${k}>${entry.rows.map((row) => html`<td key=${row.name}><${Input} entry=${{ ...row, unit: "", options: [] }} path=${[...path, k, row.name]} label=${`${kind} ${k + 1}, ${row.label}`} />
          <${Wrong} path=${[...path, k, row.name]} /></td>`)}<td>${does(k, "copy", "❐")}${own.length > 1 && does(k, "remove", "×")}</td></tr>`)}</tbody></table></div>`}
      <button class="add" onClick=${() => commit([{ path, do: "add" }])}>+ ${kind}</button>
      ${own ? html`<button class="add" onClick=${() => commit([{ path, do: "remove" }])}>back to those that come with motionbook</button>`
        : html`<button class="add" onClick=${() => commit([{ path, value: s.products.value[kind].map(filled) }])}>begin with those that come with motionbook</button>`}<//>`}`;
}

export function Products({ path, kind }) {
  const [isOpen, open] = useState(false);
  const value = s.get(s.data.value, path);
  const take = (name) => {
    open(false);
    if ((value ?? "") !== name) commit([{ path, value: name }]);
  };
  return html`<div class="sel"><span>${value || (kind === "motor" ? "as entered" : "as entered, or none")}</span>
      ${value && html`<button class="quiet" onClick=${() => take("")}>enter figures</button>`}
      <button class="quiet" data-path=${s.keyOf(path)} data-picked=${s.isPicked(s.keyOf(path))} aria-label=${`${kind} from the catalogue`} onClick=${() => open(true)}>from the catalogue ▾</button></div><${Wrong} path=${path} />
    ${isOpen && html`<${Window} heading=${`Choose a ${kind}`} close=${() => open(false)}><${Table} kind=${kind} value=${value} axis=${path[1]} take=${take} /><//>`}`;
}

// The right side: the entries of the chosen axis, or of another part of the machine.
import { html, useState } from "./html.js";
import { Choice, Field, Input, Wrong } from "./fields.js";
import { commit } from "./journal.js";
import { LawChoice } from "./laws.js";
import { pick } from "./picking.js";
import { Catalogue, Products, Unused } from "./products.js";
import * as s from "./state.js";

const MAIN = {
  "": ["title"], master: ["rate"], load: ["mass", "friction", "slope", "force", "inertia", "torque", "friction_torque"],
  motor: ["name", "inertia", "rated_torque", "peak_torque", "max_speed"], reducer: ["name", "ratio", "efficiency"],
  power: ["efficiency", "hours"], clearances: ["offset", "least", "first_factor", "second_factor"],
  selection: ["motors", "reducers", "rank", "axis"],
};
const BESIDE = ["name", "holding", "temperature", "limit", "rated_at", "copper_losses"]; // count beside a product's own
const TURNS = ["inertia", "torque", "friction_torque"];
const ORDER = ["phases", "mechanism", "load", "reducer", "motor"];
const TITLES = { "": "Machine", master: "Cycle", arm: "Swinging arm", stops: "Hard stops", axes: "Axis" };
const HEADS = { start: "from", stop: "to", lift: "lift", law: "law" };
const DRIVE = ["mechanism", "load", "reducer", "motor", "limits", "brake", "arm"];

const title = (path) => {
  const name = path.filter((part) => typeof part === "string").at(-1) ?? "";
  return TITLES[name] ?? name[0].toUpperCase() + name.slice(1).replaceAll("_", " ");
};
const isSet = (value) => value !== undefined && value !== null;

/** The sections of the schema for a place: of several kinds those of the kind that is there. */
function sectionsAt(pattern, kind) {
  return s.schema.value.filter((each) => each.path === pattern && (!each.kind || each.kind === kind));
}

/** What may stand here of a load: what turns, or what travels. */
function suits(entry, path, axis) {
  if (path.at(-1) !== "load" || !axis) return true;
  const slides = ["press crank"].includes(axis.mechanism?.kind);
  const turns = axis.unit === "°" && !slides;
  if (TURNS.includes(entry.name)) return turns;
  return turns ? !["mass", "friction", "slope", "force"].includes(entry.name) : true;
}

/** The rows of a list of an entry, such as the phases of an axis; rows of many entries each as fields. */
function Rows({ entry, path }) {
  const [isOpen, open] = useState(false);
  if (path[0] === "selection") return html`<${Catalogue} entry=${entry} path=${path} />`;
  const rows = s.get(s.data.value, path) ?? [];
  const isPhases = path.at(-1) === "phases";
  if (typeof rows === "string" || (rows.length && typeof rows[0] !== "object"))
    return html`<div class="rows"><${Field} entry=${{ ...entry, options: [], default: "" }} path=${path} /></div>`;
  const one = isPhases ? "phase" : entry.name.replace(/s$/, "");
  const isTable = isPhases || entry.rows.length < 5;
  const seldom = (row) => isPhases && !row.required && !HEADS[row.name];
  const columns = entry.rows.filter((row) => !seldom(row) || isOpen || rows.some((each) => isSet(each?.[row.name])));
  if (isPhases) columns.sort((a, b) => Object.keys(HEADS).indexOf(a.name) - Object.keys(HEADS).indexOf(b.name));
  const at = (k, row) => [...path, k, Array.isArray(rows[k]) ? entry.rows.findIndex((each) => each.name === row.name) : row.name];
  const does = (k) => html`<button title=${`copy ${one} ${k + 1}`} aria-label=${`copy ${one} ${k + 1}`}
      onClick=${() => commit([{ path: [...path, k], do: "copy" }])}>❐</button>
    ${(!entry.required || rows.length > 1) && html`<button title=${`remove ${one} ${k + 1}`} aria-label=${`remove ${one} ${k + 1}`}
      onClick=${() => commit([{ path: [...path, k], do: "remove" }])}>×</button>`}`;
  const cell = (row) => (row.name === "law" ? LawChoice : row.options.length && !row.expected.startsWith("a text") ? Choice : Input);
  const list = isTable
    ? rows.length > 0 && html`<table class="rows"><thead><tr>${columns.map((row) => html`<th scope="col" title=${row.label}>${HEADS[row.name] ?? row.name.replaceAll("_", " ")}</th>`)}<td></td></tr></thead>
    <tbody>${rows.map((_, k) => html`<tr key=${k} class=${isPhases && s.selected.value.phase === k ? "on" : ""}
        onFocusIn=${() => isPhases && choosePhase(k)}>
      ${columns.map((row) => html`<td key=${row.name}><${cell(row)} entry=${row} path=${at(k, row)} label=${`${one} ${k + 1}, ${HEADS[row.name] ?? row.label}`} /></td>`)}
      <td class="do">${does(k)}</td></tr>
      <tr key=${`wrong ${k}`} class="under"><td colspan=${columns.length + 1}>
        ${columns.map((row) => html`<${Wrong} path=${at(k, row)} />`)}<${Wrong} path=${[...path, k]} /></td></tr>`)}</tbody></table>`
    : rows.map((row, k) => html`<div class="block" key=${k}><b>${row?.name ?? `${one} ${k + 1}`}</b><span class="do">${does(k)}</span>
        <${Fields} keys=${entry.rows} path=${[...path, k]} main=${[]} label=${`${one} ${k + 1}, `} /><${Wrong} path=${[...path, k]} /></div>`);
  return html`${list}<${Wrong} path=${path} />
    <button class="add" onClick=${() => commit([{ path, do: "add" }])}>+ ${one}</button>
    ${isPhases && html`<button class="add more" aria-expanded=${isOpen} onClick=${() => open(!isOpen)}>${isOpen ? "less" : "more"} …</button>`}`;
}

const choosePhase = (phase) => {
  if (s.selected.value.phase !== phase) s.selected.value = { ...s.selected.value, phase };
};

/** Fields of entries: those that are needed or entered, the others under “more”. */
function Fields({ keys, path, main, label = "", kind = "" }) {
  const [isOpen, open] = useState(false);
  const entries = s.get(s.data.value, path);
  const isNamed = ["motor", "reducer"].includes(kind) && entries?.name;
  const isFirst = (entry) => entry.required || main.includes(entry.name) || isSet(entries?.[entry.name]) || s.faults.value[s.keyOf([...path, entry.name])] || s.keyOf([...path, entry.name]) === s.sought.value;
  const field = (entry) => html`<${isNamed && !BESIDE.includes(entry.name) ? Unused : Field} key=${entry.name} entry=${entry}
    path=${[...path, entry.name]} kind=${kind} label=${label && `${label}${entry.label}`} />`;
  const single = keys.filter((entry) => !entry.rows.length);
  const rest = keys.filter((entry) => !isFirst(entry));
  const lists = keys.filter((entry) => entry.rows.length && (isOpen || isFirst(entry)));
  return html`${single.filter(isFirst).map(field)}
    ${rest.length > 0 && html`<button class="add more" aria-expanded=${isOpen} onClick=${() => open(!isOpen)}>${isOpen ? "less" : "more"} …</button>`}
    ${isOpen && single.filter((entry) => !isFirst(entry)).map(field)}
    ${lists.map((entry) => html`<h4 key=${entry.name} title=${entry.label}>${entry.name.replaceAll("_", " ")}</h4>
      <${Rows} entry=${entry} path=${[...path, entry.name]} />`)}`;
}

/** A table of entries with its heading. */
function Table({ path, pattern, of }) {
  const entries = s.get(s.data.value, path);
  const axis = path[0] === "axes" ? s.data.value.axes?.[path[1]] : null;
  const keys = sectionsAt(pattern, entries?.kind).flatMap((each) => each.keys).filter((entry) => suits(entry, path, axis));
  const name = of ?? path.filter((part) => typeof part === "string").at(-1) ?? "";
  const isProduct = ["motor", "reducer"].includes(name);
  const elsewhere = ["template", "kind", ...(isProduct ? ["name"] : []), ...(of === "axes" ? ["phases"] : [])];
  const kind = keys.find((entry) => entry.name === "kind");
  return html`<section>
    <h3>${title(path)} ${path.length > 2 && isSet(entries) && html`<button class="quiet" aria-label=${`remove ${name}`}
      onClick=${() => commit([{ path, do: "remove" }])}>×</button>`}</h3>
    ${kind && html`<${Choice} entry=${kind} path=${[...path, "kind"]} />`}
    ${isProduct && html`<${Products} path=${[...path, "name"]} kind=${name} />`}
    <${Fields} keys=${keys.filter((entry) => !elsewhere.includes(entry.name))} path=${path} main=${MAIN[name] ?? []} kind=${name} />
    <${Wrong} path=${path} />
  </section>`;
}

/** The tables of an axis: its phases first, then its drive, then itself. */
function Axis({ index }) {
  const axis = s.data.value.axes?.[index];
  if (!axis) return null;
  const own = s.schema.value.find((each) => each.path === "axes.*");
  const below = [...new Set(s.schema.value.map((each) => each.path))].filter((each) => each.startsWith("axes.*."));
  const names = below.map((each) => each.split(".").slice(2));
  const there = names.filter((name) => isSet(s.get(axis, name)));
  const absent = names.filter((name) => !isSet(s.get(axis, name)) && (name.length === 1 || isSet(s.get(axis, name.slice(0, -1)))));
  const driven = isSet(axis.mechanism);
  const add = absent.filter((name) => (driven || !DRIVE.includes(name[0])) && (name[1] !== "arm" || axis.unit === "°"));
  const missing = absent.flatMap((name) => Object.entries(s.faults.value)
    .filter(([key]) => `${key}.`.startsWith(`${s.keyOf(["axes", index, ...name])}.`)).map(([, line]) => `${title(name)}: ${line}`));
  there.sort((a, b) => (ORDER.indexOf(a[0]) + 99) % 99 - ((ORDER.indexOf(b[0]) + 99) % 99));
  return html`<h2>${axis.name || `axis ${index + 1}`} <small>${axis.group}</small>
      <span class="do"><button onClick=${() => commit([{ path: ["axes", index], do: "copy" }])}>copy</button>
      ${s.data.value.axes.length > 1 && html`<button onClick=${() => commit([{ path: ["axes", index], do: "remove" }])}>delete</button>`}</span></h2>
    <${Wrong} path=${["axes", index]} />
    <section><h3>Phases <small>${[...new Set([s.period.value.unit, axis.unit ?? "mm"])].join(" and ")}</small></h3>
      <${Rows} entry=${own.keys.find((each) => each.name === "phases")} path=${["axes", index, "phases"]} /></section>
    ${!driven && html`<button class="add" onClick=${() => commit([{ path: ["axes", index, "drive"], do: "add" }])}>+ mechanism and motor</button>`}
    ${[...new Set(missing)].map((words) => html`<small class="wrong" role="alert" key=${words}>${words}</small>`)}
    ${there.map((name) => html`<${Table} key=${name.join(".")} path=${["axes", index, ...name]} pattern=${`axes.*.${name.join(".")}`} />`)}
    <${Table} path=${["axes", index]} pattern="axes.*" of="axes" />
    <p class="adds">${add.map((name) => html`<button class="add" key=${name.join(".")}
      onClick=${() => commit([{ path: ["axes", index, ...name], do: "add" }])}>+ ${title(name).toLowerCase()}</button> `)}</p>`;
}

/** Another part: a row of a table, or all tables below a name; the machine itself. */
function Part({ path }) {
  const patterns = path.length ? [...new Set(s.schema.value.map((each) => each.path))].filter((each) => {
    const own = path.map((part) => (typeof part === "number" ? "*" : part)).join(".");
    return each === own || each.startsWith(`${own}.`);
  }) : ["", "master", "power", "limits"];
  const isRow = typeof path[1] === "number";
  const known = new Set(s.schema.value.map((each) => each.path));
  const row = s.get(s.data.value, path);
  return html`<h2>${row?.name ?? (path.length ? title(path) : s.data.value.title)}
      ${isRow && html`<span class="do"><button onClick=${() => commit([{ path, do: "copy" }])}>copy</button>
      <button onClick=${() => remove(path)}>delete</button></span>`}</h2>
    ${patterns.filter((each) => known.has(each)).map((each) => {
      const place = each === "" ? [] : each.split(".").map((part, k) => (part === "*" ? path[k] : part));
      return html`<${Table} key=${each} path=${place} pattern=${each} />`;
    })}`;
}

function remove(path) {
  s.selected.value = { ...s.selected.value, part: null };
  return commit([{ path, do: "remove" }]);
}

export function Entries() {
  const { axis, part } = s.selected.value;
  return html`<aside aria-label="Entries" class=${s.picked.value ? "picking" : ""}
    onMouseDownCapture=${pick} onClickCapture=${pick} onKeyDownCapture=${pick} key=${JSON.stringify([axis, part])}>${part ? html`<${Part} path=${part} />` : html`<${Axis} index=${axis} />`}</aside>`;
}

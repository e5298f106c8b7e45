// The left side: axes with the use of their motors, what is between them, switches, the machine.
import { html, useEffect, useRef } from "./html.js";
import { short } from "./colors.js";
import { commit } from "./journal.js";
import * as s from "./state.js";

const sort = (use) => (use.value > 1 ? "bad" : use.value > 0.9 ? "warn" : "good");
const share = (value) => `${(100 * value).toFixed(0)} %`;

function Use({ use, before }) {
  const was = before && share(before.value) !== share(use.value) ? share(before.value) : null;
  return html`<span class="use" title=${`${use.label}: ${use.is}${was ? `; saved: ${was}` : ""}`}>${use.label}
    <span class="bar"><i class=${sort(use)} style=${{ width: `${Math.min(100, 100 * use.value)}%` }}></i></span>
    <b class=${sort(use)}>${was && html`<small>${was} → </small>`}${share(use.value)}</b></span>`;
}

const about = (axis) => {
  const { kind, ...sizes } = axis.mechanism ?? {};
  const size = Object.entries(sizes).find(([name, value]) => typeof value === "number" && !name.includes("efficiency"));
  return kind ? `${kind}${size ? `, ${size[0].split("_")[0]} ${size[1]} mm` : ""}` : null;
};

function Card({ index }) {
  const axis = s.data.value.axes[index];
  const own = s.figures.value.axes[index];
  const isOn = !s.selected.value.part && s.selected.value.axis === index;
  const place = useRef(/** @type {any} */ (null));
  useEffect(() => {
    if (isOn) place.current.scrollIntoView({ block: "nearest" });
  }, [isOn]);
  const choose = () => choosePart({ axis: index, phase: null, part: null });
  return html`<button ref=${place} class=${`card ${isOn ? "on" : ""} ${own?.stale ? "stale" : ""}`} aria-pressed=${isOn} onClick=${choose}>
    <span class=${`dot axis-${index % 6}`}></span><span class="cn">${axis.name || `axis ${index + 1}`}<small>${axis.group}</small></span>
    <span class="mech">${about(axis) ?? html`no drive yet`}</span>
    ${own?.error && html`<span class="wrong">${own.error}</span>`}
    ${(own?.use ?? []).slice(0, 6).filter((use, k) => k < 3 || use.value > 0.8).map((use) => html`<${Use} key=${use.key} use=${use}
      before=${s.saved.value.axes[index]?.use?.find((each) => each.key === use.key)} />`)}
  </button>`;
}

export function choosePart(choice) {
  s.selected.value = { ...s.selected.value, ...choice };
}

/** Show an entry by its key, or the axis, switch or clearance that words name. @param {string|null|undefined} at */
export function goTo(at) {
  if (!at) return;
  const [first, row] = at.split(".");
  const tables = s.schema.value.map((each) => each.path.split(".")[0]);
  const isOwn = s.schema.value.some((each) => each.path === "" && each.keys.some((entry) => entry.name === first));
  if (!first || !(isOwn || tables.includes(first))) {
    const rows = LISTS.flatMap((list) => (s.data.value[list] ?? []).map(({ name }, k) => ({ name, key: `${list}.${k}` })));
    const [named] = rows.filter(({ name }) => name && at.includes(name)).sort((a, b) => b.name.length - a.name.length);
    return goTo(named?.key);
  }
  s.sought.value = at;
  if (first === "axes") choosePart({ axis: Number(row), phase: null, part: null });
  else choosePart({ part: /^\d+$/.test(row ?? "") ? [first, Number(row)] : isOwn || OF_MACHINE.includes(first) ? [] : [first, ...(first === "laws" ? [row] : [])] });
  requestAnimationFrame(() => /** @type {HTMLElement} */ (document.querySelector(`aside [data-path="${CSS.escape(at)}"]`))?.focus());
}

function Item({ part, words, note }) {
  const isOn = JSON.stringify(s.selected.value.part) === JSON.stringify(part);
  const isWrong = Object.keys(s.faults.value).some((key) => `${key}.`.startsWith(`${s.keyOf(part)}.`));
  return html`<button class=${`item ${isOn ? "on" : ""} ${isWrong ? "wrong" : ""}`} aria-pressed=${isOn} onClick=${() => choosePart({ part })}>
    <span>${words}</span><span>${isWrong ? "!" : note}</span></button>`;
}

const time = (on) => (Array.isArray(on) ? on : [on?.start, on?.stop]).join("–");
const LISTS = ["axes", "switches", "clearances"];
const OF_MACHINE = ["master", "power", "limits"];

export function Cards() {
  const tree = s.data.value;
  const add = (name) => async () => {
    const rows = tree[name]?.length ?? 0;
    await commit([{ path: [name], do: "add" }]);
    if ((s.data.value[name]?.length ?? 0) > rows) choosePart(name === "axes" ? { axis: rows, phase: null, part: null } : { part: [name, rows] });
  };
  const known = new Set(s.schema.value.map((each) => each.path.split(".")[0]));
  const others = [...known].filter((name) => name && !LISTS.includes(name) && ![...OF_MACHINE, "laws"].includes(name));
  const family = (name, title, note) => known.has(name) && html`<h2>${title}</h2>
    ${(tree[name] ?? []).map((row, k) => html`<${Item} key=${k} part=${[name, k]} words=${row.name || `${title} ${k + 1}`} note=${note(row, k)} />`)}
    <button class="add" onClick=${add(name)}>+ ${name === "switches" ? "switch" : name.slice(0, -1)}</button>`;
  return html`<nav aria-label="Parts of the machine">
    ${s.live.value && known.has("axes") && html`<h2>Axes</h2>${(tree.axes ?? []).map((_, k) => html`<${Card} key=${k} index=${k} />`)}
      <button class="add" onClick=${add("axes")}>+ axis</button>`}
    ${family("clearances", "Between axes", (row, k) => {
      const gap = s.figures.value.gaps[k];
      return `${gap ? `${short(gap.least)} ${gap.unit} ` : ""}≥ ${row.least ?? 0}`;
    })}
    ${family("switches", "Switches", (row) => (row.on ?? []).map(time).join(", "))}
    <h2>Machine</h2>
    <${Item} part=${[]} words="Cycle, power, limits" note=${tree.power?.efficiency ? `η ${tree.power.efficiency}` : ""} />
    ${others.map((name) => html`<${Item} key=${name} part=${[name]} words=${name[0].toUpperCase() + name.slice(1).replaceAll("_", " ")}
      note=${typeof tree[name]?.axis === "string" ? tree[name].axis : ""} />`)}
    ${Object.keys(tree.laws ?? {}).map((name) => html`<${Item} key=${name} part=${["laws", name]} words=${`Law ${name}`} note=${tree.laws[name].family ?? ""} />`)}
  </nav>`;
}

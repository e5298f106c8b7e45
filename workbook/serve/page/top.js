// The top: what the machine comes to, the verdict, undo, save and what else is done with a design.
import { html } from "./html.js";
import { Input } from "./fields.js";
import { redo, undo } from "./journal.js";
import { goTo } from "./cards.js";
import { Gains } from "./gains.js";
import { Popup } from "./popup.js";
import { build } from "./book.js";
import { save } from "./save.js";
import * as s from "./state.js";

const figure = (value, digits = 4) => (typeof value === "number" ? Number(value.toPrecision(digits)).toLocaleString("en", { useGrouping: true, maximumFractionDigits: 6 }) : "–");

function Figure({ title, value, unit, note, before }) {
  const was = before !== undefined && before !== null && figure(before) !== figure(value) ? figure(before) : null;
  return html`<div class="kpi"><small>${title}</small><b>${figure(value)}<em>${unit}</em>${was && html`<em>was ${was}</em>`}</b><em class="note">${note}</em></div>`;
}

function Verdict() {
  const given = s.verdict.value;
  if (!given) return html`<span class="pill wait">judging …</span>`;
  const { checks, number } = given;
  const words = { OK: `${number} checks OK`, FAIL: `${checks.length} of ${number} checks FAIL`, unfinished: `${checks.length || 1} to complete`, unknown: "no verdict" };
  const rows = checks.map(({ path, sentence }) => [sentence, () => goTo(path?.join(".") ?? sentence)]);
  return html`<${Popup} name=${words[given.verdict]} kind=${`pill ${given.verdict}`} rows=${rows} />`;
}

export function Top() {
  const { name, target } = s.file.value;
  const { machine } = s.figures.value;
  const before = s.saved.value.machine;
  const master = s.schema.value.find((each) => each.path === "master");
  const entry = master?.keys.find((each) => each.name === (s.data.value.master?.cycle ? "cycle" : "rate"));
  const link = encodeURIComponent(name);
  return html`<header>
    <a class="brand" href="/">motionbook</a>
    <h1 class="file" title=${s.data.value.title}>${s.data.value.title}<small>${target} · ${s.isChanged.value ? "not saved" : "saved"}</small></h1>
    ${entry && html`<div class="kpi"><small>${entry.name === "rate" ? "Production rate" : "Length of a cycle"}</small><${Input} entry=${{ ...entry, default: "" }} path=${["master", entry.name]} /></div>`}
    ${machine?.highest && html`<${Figure} title="Highest rate" value=${machine.highest.value} note=${machine.highest.reason} before=${before?.highest?.value} /><${Gains} />`}
    ${typeof machine?.peak_power === "number" && html`<${Figure} title="Peak power" value=${machine.peak_power} unit="kW" before=${before?.peak_power} />`}
    <${Verdict} />
    <span class="sp"></span>
    <button class="icon" title="Undo (Ctrl+Z)" aria-label="Undo" disabled=${!s.steps.value.undo} onClick=${undo}>↶</button>
    <button class="icon" title="Redo (Ctrl+Y)" aria-label="Redo" disabled=${!s.steps.value.redo} onClick=${redo}>↷</button>
    <button title="Choose the entries that a study varies" onClick=${() => (s.picked.value ??= {})}>Study</button>
    <a class="button" href=${`/print/${link}`}>Print</a>
    <button title="Save (Ctrl+S)" onClick=${() => save()}>Save</button>
    <button class="main" onClick=${build}>Build workbook</button>
  </header>`;
}

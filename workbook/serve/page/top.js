// The top: what the machine comes to, the verdict, undo, save and what else is done with a design.
import { html, useState } from "./html.js";
import { Input } from "./fields.js";
import { redo, undo } from "./journal.js";
import { goTo } from "./cards.js";
import { Gains } from "./gains.js";
import { build, save } from "./save.js";
import * as s from "./state.js";

const figure = (value, digits = 4) => (typeof value === "number" ? Number(value.toPrecision(digits)).toLocaleString("en", { useGrouping: true, maximumFractionDigits: 6 }) : "–");

function Figure({ title, value, unit, note, before }) {
  const was = before !== undefined && before !== null && figure(before) !== figure(value) ? figure(before) : null;
  return html`<div class="kpi"><small>${title}</small><b>${figure(value)}<em>${unit}</em>${was && html`<em>was ${was}</em>`}</b><em class="note">${note}</em></div>`;
}

function Verdict() {
  const [isOpen, open] = useState(false);
  const given = s.verdict.value;
  if (!given) return html`<span class="pill wait">judging …</span>`;
  const { checks, number } = given;
  const words = { OK: `${number} checks OK`, FAIL: `${checks.length} of ${number} checks FAIL`, unfinished: `${checks.length || 1} to complete`, unknown: "no verdict" };
  const go = ({ path, sentence }) => {
    open(false);
    goTo(path?.join(".") ?? sentence);
  };
  return html`<span class="verdict"><button class=${`pill ${given.verdict}`} aria-expanded=${isOpen} disabled=${!checks.length} onClick=${() => open(!isOpen)}>${words[given.verdict]}</button>
    ${isOpen && html`<div class="list">${checks.map((each, k) => html`<button key=${k} onClick=${() => go(each)}>${each.sentence}</button>`)}</div>`}</span>`;
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
    <a class="button" href=${`/vary/${link}`}>Study</a>
    <a class="button" href=${`/print/${link}`}>Print</a>
    <button title="Save (Ctrl+S)" onClick=${() => save()}>Save</button>
    <button class="main" onClick=${build}>Build workbook</button>
  </header>`;
}

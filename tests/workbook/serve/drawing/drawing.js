// The drawing parts of the page over a fixture: what they propose is entered, as the journal would.
import { html, render, signal } from "/workbook/serve/page/html.js";
import { AxisCharts } from "/workbook/serve/page/charts.js";
import { changed } from "/workbook/serve/page/pieces.js";
import { TimingDiagram } from "/workbook/serve/page/timing.js";

const fixture = await (await fetch(`fixture.json${location.search}`)).json();
const design = signal(fixture.design);
const figures = signal(fixture.figures);
const [selected, cursor, chosen] = [signal({ axis: 1, phase: 0 }), signal(null), signal("both")];
window.state = { design, figures, selected, cursor, chosen, commits: [], proposals: 0 };

function propose(changes, commit) {
  window.state.proposals += 1;
  if (!commit) return;
  window.state.commits.push(changes);
  design.value = changed(design.value, changes);
}

function Page() {
  const axis = design.value.axes.find(({ index }) => index === selected.value.axis);
  const saved = { design: fixture.design, figures: fixture.saved };
  return html`<${TimingDiagram} ...${{ design, figures, saved, selected, cursor, propose }} />
    <${AxisCharts} ...${{ axis, figures, saved: fixture.saved, cursor, chosen }} />`;
}
render(html`<${Page} />`, document.getElementById("page"));

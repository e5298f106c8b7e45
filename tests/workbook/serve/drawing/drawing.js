// The drawing parts of the page over a fixture: what they propose is entered, as the journal would.
import { html, render, signal } from "/workbook/serve/page/html.js";
import { AxisCharts } from "/workbook/serve/page/charts.js";
import { put } from "/workbook/serve/page/state.js";
import { TimingDiagram } from "/workbook/serve/page/timing.js";

const fixture = await (await fetch(`fixture.json${location.search}`)).json();
const [data, figures, saved] = [fixture.data, fixture.figures, fixture.saved].map((given) => signal(given));
const [selected, cursor, chosen] = [signal({ axis: 1, phase: 0 }), signal(null), signal("both")];
window.state = { data, figures, selected, cursor, chosen, commits: [], proposals: 0 };

function propose(changes, commit) {
  window.state.proposals += 1;
  if (!commit) return;
  window.state.commits.push(changes);
  data.value = changes.reduce((tree, { path, value }) => put(tree, path, value), data.value);
}

function Page() {
  const index = selected.value.axis;
  return html`<${TimingDiagram} ...${{ data, figures, saved, selected, cursor, propose }} />
    <${AxisCharts} ...${{ index, axis: data.value.axes[index], figures, saved, cursor, chosen }} />`;
}
render(html`<${Page} />`, document.getElementById("page"));

// A clearance in the timing diagram: its gap where the axes come near, the least that is asked for, and where it is least.
import { html } from "./html.js";
import { short } from "./colors.js";
import { space } from "./timing_drag.js";
import { clipped, pathOf } from "./timing_lane.js";

/** @param {{place: any, layout: any, period: any}} given */
export function Gap({ place, layout, period }) {
  const { row, y, height, toY } = place;
  const gap = row.item;
  const need = toY(gap.need);
  const words = `${short(gap.least)} ${gap.ok ? "≥" : "<"} ${short(gap.need)}${space(gap.unit)}`;
  return html`<g class=${`gap ${gap.ok ? "" : "bad"} ${gap.stale ? "stale" : ""}`}>
    <title>${`${row.name}: the gap over the cycle; least ${short(gap.least)}${space(gap.unit)}, at ${short(gap.at)}${space(period.unit)}`}</title>
    <text class="name" x="8" y=${y + height / 2 - 3}>${clipped(row.name, 88)}</text>
    <text class="least" x="8" y=${y + height / 2 + 13}>${words}</text>
    <rect class="close" x=${layout.left} y=${need} width=${layout.right - layout.left} height=${Math.max(y + height - need, 0)} />
    <path class="need" d=${`M${layout.left} ${need}H${layout.right}`} />
    <path class="line" d=${pathOf(place, layout.x)} />
    <circle cx=${layout.x(gap.at)} cy=${toY(gap.least)} r="4" />
  </g>`;
}

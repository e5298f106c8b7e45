// What is drawn into a chart: its line, the saved one, limits, points.
import { limitsOf } from "./chart_scales.js";
import { colorAt } from "./colors.js";

const LINE = 15; // px that a line of text takes
export const FONT = '12px Inter, "Segoe UI", system-ui, "DejaVu Sans", sans-serif';

/** @param {any} plot @param {number[]} xs @param {number[]} ys @param {string} color @param {number[]} dash @param {number} width */
function draw(plot, xs, ys, color, dash = [], width = 2) {
  const { ctx } = plot;
  const ratio = devicePixelRatio;
  ctx.beginPath();
  xs.forEach((x, n) => ctx.lineTo(plot.valToPos(x, "x", true), plot.valToPos(ys[n], "y", true)));
  ctx.strokeStyle = color;
  ctx.lineWidth = width * ratio;
  ctx.lineJoin = "round";
  ctx.setLineDash(dash.map((part) => part * ratio));
  ctx.stroke();
  ctx.setLineDash([]);
}

/**
 * Writes into a chart, each text at the first of some places, [x, bottom, whether it ends there], where it covers no other; without room nowhere.
 * @param {any} plot @returns {(text: string, color: string, places: [number, number, boolean?][]) => void}
 */
function writer({ ctx, bbox, root }) {
  /** @type {{left: number, right: number, bottom: number}[]} */
  const taken = [];
  const line = LINE * devicePixelRatio;
  return (text, color, places) => {
    ctx.font = FONT.replace("12px", `${12 * devicePixelRatio}px`);
    const wide = ctx.measureText(text).width;
    for (const [x, bottom, isEnd] of places) {
      const [left, right] = isEnd ? [x - wide, x] : [x, x + wide];
      const isInside = left >= bbox.left && right <= bbox.left + bbox.width && bottom - line >= bbox.top && bottom <= bbox.top + bbox.height;
      if (!isInside || taken.some((each) => left < each.right && right > each.left && Math.abs(bottom - each.bottom) < line)) continue;
      taken.push({ left, right, bottom });
      Object.assign(ctx, { textAlign: "left", textBaseline: "bottom", lineWidth: 3 * devicePixelRatio, strokeStyle: colorAt(root, "--paper"), fillStyle: color });
      ctx.strokeText(text, left, bottom);
      ctx.fillText(text, left, bottom);
      return;
    }
  };
}

/** Limits as dashed lines with their names; those far beyond the data as words in the corner. @param {any} plot @param {any} chart @param {any} write */
function drawLimits(plot, chart, write) {
  const { x, y } = plot.scales;
  const [gap, line] = [4 * devicePixelRatio, LINE * devicePixelRatio];
  const [left, right] = [plot.bbox.left + gap, plot.bbox.left + plot.bbox.width - gap];
  const rows = Array.from({ length: Math.floor(plot.bbox.height / line) }, (_, k) => plot.bbox.top + (k + 1) * line);
  for (const { limit, isAcross, isFar, name } of limitsOf(chart)) {
    const color = colorAt(plot.root, limit.kind === "continuous" ? "--soft" : "--limit");
    if (isFar) {
      write(`↑ ${name}`, color, rows.map((row) => [right, row, true]));
      continue;
    }
    const along = limit.x ?? (isAcross ? [limit.value, limit.value] : [x.min, x.max]);
    const values = limit.y ?? (isAcross ? [y.min, y.max] : [limit.value, limit.value]);
    draw(plot, along, values, color, [5, 4], 1.25);
    const [begin, end] = [values[0], values[values.length - 1]].map((value) => plot.valToPos(value, "y", true));
    if (isAcross) write(name, color, rows.reverse().map((row) => [plot.valToPos(limit.value, "x", true) - gap, row, true]));
    else if (name) write(name, color, [[right, end - 1, true], [left, begin - 1], [right, end + line, true], [left, begin + line]]);
  }
}

/** All lines of a chart, over the grid; the names of its points first, then those of limits. @param {any} plot @param {{chart: any, saved: any}} shown */
export function drawAll(plot, { chart, saved }) {
  const { ctx, bbox, scales } = plot;
  const [write, ink, gap] = [writer(plot), colorAt(plot.root, "--ink"), 6 * devicePixelRatio];
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw(plot, [scales.x.min, scales.x.max], [0, 0], colorAt(plot.root, "--rule"), [], 1);
  if (saved) draw(plot, saved.x, saved.y, colorAt(plot.root, "--soft"), [4, 3], 1.25);
  draw(plot, chart.x, chart.y, colorAt(plot.root, "--color"));
  for (const { x, y, label } of chart.points ?? []) {
    const [left, top] = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)];
    ctx.beginPath();
    ctx.arc(left, top, 4 * devicePixelRatio, 0, 7);
    ctx.fillStyle = ink;
    ctx.fill();
    write(label, ink, [3 * gap, 0].flatMap((low) => [[left + gap, top + low], [left - gap, top + low, true]]));
  }
  drawLimits(plot, chart, write);
  ctx.restore();
}

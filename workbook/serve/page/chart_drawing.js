// What is drawn into a chart: its line, the saved one, limits, points.
import { isOverCycle, limitsOf } from "./chart_scales.js";
import { colorAt } from "./colors.js";

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

/** @param {any} plot @param {string} text @param {number} x @param {number} y in canvas points @param {string} color @param {CanvasTextAlign} align */
function write(plot, text, x, y, color, align) {
  const { ctx } = plot;
  ctx.font = FONT.replace("12px", `${12 * devicePixelRatio}px`);
  ctx.textAlign = align;
  ctx.textBaseline = "bottom";
  ctx.lineWidth = 3 * devicePixelRatio;
  ctx.strokeStyle = colorAt(plot.root, "--paper");
  ctx.strokeText(text, x, y);
  ctx.fillStyle = color;
  ctx.fillText(text, x, y);
}

/** Limits as dashed lines with their names; those far beyond the data as words in the corner. @param {any} plot @param {any} chart */
function drawLimits(plot, chart) {
  const { x, y } = plot.scales;
  const { left, top, width, height } = plot.bbox;
  const [gap, line] = [4 * devicePixelRatio, 15 * devicePixelRatio];
  let corner = 0;
  const names = [{ at: Infinity, isLeft: false }];
  for (const { limit, isAcross, isFar, name } of limitsOf(chart)) {
    const color = colorAt(plot.root, limit.kind === "continuous" ? "--soft" : "--limit");
    if (isFar) {
      corner += 1;
      write(plot, `↑ ${name}`, left + width - gap, top + corner * line, color, "right");
      continue;
    }
    const along = limit.x ?? (isAcross ? [limit.value, limit.value] : [x.min, x.max]);
    const values = limit.y ?? (isAcross ? [y.min, y.max] : [limit.value, limit.value]);
    draw(plot, along, values, color, [5, 4], 1.25);
    if (isAcross)
      write(plot, name, plot.valToPos(limit.value, "x", true) - gap, top + height - gap - line, color, "right");
    else if (name) {
      const isBeside = !isOverCycle(chart) && (chart.points ?? []).every((point) => point.x > (x.min + x.max) / 2); // beside it
      const at = plot.valToPos(isBeside ? values[0] : values[values.length - 1], "y", true);
      const bottom = at - line < top ? at + line + 2 : at - 1;
      const isTaken = names.some((one) => one.isLeft === isBeside && Math.abs(one.at - bottom) < line);
      const isLeft = isBeside !== isTaken; // no name over another
      names.push({ at: bottom, isLeft });
      write(plot, name, isLeft ? left + gap : left + width - gap, bottom, color, isLeft ? "left" : "right");
    }
  }
}

/** All lines of a chart, over the grid. @param {any} plot @param {{chart: any, saved: any}} shown */
export function drawAll(plot, { chart, saved }) {
  const { ctx, bbox, scales } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw(plot, [scales.x.min, scales.x.max], [0, 0], colorAt(plot.root, "--rule"), [], 1);
  const color = colorAt(plot.root, "--color");
  if (saved) draw(plot, saved.x, saved.y, colorAt(plot.root, "--soft"), [4, 3], 1.25);
  draw(plot, chart.x, chart.y, color);
  drawLimits(plot, chart);
  for (const { x, y, label } of chart.points ?? []) {
    const [left, top] = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)];
    const ink = colorAt(plot.root, "--ink");
    ctx.beginPath();
    ctx.arc(left, top, 4 * devicePixelRatio, 0, 7);
    ctx.fillStyle = ink;
    ctx.fill();
    const isRight = left > bbox.left + bbox.width * 0.6;
    const below = top + 18 * devicePixelRatio; // the name of the continuous limit stands above
    write(plot, label, left + (isRight ? -6 : 6) * devicePixelRatio, below, ink, isRight ? "right" : "left");
  }
  ctx.restore();
}

"use strict";
// How plots look: colours of the page's style, numbers, axes, and what is drawn beside the curves.

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

function seriesColour(index) { return colour("c" + index % 8); }

/// 1234.5, 0.0123, 1.2e-7: six digits, no padding.
function number(value) {
  if (value == null) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    return value.toExponential(4).replace(/\.?0+e/, "e").replace("e+", "e");
  }
  return String(Number(value.toPrecision(6)));
}

/// Powers of ten; between them 2 and 5 where there are few, and only every second, third, … where there are too many to be read.
function logSplits(plot, index, low, high) {
  const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high)), splits = [];
  const across = plot.axes[index].scale === "x", size = across ? plot.width - 80 : plot.height - 60;
  const step = Math.max(1, Math.ceil((last - first) * (across ? 52 : 18) / Math.max(1, size)));
  for (let power = Math.ceil(first / step) * step; power <= last; power += step) {
    for (const digit of high / low > 300 ? [1] : [1, 2, 5]) splits.push(Number(digit + "e" + power));
  }
  return splits.filter((value) => value >= low && value <= high);
}

/// `period`: of an angle in degrees.
function axis(description, side, period) {
  return {
    scale: side, label: description.label, labelSize: 22, labelGap: 0, size: side === "x" ? 38 : 58,
    stroke: colour("ink"), font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif",
    grid: { stroke: colour("grid"), width: 1 }, ticks: { stroke: colour("line"), width: 1, size: 5 },
    ...(description.log && { splits: logSplits, filter: (plot, splits) => splits }),
    ...(period && { incrs: [1, 5, 15, 30, 45, 90] }),
    values: (plot, splits) => splits.map((value) => value == null ? "" : number(value)),
  };
}

/// Shades a part of the x-axis, and draws a line at a level of y or at a value of x, behind the curves.
function drawBackground(plot, description) {
  const context = plot.ctx, box = plot.bbox;
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.width, box.height);
  context.clip();
  if (description.band) {
    const [from, to] = description.band.map((value) => plot.valToPos(value, "x", true));
    context.fillStyle = colour("band");
    context.fillRect(from, box.top, to - from, box.height);
  }
  context.strokeStyle = colour("quiet");
  context.lineWidth = devicePixelRatio;
  context.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
  context.beginPath();
  if (description.level != null) {
    const y = plot.valToPos(description.level, "y", true);
    context.moveTo(box.left, y);
    context.lineTo(box.left + box.width, y);
  }
  context.stroke();
  context.restore();
}

/// A named line at a value of x, before all else.
function drawMark(plot, mark) {
  const context = plot.ctx, box = plot.bbox, x = plot.valToPos(mark.x, "x", true);
  if (x < box.left || x > box.left + box.width) return;
  context.save();
  context.strokeStyle = context.fillStyle = seriesColour(1);
  context.lineWidth = 2 * devicePixelRatio;
  context.beginPath();
  context.moveTo(x, box.top);
  context.lineTo(x, box.top + box.height);
  context.stroke();
  context.font = 12 * devicePixelRatio + "px system-ui, sans-serif";
  const right = x > box.left + box.width / 2;
  context.textAlign = right ? "right" : "left";
  context.strokeStyle = colour("paper");
  context.lineWidth = 4 * devicePixelRatio;
  context.lineJoin = "round";
  const place = [x + (right ? -6 : 6) * devicePixelRatio, box.top + 14 * devicePixelRatio];
  context.strokeText(mark.name, ...place);
  context.fillText(mark.name, ...place);
  context.restore();
}

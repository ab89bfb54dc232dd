"use strict";
// From the page's descriptions of plots (see plot_json.hpp) to options and data of the plotting library.

function lineWidth(style) { return style === "reference" ? 4 : 1.75; }

function isReference(style) { return style === "reference" || style === "reference points"; }

/// Interrupts a curve where it jumps by more than half a period, e.g. a phase at ±180°.
function jumps(period) {
  return (plot, index, from, to, gaps) => {
    const x = plot.data[0], y = plot.data[index];
    for (let i = from + 1; i <= to; ++i) {
      if (y[i] == null || y[i - 1] == null || Math.abs(y[i] - y[i - 1]) <= period / 2) continue;
      gaps.push([plot.valToPos(x[i - 1], "x", true), plot.valToPos(x[i], "x", true)]);
    }
    return gaps.sort((a, b) => a[0] - b[0]);
  };
}

function curveSeries(series, index, period) {
  const shade = isReference(series.style) ? colour("reference") : seriesColour(index);
  const pointed = series.style.endsWith("points");
  const options = {
    label: series.name, stroke: shade, width: lineWidth(series.style), value: (plot, value) => number(value),
    points: { show: pointed, size: series.y.length > 300 ? 3 : 6, width: 0, fill: shade },
  };
  if (pointed) options.paths = () => null;
  if (series.style === "dashed") options.dash = [6, 4];
  if (period) options.gaps = jumps(period);
  return options;
}

/// Ends of the y-axis: as the plot says, or the data with a margin, as much above as below of a deviation, and with the level that
/// the data are compared with. Undefined: as the library chooses.
function yRange(plot) {
  if (plot.yRange) return plot.yRange;
  if (plot.deviation) {
    return (u, from, to) => {
      const half = Math.max(plot.deviation, 1.1 * Math.max(Math.abs(from ?? 0), Math.abs(to ?? 0)));
      return [-half, half];
    };
  }
  if (plot.level == null || (plot.y.log && !(plot.level > 0))) return undefined;
  return (u, from, to) => {
    if (from == null) return [null, null];
    const [low, high] = [Math.min(from, plot.level), Math.max(to, plot.level)];
    return plot.y.log ? uPlot.rangeLog(low, high, 10, true) : uPlot.rangeNum(low, high, .1, true);
  };
}

function curves(plot) {
  let next = 0;
  return {
    data: [plot.values, ...plot.series.map((series) => series.y)],
    series: plot.series.map((series) => curveSeries(series, isReference(series.style) ? 0 : next++, plot.period)),
    range: {
      x: plot.x.log && ((u, from, to) => [from, to]),  // the library would widen it to whole decades
      y: yRange(plot),
    },
    drag: { x: true, y: false }, x: plot.x, y: plot.y,
  };
}

/// Room around the outermost points, so that they can be seen whole; a part of the x-axis stays as it was asked for.
function withMargin(log) {
  return (plot, from, to, scale) => {
    if (from == null) return [null, null];
    if (scale === "x" && (from !== plot.data[0][0] || to !== plot.data[0].at(-1))) return [from, to];
    const share = .06;
    if (!log) {
      const margin = (to - from) * share || Math.abs(to) * share || 1;
      return [from - margin, to + margin];
    }
    const factor = Math.max(1.3, (to / from) ** share);
    return [from / factor, to * factor];
  };
}

/// Curves behind points, over their own axis on the right; lists of points like those of groups.
function backdropSeries(backdrop) {
  const list = backdrop ? backdrop.series : [];
  return {
    lists: list.map((series) => backdrop.values.map((x, i) => [x, series.y[i]])),
    series: list.map((series, index) => ({
      label: series.name, scale: "back", stroke: colour(index === 0 ? "reference" : "faint"), width: 1.5, spanGaps: true,
      points: { show: false }, value: (u, value) => number(value),
    })),
  };
}

/// All points in one list, ascending in x; each row has the value of its own series only.
function scatter(plot) {
  const back = backdropSeries(plot.backdrop), front = plot.front.length > 0;
  const lists = [...back.lists, ...plot.groups.map((group) => group.points), ...(front ? [plot.front] : [])];
  const rows = lists.flatMap((points, series) => points.map((point) => ({ point, series })));
  rows.sort((a, b) => a.point[0] - b.point[0]);
  const column = (series) => rows.map((row) => row.series === series ? row.point[1] : null);
  const series = plot.groups.map((group, index) => ({
    label: group.name, stroke: seriesColour(index), paths: () => null, value: (u, value) => number(value),
    points: { show: true, size: 9, fill: seriesColour(index), stroke: colour("paper"), width: 1 },
  }));
  if (front) {
    series.push({
      label: plot.frontName, stroke: colour("ink"), width: 1.25, dash: [5, 4], spanGaps: true, points: { show: false },
      value: (u, value) => number(value),
    });
  }
  return {
    data: [rows.map((row) => row.point[0]), ...lists.map((points, index) => column(index))], series: [...back.series, ...series],
    rows: rows.filter((row) => row.point[2]), back: plot.backdrop && plot.backdrop.y,
    range: { x: withMargin(plot.x.log), y: withMargin(plot.y.log) }, drag: { x: true, y: true }, x: plot.x, y: plot.y,
  };
}

function histogram(plot) {
  const [low, high] = plot.range, width = (high - low) / plot.counts.length;
  return {
    data: [plot.counts.map((count, bin) => low + (bin + .5) * width), plot.counts],
    series: [{
      label: "count", stroke: seriesColour(0), fill: colour("bar"), width: 1, points: { show: false },
      paths: uPlot.paths.bars({ size: [1, 200] }), value: (u, value) => number(value),
    }],
    range: { x: (u, from, to) => from > low + width || to < high - width ? [from, to] : [low, high],
             y: (u, from, to) => [0, to > 0 ? to * 1.05 : 1] },
    drag: { x: true, y: false }, x: plot.x, y: { label: "count", log: false },
  };
}

const kinds = { curves, scatter, histogram };

function scales(made) {
  const one = (description, range) => Object.assign({ time: false, distr: description.log ? 3 : 1 }, range && { range });
  return { x: one(made.x, made.range.x), y: one(made.y, made.range.y), ...(made.back && { back: one(made.back) }) };
}

function axes(made, description) {
  const both = [axis(made.x, "x"), { ...axis(made.y, "y", description.period), ...(description.deviation && { space: 16 }) }];
  return made.back ? [...both, { ...axis(made.back, "back"), side: 1, grid: { show: false } }] : both;
}

function height(description, width) {
  return description.deviation ? 150 : Math.round(Math.min(340, Math.max(230, width * .42)));
}

/// The name of the point nearest to the cursor, in a box beside it.
function showNearest(plot, rows, tip) {
  const { left, top } = plot.cursor;
  let nearest = null, least = 24;
  for (const { point } of left < 0 ? [] : rows) {
    const distance = Math.hypot(plot.valToPos(point[0], "x") - left, plot.valToPos(point[1], "y") - top);
    if (distance < least) [nearest, least] = [point, distance];
  }
  tip.hidden = nearest === null;
  if (nearest === null) return;
  tip.textContent = `${nearest[2]}: ${number(nearest[0])}, ${number(nearest[1])}`;
  tip.style.left = Math.min(left + plot.over.offsetLeft + 12, plot.width - 150) + "px";
  tip.style.top = top + 12 + "px";
}

/// Draws a description into an element; `whole` of the plot is the x-range that shows all of it. `part`: what to show of it.
function drawPlot(description, element, sync, part) {
  const made = kinds[description.kind](description);
  const width = element.clientWidth;
  const options = {
    width, height: height(description, width), scales: scales(made), axes: axes(made, description),
    series: [{ label: made.x.label, value: (plot, value) => number(value) }, ...made.series],
    cursor: { drag: made.drag, sync: { key: sync }, points: { size: 7 } },
    legend: { live: description.kind !== "scatter", markers: { fill: (plot, i) => made.series[i - 1].stroke } },
    hooks: {
      ready: [(plot) => {
        plot.whole = [plot.scales.x.min, plot.scales.x.max];
        if (part) queueMicrotask(() => plot.setScale("x", part));  // not while the library is drawing
      }],
      drawAxes: [(plot) => drawBackground(plot, description)],
      draw: [(plot) => { if (description.mark) drawMark(plot, description.mark); }],
    },
  };
  if (made.rows) {
    const tip = element.appendChild(Object.assign(document.createElement("div"), { className: "tip", hidden: true }));
    options.hooks.setCursor = [(plot) => showNearest(plot, made.rows, tip)];
  }
  return new uPlot(options, made.data, element);
}

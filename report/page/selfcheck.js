"use strict";
// With #selfcheck in its address the page uses itself: every choice of every group is drawn, zoomed with the mouse, hovered,
// set back, and zoomed and set back by its buttons (with the plots over the same axis); points tell their names, no number is broken
// into two lines, and paper is tried. The counts stand in <html data-selfcheck="…"> afterwards, the colour of the background in data-paper.

function mouse(plot, kind, x, y) {
  const box = plot.over.getBoundingClientRect();
  const target = kind === "mouseup" ? document : plot.over;
  target.dispatchEvent(new MouseEvent(kind, {
    bubbles: true, button: 0, clientX: box.left + x * box.width, clientY: box.top + y * box.height,
    movementX: 1, movementY: 1,
  }));
}

function settle() { return new Promise((resolve) => setTimeout(resolve, 20)); }

/// Some pixels of the plotting area have a colour.
function isDrawn(plot) {
  const { left, top, width, height } = plot.bbox;
  const pixels = plot.ctx.getImageData(left, top, width, height).data;
  let coloured = 0;
  for (let i = 3; i < pixels.length; i += 4) coloured += pixels[i] > 0 ? 1 : 0;
  return coloured > 100;
}

function shownPart(plot) { return plot.scales.x.max - plot.scales.x.min; }

function isLinked(group, { plot, description }) {
  return group.plots.every((other) => !sameAxis(description, other.description)
    || (other.plot.scales.x.min === plot.scales.x.min && other.plot.scales.x.max === plot.scales.x.max));
}

function isWhole(plot, all) { return Math.abs(shownPart(plot) - all) <= 1e-9 * all; }

async function check(group, one, counts) {
  const plot = one.plot;
  counts.plots += 1;
  await settle();
  if (isDrawn(plot)) counts.drawn += 1;
  const all = shownPart(plot);
  mouse(plot, "mouseenter", .3, .3);
  mouse(plot, "mousedown", .3, .3);
  mouse(plot, "mousemove", .6, .6);
  mouse(plot, "mouseup", .6, .6);
  await settle();
  if (shownPart(plot) < .6 * all) counts.zoomed += 1;
  mouse(plot, "mousemove", .5, .5);
  await settle();
  if (plot.cursor.left > 0 && (plot.cursor.idx != null)) counts.hovered += 1;
  mouse(plot, "dblclick", .5, .5);
  await settle();
  if (isWhole(plot, all)) counts.reset += 1;
  const [zoomIn, , showAll] = one.buttons;
  zoomIn.click();
  await settle();
  const { min, max } = plot.scales.x, [low, high] = plot.whole;
  if (low < min && min < max && max < high && isLinked(group, one)) counts.stepped += 1;
  showAll.click();
  await settle();
  if (isWhole(plot, all)) counts.restored += 1;
  if (one.description.kind === "scatter" && !await tellsName(one)) console.error("a point does not tell its name");
}

/// A point of a scatter plot tells its name when the pointer is on it.
async function tellsName(one) {
  const filled = one.description.groups.filter((group) => group.points.length > 0);
  if (filled.length === 0) return true;
  const plot = one.plot, [x, y] = filled.at(-1).points.at(-1);
  mouse(plot, "mousemove", plot.valToPos(x, "x") / plot.over.clientWidth, plot.valToPos(y, "y") / plot.over.clientHeight);
  await settle();
  const tip = plot.root.parentElement.querySelector(".tip");
  const names = one.description.groups.flatMap((group) => group.points.map((point) => point[2]));
  return !tip.hidden && names.some((name) => tip.textContent.startsWith(name + ":"));
}

/// Numbers of the page's text that stand on two lines.
function brokenNumbers() {
  const broken = [], range = document.createRange();
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const node = texts.currentNode;
    if (node.parentElement.closest("script, style, header, .path")) continue;
    for (const found of node.data.matchAll(/[-+−]?\d[\d.]*(e[-+]?\d+)?/g)) {
      range.setStart(node, found.index);
      range.setEnd(node, found.index + found[0].length);
      const tops = [...range.getClientRects()].map((box) => Math.round(box.top));
      if (new Set(tops).size > 1) broken.push(found[0]);
    }
  }
  return broken;
}

/// On paper every plot is drawn in black on white, no wider than the page.
async function fitsPaper() {
  prepareForPaper(true);
  await settle();
  const fits = groups.every((group) => group.plots.every(({ plot }) => isDrawn(plot) && plot.width <= 680));
  const white = colour("paper") === "#ffffff";
  for (const text of brokenNumbers()) console.error("a number is broken on paper: " + text);
  for (const table of document.querySelectorAll(".wide > table:not(.cramped)")) {
    if (table.getBoundingClientRect().width > table.parentElement.clientWidth + 1) console.error("a table is wider than the paper");
  }
  prepareForPaper(false);
  await settle();
  return fits && white;
}

/// A redraw, as for printing, leaves a zoomed plot as it was.
async function keepsPart(group) {
  group.plots[0].buttons[0].click();
  await settle();
  const before = { ...group.plots[0].plot.scales.x };
  group.redraw();
  await settle();
  const after = group.plots[0].plot.scales.x;
  return before.min === after.min && before.max === after.max && group.plots[0].plot.whole[1] > after.max;
}

async function selfCheck() {
  const counts = { plots: 0, drawn: 0, zoomed: 0, hovered: 0, reset: 0, stepped: 0, restored: 0 };
  for (const group of groups) {
    for (let choice = 0; choice < group.description.choices.length; ++choice) {
      group.chosen = choice;
      group.draw();
      for (const one of group.plots) await check(group, one, counts);
    }
  }
  for (const group of groups) if (!await keepsPart(group)) console.error("a redraw lost what was shown");
  if (document.documentElement.scrollWidth > innerWidth) console.error("the page is wider than its window");
  for (const text of brokenNumbers()) console.error("a number is broken: " + text);
  if (!await fitsPaper()) console.error("the plots do not fit on paper");
  document.documentElement.dataset.paper = colour("paper");
  document.documentElement.dataset.selfcheck = Object.entries(counts).map(([name, count]) => name + "=" + count).join(" ");
}

if (location.hash === "#selfcheck") selfCheck();

"use strict";
// With #selfcheck in its address the page uses itself: every choice of every group is drawn, zoomed with the mouse, hovered
// and set back; the counts stand in <html data-selfcheck="…"> afterwards.

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
  if (isLinked(group, one)) counts.linked += 1;
  mouse(plot, "mousemove", .5, .5);
  await settle();
  if (plot.cursor.left > 0 && (plot.cursor.idx != null)) counts.hovered += 1;
  mouse(plot, "dblclick", .5, .5);
  await settle();
  if (Math.abs(shownPart(plot) - all) <= 1e-9 * all) counts.reset += 1;
}

async function selfCheck() {
  const counts = { plots: 0, drawn: 0, zoomed: 0, linked: 0, hovered: 0, reset: 0 };
  for (const group of groups) {
    for (let choice = 0; choice < group.description.choices.length; ++choice) {
      group.chosen = choice;
      group.draw();
      for (const one of group.plots) await check(group, one, counts);
    }
  }
  document.documentElement.dataset.selfcheck = Object.entries(counts).map(([name, count]) => name + "=" + count).join(" ");
}

if (location.hash === "#selfcheck") selfCheck();

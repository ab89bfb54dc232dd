"use strict";
// Fills the page's places for plots, and draws them anew when the choice, the colours, the width or the medium change.

function make(tag, className, text) {
  return Object.assign(document.createElement(tag), { className: className || "", textContent: text || "" });
}

/// "same": curves over the points of the plot before.
function withValues(plots) {
  plots.forEach((plot, i) => { if (plot.values === "same") plot.values = plots[i - 1].values; });
}

class Group {
  constructor(description, element, index) {
    this.description = description;
    this.element = element;
    this.index = index;
    this.chosen = 0;
    this.plots = [];
    description.choices.forEach((choice) => withValues(choice.plots));
    if (description.choices.length > 1) element.append(this.menu());
    this.figures = element.appendChild(make("div", "figures"));
  }

  menu() {
    const row = make("div", "menu"), label = make("label", "", this.description.menu), select = make("select");
    this.description.choices.forEach((choice, i) => select.append(new Option(choice.name, i)));
    select.addEventListener("change", () => { this.chosen = Number(select.value); this.draw(); });
    this.shown = make("span", "shown");
    label.append(select);
    row.append(label, this.shown);
    return row;
  }

  /// The same plots anew, zoomed as they were.
  redraw() {
    this.draw(this.plots.map(({ plot }) => ({ min: plot.scales.x.min, max: plot.scales.x.max })));
  }

  draw(parts = []) {
    for (const { plot } of this.plots) plot.destroy();
    this.figures.replaceChildren();
    const choice = this.description.choices[this.chosen];
    if (this.shown) this.shown.textContent = document.documentElement.classList.contains("printing") ? choice.name : "";
    this.plots = choice.plots.map((description, i) => this.figure(description, parts[i]));
    this.link();
  }

  figure(description, part) {
    const figure = make("figure", description.kind), caption = make("figcaption"), element = make("div", "plot");
    figure.append(caption, element);
    this.figures.append(figure);
    const plot = drawPlot(description, element, "group" + this.index, part);
    caption.append(make("span", "", description.title));
    const buttons = [];
    for (const [sign, what, factor] of [["+", "zoom in", .5], ["−", "zoom out", 2], ["⟲", "show all", Infinity]]) {
      const button = caption.appendChild(make("button", "", sign));
      button.type = "button";
      button.title = button.ariaLabel = what;
      button.addEventListener("click", () => zoom(plot, factor));
      buttons.push(button);
    }
    touchZoom(plot);
    return { plot, description, buttons };
  }

  /// Curves over the same axis show the same part of it.
  link() {
    for (const one of this.plots) {
      const others = this.plots.filter((other) => other !== one && sameAxis(one.description, other.description));
      (one.plot.hooks.setScale = one.plot.hooks.setScale || []).push((plot, key) => {
        if (key !== "x") return;
        const { min, max } = plot.scales.x;
        for (const other of others) {
          if (other.plot.scales.x.min !== min || other.plot.scales.x.max !== max) other.plot.setScale("x", { min, max });
        }
      });
    }
  }
}

function sameAxis(a, b) { return a.kind === "curves" && b.kind === "curves" && a.x.label === b.x.label; }

/// Shows `factor` times as much of the x-axis around its middle, at most all; infinity: all, of y too.
function zoom(plot, factor) {
  if (factor === Infinity) return plot.setData(plot.data, true);
  const log = plot.scales.x.distr === 3, to = log ? Math.log : Number, back = log ? Math.exp : Number;
  const from = to(plot.scales.x.min), until = to(plot.scales.x.max);
  const middle = (from + until) / 2, half = (until - from) / 2 * factor;
  const [low, high] = plot.whole;
  plot.setScale("x", { min: Math.max(low, back(middle - half)), max: Math.min(high, back(middle + half)) });
}

const groups = JSON.parse(document.getElementById("plots").textContent)
  .map((description, i) => new Group(description, document.querySelector(`[data-group="${i}"]`), i));

function drawAll() {
  for (const group of groups) group.redraw();
  document.documentElement.dataset.plots = String(groups.reduce((sum, group) => sum + group.plots.length, 0));
}

/// Tables that are wider than the paper are made smaller, to a half; those that are wider still are broken where they must.
function fitTables(on) {
  const smallest = 0.5;
  for (const table of document.querySelectorAll(".wide > table")) {
    table.classList.remove("cramped");
    table.style.zoom = "";
    const room = table.parentElement.clientWidth, share = room / table.scrollWidth;
    if (!on || !(share < 1)) continue;
    table.classList.toggle("cramped", share < smallest);
    table.style.zoom = Math.max(smallest, 0.99 * share);
  }
}

function prepareForPaper(on) {
  document.documentElement.classList.toggle("printing", on);
  document.body.style.width = on ? "680px" : "";
  fitTables(on);
  drawAll();
}

drawAll();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
addEventListener("beforeprint", () => prepareForPaper(true));
addEventListener("afterprint", () => prepareForPaper(false));
let lastWidth = document.body.clientWidth;
addEventListener("resize", () => {
  if (document.body.clientWidth === lastWidth) return;
  lastWidth = document.body.clientWidth;
  drawAll();
});

"use strict";
// Two fingers zoom a plot along x, one finger moves it sideways once it is zoomed.

function touchZoom(plot) {
  let start = null;
  const value = (touch) => touch.clientX - plot.over.getBoundingClientRect().left;
  const span = (touches) => touches.length > 1 ? Math.max(20, Math.abs(value(touches[0]) - value(touches[1]))) : null;
  const middle = (touches) => touches.length > 1 ? (value(touches[0]) + value(touches[1])) / 2 : value(touches[0]);
  function begin(event) {
    const touches = event.touches;
    start = touches.length === 0 ? null
      : { span: span(touches), middle: middle(touches), from: plot.posToVal(0, "x"), to: plot.posToVal(plot.over.clientWidth, "x") };
  }
  function move(event) {
    if (start === null || (event.touches.length > 1) !== (start.span !== null)) return;
    const factor = start.span === null ? 1 : start.span / span(event.touches);
    const width = plot.over.clientWidth, perPixel = (start.to - start.from) / width;
    const from = start.from + perPixel * (start.middle - middle(event.touches) * factor);
    const [low, high] = plot.whole;
    const length = Math.min((start.to - start.from) * factor, high - low);
    const left = Math.max(low, Math.min(from, high - length));
    plot.setScale("x", { min: left, max: left + length });
  }
  plot.over.addEventListener("touchstart", begin, { passive: true });
  plot.over.addEventListener("touchend", begin, { passive: true });
  plot.over.addEventListener("touchmove", move, { passive: true });
}

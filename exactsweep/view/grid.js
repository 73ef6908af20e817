// A grid with coordinates at the edges, shifted and scaled like the axes.

// The minimum distance of lines, and the distance of numbers from the edge, in pixels.
const MESH = 70;
const INSET = 4;

function drawGrid(context, view, axes, color) {
  const { width, height } = view;
  context.font = "11px system-ui, sans-serif";
  context.lineWidth = 1;
  context.setLineDash([]);
  for (const axis of [0, 1]) {
    const isX = axis === 0;
    const [low, high] = [view.place(0, height)[axis], view.place(width, 0)[axis]].sort((a, b) => a - b);
    const step = roundStep(((high - low) * MESH) / (isX ? width : height));
    // At high zoom levels, floats are too coarse for a grid.
    if (!(step > 1e-12 * Math.max(Math.abs(low), Math.abs(high)))) continue;
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    for (let k = Math.ceil(low / step); k * step <= high; k++) {
      const at = Math.round(isX ? view.x(k * step) : view.y(k * step)) + 0.5;
      context.strokeStyle = color("grid");
      context.beginPath();
      context.moveTo(isX ? at : 0, isX ? 0 : at);
      context.lineTo(isX ? at : width, isX ? height : at);
      context.stroke();
      context.fillStyle = color("faint");
      context.textAlign = isX ? "center" : "right";
      context.textBaseline = isX ? "bottom" : "middle";
      const number = k ? (k * step).toFixed(Math.min(digits, 20)) : "0";
      // Leave the corner free for the names of the axes.
      if (isX ? at > 60 && at < width - 120 : at > 46 && at < height - 30) {
        context.fillText(number, isX ? at : width - INSET, isX ? height - INSET : at);
      }
    }
  }
  context.fillStyle = color("faint");
  context.textAlign = "right";
  context.textBaseline = "bottom";
  context.fillText(`${nameOf("x", axes[0])}, ${nameOf("y", axes[1])}`, width - INSET, height - INSET);
}

// Round up to 1, 2 or 5 times a power of ten.
function roundStep(least) {
  const unit = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].find((times) => times * unit >= least) * unit;
}

function nameOf(name, { origin, exponent }) {
  const size = rational.brief(origin.replace("-", ""));
  const moved = origin === "0" ? name : `(${name} ${origin[0] === "-" ? "+" : "\u2212"} ${size})`;
  return exponent ? `${moved} / 10^${exponent}` : moved;
}

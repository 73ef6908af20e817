// Drawing: fixed parts on one canvas, G and its contacts on a second canvas above it.

// Dashes of the trajectory by event, for color-blind readers.
const DASHES = { EV: [], VE: [6, 4], EE: [2, 2.5], several: [8, 2, 2, 2] };
// The length in pixels from which a line is dense, such as a zigzag of thousands of edges.
const DENSE = 20_000;
// Above this number, exact fits are thin lines without markers.
const MANY = 60;

class Scene {
  constructor(data, view, ground, top) {
    Object.assign(this, { data, view });
    this.layers = [ground, top].map((canvas) => ({ canvas, context: canvas.getContext("2d") }));
    this.loops = data.tracks.slice(0, data.loops);
    this.runs = runs(this.loops);
    this.hasGrid = true;
    this.readColors();
  }

  readColors() {
    const style = getComputedStyle(document.documentElement);
    this.color = (name) => style.getPropertyValue(`--${name}`).trim();
  }

  resize(width, height) {
    this.ratio = window.devicePixelRatio || 1;
    for (const { canvas } of this.layers) {
      canvas.width = Math.round(width * this.ratio);
      canvas.height = Math.round(height * this.ratio);
    }
    this.view.resize(width, height);
  }

  cleared(k) {
    const { canvas, context } = this.layers[k];
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.lineJoin = "round";
    return context;
  }

  area(context, shapes, fill) {
    context.beginPath();
    for (const pixels of shapes) traceArea(context, pixels, this.view.window);
    context.fillStyle = fill;
    context.fill("evenodd");
  }

  line(context, pixels, name, width, options = {}) {
    this.lines(context, [pixels], name, width, options);
  }

  lines(context, chains, name, width, { isClosed = false, dash = [] }) {
    context.beginPath();
    let length = 0;
    for (const pixels of chains) length += traceLine(context, pixels, this.view.window, isClosed);
    context.strokeStyle = this.color(name);
    // On a dense line, width and dashes are invisible, and drawing them takes fifty times as long.
    const isDense = length > DENSE;
    this.isDense ||= isDense;
    context.lineWidth = isDense ? 1 : width;
    context.setLineDash(isDense ? [] : dash);
    context.stroke();
  }

  dot(context, x, y, name, radius) {
    this.dots(context, [[x, y]], name, radius);
  }

  dots(context, spots, name, radius = 4) {
    const [left, low, right, high] = this.view.window;
    context.beginPath();
    for (const [x, y] of spots) {
      if (x < left || x > right || y < low || y > high) continue;
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fillStyle = this.color(name);
    context.strokeStyle = this.color("page");
    context.lineWidth = 1.5;
    context.setLineDash([]);
    context.fill();
    context.stroke();
  }

  hatching(context) {
    const tile = document.createElement("canvas");
    const size = (tile.width = tile.height = Math.round(7 * this.ratio));
    const brush = tile.getContext("2d");
    brush.strokeStyle = this.color("undercut");
    brush.lineWidth = this.ratio;
    for (const shift of [-size, 0, size]) {
      brush.moveTo(shift - 1, size + 1);
      brush.lineTo(shift + size + 1, -1);
    }
    brush.stroke();
    const pattern = context.createPattern(tile, "repeat");
    pattern.setTransform(new DOMMatrix([1 / this.ratio, 0, 0, 1 / this.ratio, 0, 0]));
    return pattern;
  }

  drawGround() {
    const { data, view } = this;
    const context = this.cleared(0);
    this.isDense = false;
    this.drawn = view.zoom;
    this.layers[0].canvas.style.transform = "";
    if (this.hasGrid) drawGrid(context, view, data.axes, this.color);
    const [inner, outer] = ["inner", "outer"].map((name) => view.pixels(data[name].places));
    const unswept = data.unswept.map(({ places }) => view.pixels(places));
    const directrix = ringsOf(data.directrix.rings, view.pixels(data.directrix.places));
    const paths = this.loops.map(({ places }) => view.pixels(places));
    const swept = data.asked === "sweep" ? [outer, inner, ...unswept] : data.outside ? paths : [];
    this.area(context, swept, this.color("swept"));
    this.area(context, directrix, this.color("directrix-fill"));
    this.lines(context, directrix, "directrix", 1, { isClosed: true });
    const holes = paths.slice(data.outside);
    this.area(context, holes, this.color("free-fill"));
    this.lines(context, holes, "free", 2.5, { isClosed: true });
    const undercuts = data.undercuts.map(({ places }) => view.pixels(places));
    this.area(context, undercuts, this.hatching(context));
    this.lines(context, undercuts, "undercut", 0.7, { isClosed: true });
    this.lines(context, [inner, ...unswept], "inner", 3, { isClosed: true });
    this.line(context, outer, "outer", 1.8, { isClosed: true, dash: [16, 4] });
    for (const [event, chains] of this.runs) {
      const pixels = chains.map((places) => view.pixels(places));
      this.lines(context, pixels, event === "several" ? "path" : event, 2, { dash: DASHES[event] });
    }
    // Many exact fits are drawn thin, so that none hides another.
    const isThin = data.fits.length > MANY;
    const fits = data.fits.map(({ places }) => view.pixels(places));
    this.lines(context, fits, "fit", isThin ? 1.5 : 4, {});
    if (isThin) return;
    const ends = fits.flatMap(([ax, ay, bx, by], k) =>
      [[ax, ay], [bx, by]].map((spot, end) => ({ spot, hangs: data.fits[k].hangs[end] })),
    );
    const spots = (wanted) => ends.filter(({ hangs }) => hangs === wanted).map(({ spot }) => spot);
    this.dots(context, spots(false), "fit", 6);
    this.dots(context, spots(true), "page");
    this.lines(context, spots(true).map(([x, y]) => circle(x, y)), "fit", 2, { isClosed: true });
  }

  // Transform the last image of the fixed parts.
  moveGround() {
    const { k, x, y } = this.view.zoom;
    const ratio = k / this.drawn.k;
    const shift = [x - ratio * this.drawn.x, y - ratio * this.drawn.y];
    this.layers[0].canvas.style.transform = `matrix(${ratio}, 0, 0, ${ratio}, ${shift})`;
  }

  // Draw G with the anchor at a place, the contacts, and the feature under the pointer.
  drawTop([px, py], contacts, pointed) {
    const { data, view } = this;
    const context = this.cleared(1);
    if (pointed.undercut) {
      this.area(context, [view.pixels(pointed.undercut.places)], this.color("undercut-fill"));
    }
    if (pointed.fit) this.line(context, view.pixels(pointed.fit.places), "fit", 7);
    const g = view.pixels(data.generatrix.places, px, py);
    const d = view.pixels(data.directrix.places);
    const rings = ringsOf(data.generatrix.rings, g);
    this.area(context, rings, this.color("generatrix-fill"));
    this.lines(context, rings, "generatrix", 2, { isClosed: true });
    for (const [event, i, j] of [...contacts].reverse()) {
      const spots = [
        [g, data.generatrix, i, event[0]],
        [d, data.directrix, j, event[1]],
      ];
      for (const [pixels, polygon, number, kind] of spots) {
        const index = polygon[kind === "E" ? "edgeOf" : "vertexOf"].get(number);
        const [k, n] = [2 * index, 2 * polygon.after[index]];
        if (kind === "E") {
          const edge = [pixels[k], pixels[k + 1], pixels[n], pixels[n + 1]];
          this.line(context, edge, event, 3.5);
        } else this.dot(context, pixels[k], pixels[k + 1], event, 5);
      }
    }
    this.dot(context, view.x(px), view.y(py), "generatrix", 4.5);
    if (pointed.place) {
      const ring = circle(view.x(pointed.place[0]), view.y(pointed.place[1]), 8);
      this.line(context, ring, "text", 1.5, { isClosed: true });
    }
  }
}

// The parts of loops with the same event, by event.
function runs(loops) {
  const found = new Map();
  for (const { places, contacts } of loops) {
    let last = null;
    for (let k = 0; k < contacts.length; k++) {
      const events = new Set(contacts[k].map(([event]) => event));
      const event = events.size === 1 ? contacts[k][0][0] : events.size ? "several" : "free";
      if (event !== last) {
        if (!found.has(event)) found.set(event, []);
        found.get(event).push(places.slice(2 * k, 2 * k + 2));
      }
      const next = (2 * k + 2) % places.length;
      found.get(event).at(-1).push(places[next], places[next + 1]);
      last = event;
    }
  }
  return found;
}

function circle(x, y, radius = 5) {
  const turns = Array.from({ length: 24 }, (_, k) => (k * Math.PI) / 12);
  return turns.flatMap((turn) => [x + radius * Math.cos(turn), y + radius * Math.sin(turn)]);
}

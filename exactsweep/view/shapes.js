// Conversion of places (scaled coordinates) to pixels, and clipping. Y points up unless data.down.

// Lines are clipped this many pixels outside the canvas, for precision and to limit dashes.
const BEYOND = 60;
// Points closer than this to the preceding one, in pixels, are skipped.
const FINE = 0.4;

// Lists of places are flat: x, y, x, y, ...
function bounds(places) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i += 2) {
    box[0] = Math.min(box[0], places[i]);
    box[1] = Math.min(box[1], places[i + 1]);
    box[2] = Math.max(box[2], places[i]);
    box[3] = Math.max(box[3], places[i + 1]);
  }
  return box;
}

class View {
  // A box of places shown on a canvas, with the same unit for both axes unless stretched.
  constructor(box, isStretched, isDown) {
    this.box = box;
    this.isStretched = isStretched;
    this.sign = isDown ? 1 : -1;
    this.zoom = { k: 1, x: 0, y: 0 };
    this.resize(1, 1);
  }

  resize(width, height) {
    const [left, low, right, high] = this.box;
    const margin = Math.min(40, width / 10, height / 10);
    let kx = (width - 2 * margin) / (right - left || 1);
    let ky = (height - 2 * margin) / (high - low || 1);
    if (!this.isStretched) kx = ky = Math.min(kx, ky);
    Object.assign(this, { width, height, kx, ky });
    this.x0 = width / 2 - (kx * (left + right)) / 2;
    this.y0 = height / 2 - (this.sign * ky * (low + high)) / 2;
  }

  x(place) {
    return this.zoom.k * (this.x0 + this.kx * place) + this.zoom.x;
  }

  y(place) {
    return this.zoom.k * (this.y0 + this.sign * this.ky * place) + this.zoom.y;
  }

  // The clipping window in pixels: [left, top, right, bottom].
  get window() {
    return [-BEYOND, -BEYOND, this.width + BEYOND, this.height + BEYOND];
  }

  place(x, y) {
    const { k, x: tx, y: ty } = this.zoom;
    return [((x - tx) / k - this.x0) / this.kx, ((y - ty) / k - this.y0) / (this.sign * this.ky)];
  }

  // The pixels of places translated by (dx, dy).
  pixels(places, dx = 0, dy = 0) {
    const found = new Float64Array(places.length);
    for (let i = 0; i < places.length; i += 2) {
      found[i] = this.x(places[i] + dx);
      found[i + 1] = this.y(places[i + 1] + dy);
    }
    return found;
  }
}

function isWithin(pixels, [left, low, right, high]) {
  for (let i = 0; i < pixels.length; i += 2) {
    const [x, y] = [pixels[i], pixels[i + 1]];
    if (x < left || x > right || y < low || y > high) return false;
  }
  return true;
}

// Add a chain or a loop of pixels to the path of a context; return an upper bound of its length.
function traceLine(context, pixels, window, isClosed) {
  const size = pixels.length;
  if (isWithin(pixels, window)) {
    const near = traceNear(context, pixels);
    if (isClosed) context.closePath();
    return near;
  }
  let [x, y] = [Infinity, Infinity];
  let length = 0;
  for (let i = isClosed ? 0 : 2; i < size; i += 2) {
    const j = (i || size) - 2;
    const piece = clipped(pixels[j], pixels[j + 1], pixels[i], pixels[i + 1], window);
    if (!piece) continue;
    if (piece[0] !== x || piece[1] !== y) context.moveTo(piece[0], piece[1]);
    [, , x, y] = piece;
    context.lineTo(x, y);
    length += Math.abs(x - piece[0]) + Math.abs(y - piece[1]);
  }
  return length;
}

// Add the boundary of an area, clipped to the window, to the path of a context.
function traceArea(context, pixels, window) {
  traceNear(context, isWithin(pixels, window) ? pixels : cropped(pixels, window));
  context.closePath();
}

function traceNear(context, pixels) {
  const size = pixels.length;
  if (!size) return 0;
  let [x, y] = [pixels[0], pixels[1]];
  let length = 0;
  context.moveTo(x, y);
  for (let i = 2; i < size; i += 2) {
    const step = Math.abs(pixels[i] - x) + Math.abs(pixels[i + 1] - y);
    if (step < FINE && i < size - 2) continue;
    [x, y] = [pixels[i], pixels[i + 1]];
    context.lineTo(x, y);
    length += step;
  }
  return length;
}

// The part of a segment in a window, or null (Liang and Barsky).
function clipped(x0, y0, x1, y1, [left, low, right, high]) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  let [start, end] = [0, 1];
  const sides = [[-dx, x0 - left], [dx, right - x0], [-dy, y0 - low], [dy, high - y0]];
  for (const [step, room] of sides) {
    if (step === 0) {
      if (room < 0) return null;
    } else if (step < 0) start = Math.max(start, room / step);
    else end = Math.min(end, room / step);
  }
  if (start >= end) return null;
  return [
    start ? x0 + start * dx : x0,
    start ? y0 + start * dy : y0,
    end < 1 ? x0 + end * dx : x1,
    end < 1 ? y0 + end * dy : y1,
  ];
}

// The part of an area in a window (Sutherland and Hodgman).
function cropped(pixels, [left, low, right, high]) {
  let loop = pixels;
  for (const [axis, sign, side] of [[0, 1, left], [0, -1, right], [1, 1, low], [1, -1, high]]) {
    const found = [];
    const size = loop.length;
    for (let i = 0; i < size; i += 2) {
      const j = (i || size) - 2;
      const [before, here] = [sign * (loop[j + axis] - side), sign * (loop[i + axis] - side)];
      if (before < 0 !== here < 0) {
        const share = before / (before - here);
        found.push(loop[j] + share * (loop[i] - loop[j]));
        found.push(loop[j + 1] + share * (loop[i + 1] - loop[j + 1]));
      }
      if (here >= 0) found.push(loop[i], loop[i + 1]);
    }
    loop = found;
  }
  return loop;
}

// Split places into rings of given sizes.
function ringsOf(sizes, places) {
  let first = 0;
  return sizes.map((size) => places.slice(2 * first, 2 * (first += size)));
}

// Whether a point is inside an odd number of loops.
function contains(loops, x, y) {
  let inside = false;
  for (const places of loops) {
    for (let i = 0, j = places.length - 2; i < places.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [places[i], places[i + 1], places[j], places[j + 1]];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
    }
  }
  return inside;
}

// The parameter of the point of segment ab nearest to a point, and the distance.
function nearest(x, y, ax, ay, bx, by) {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const along = square ? ((x - ax) * dx + (y - ay) * dy) / square : 0;
  const share = Math.min(1, Math.max(0, along));
  return [share, Math.hypot(x - ax - share * dx, y - ay - share * dy)];
}

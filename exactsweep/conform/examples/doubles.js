// No-fit polygons and Minkowski sums of any shapes with holes, in doubles, for small cases.
// Put your own code in place of noFit; or of minkowskiSum, if it computes a + b.
// A shape is a list of rings, the exterior first, in either orientation.
// node doubles.js
"use strict";
const readline = require("node:readline");

const MOST = 2500; // Maximum number of pairs of edges; the time grows with its square.

// The rings around the positions of the reference point at which g overlaps d.
function noFit(d, g, [x, y]) {
  return translate(minkowskiSum(d, scale(g, -1)), x, y);
}

// The rings of a + b: edges of each at convex corners of the other, cut and filtered.
function minkowskiSum(a, b) {
  const size = Math.max(...[a, b].flat(3).map(Math.abs));
  if (size < 1e-70 || size > 1e70) {
    // Products would overflow or underflow; scaling by a power of two is exact.
    const k = size > 1 ? 2 ** -200 : 2 ** 200;
    return scale(minkowskiSum(scale(a, k), scale(b, k)), 1 / k);
  }
  const [[x, y], [u, v]] = [a[0][0], b[0][0]];
  if (x || y || u || v) {
    // Coordinates near the origin have more digits.
    return translate(minkowskiSum(translate(a, -x, -y), translate(b, -u, -v)), x + u, y + v);
  }
  [a, b] = [orient(a), orient(b)];
  const placed = [...placeEdges(a, b), ...placeEdges(b, a)];
  const near = placed.flat(2).reduce((most, c) => Math.max(most, 1e-13 * Math.abs(c)), 0);
  const nodes = [];
  const isNear = (p, q) => Math.abs(p[0] - q[0]) < near && Math.abs(p[1] - q[1]) < near;
  const findNode = (p) => {
    const k = nodes.findIndex((q) => isNear(p, q));
    return k < 0 ? nodes.push(p) - 1 : k;
  };
  const lines = placed.map((line) => line.map(findNode)).filter(([p, q]) => p !== q);
  const ends = lines.map((line) => line.map((k) => nodes[k]));
  const pieces = new Map();
  for (const [p, q] of ends) {
    const cuts = new Set([0, 1]);
    for (const other of ends) findCuts(p, q, other, near, cuts);
    const places = [...cuts].sort((s, t) => s - t).map((t) => between(p, q, t));
    for (let k = 1; k < places.length; k++) {
      const [r, s] = [places[k - 1], places[k]];
      const [dx, dy] = [s[0] - r[0], s[1] - r[1]];
      const length = Math.hypot(dx, dy);
      // The interior is left of each piece; the exterior is right of boundary pieces.
      // At the midpoint, two corners might be opposite each other.
      const x = r[0] + 0.4372 * dx + (near * dy) / length;
      const y = r[1] + 0.4372 * dy - (near * dx) / length;
      if (length > near && !isInside([x, y], a, b)) {
        const piece = [findNode(r), findNode(s)];
        pieces.set(String(piece), piece);
      }
    }
  }
  return join([...pieces.values()], nodes);
}

const mapPoints = (shape, change) => shape.map((ring) => ring.map(change));
const scale = (shape, k) => mapPoints(shape, ([x, y]) => [k * x, k * y]);
const translate = (shape, dx, dy) => mapPoints(shape, ([x, y]) => [x + dx, y + dy]);
const between = (p, q, t) => [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
const sides = (ring) => ring.map((p, k) => [ring.at(k - 1), p]);

// Positive if r is on the left of pq.
const turn = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);

// Orient rings with the interior on the left; drop repeated vertices.
function orient(shape) {
  return shape.map((given, k) => {
    const ring = given.filter(([x, y], j) => x !== given.at(j - 1)[0] || y !== given.at(j - 1)[1]);
    const area = sides(ring).reduce((sum, [p, q]) => sum + turn(ring[0], p, q), 0);
    return area > 0 === (k === 0) ? ring : ring.reverse();
  });
}

// Translate each edge to the corners of the other shape whose edges enclose its direction.
function placeEdges(edges, corners) {
  const lines = [];
  for (const ring of corners) {
    ring.forEach(([x, y], k) => {
      const [[bx, by], [ax, ay]] = [ring.at(k - 1), ring[(k + 1) % ring.length]];
      for (const [p, q] of edges.flatMap(sides)) {
        const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
        if ((x - bx) * dy - (y - by) * dx >= 0 && dx * (ay - y) - dy * (ax - x) >= 0) {
          lines.push([p, q].map(([u, v]) => [u + x, v + y]));
        }
      }
    });
  }
  return lines;
}

// Add the parameters on pq, from 0 to 1, where rs crosses it or ends on it.
function findCuts(p, q, [r, s], near, cuts) {
  for (const c of [0, 1]) {
    if (Math.min(r[c], s[c]) > Math.max(p[c], q[c]) + near) return;
    if (Math.max(r[c], s[c]) < Math.min(p[c], q[c]) - near) return;
  }
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
  const place = ([x, y]) => {
    const along = (q[0] - p[0]) * (x - p[0]) + (q[1] - p[1]) * (y - p[1]);
    const t = along / length ** 2;
    if (0 < t && t < 1) cuts.add(t);
  };
  const [one, two] = [turn(p, q, r) / length, turn(p, q, s) / length];
  if (Math.abs(one) < near) place(r);
  if (Math.abs(two) < near) place(s);
  if (Math.abs(one) < near || Math.abs(two) < near || one > 0 === two > 0) return;
  place(between(r, s, one / (one - two)));
}

// Whether a point is inside a + b: whether a meets the point minus b.
function isInside([x, y], a, b) {
  const c = mapPoints(b, ([u, v]) => [x - u, y - v]);
  const others = c.flatMap(sides);
  for (const [p, q] of a.flatMap(sides)) {
    for (const [r, s] of others) {
      if (turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0) return true;
    }
  }
  return holds(a, c[0][0]) || holds(c, a[0][0]);
}

// Whether a point is inside a shape: a ray from it crosses an odd number of edges.
function holds(shape, p) {
  const crossed = shape
    .flatMap(sides)
    .filter(([a, b]) => a[1] > p[1] !== b[1] > p[1] && turn(a, b, p) > 0 === b[1] > a[1]);
  return crossed.length % 2 === 1;
}

// Join pieces to rings; at a branch, take the rightmost piece.
function join(pieces, nodes) {
  const rings = [];
  const angle = (p, q) => Math.atan2(nodes[q][1] - nodes[p][1], nodes[q][0] - nodes[p][0]);
  while (pieces.length) {
    let [from, to] = pieces.pop();
    const [start, ring] = [from, [nodes[from]]];
    while (to !== start) {
      ring.push(nodes[to]);
      const back = angle(to, from);
      const right = ([p, q]) => (angle(p, q) - back + 4 * Math.PI) % (2 * Math.PI);
      const going = pieces.filter(([p]) => p === to).sort((s, t) => right(t) - right(s));
      if (!going.length) throw new Error("the boundary does not close");
      pieces.splice(pieces.indexOf(going[0]), 1);
      [from, to] = going[0];
    }
    rings.push(ring);
  }
  return rings;
}

// Answer all questions of a case.
function answer(given) {
  const readRing = (ring) => ring.map((pair) => pair.map(Number));
  const read = (name) => [given[name], ...(given[`${name}_holes`] ?? [])].map(readRing);
  const [d, g] = [read("directrix"), read("generatrix")];
  if (d.flat().length * g.flat().length > MOST) return { unsupported: "too large for an example" };
  const answers = {
    no_fit: () => noFit(d, g, given.reference.map(Number)),
    minkowski_sum: () => minkowskiSum(read("a"), read("b")),
  };
  return Object.fromEntries(given.ask.map((part) => [part, answers[part]()]));
}

// Write each line at once, even into a pipe.
const say = (line) => process.stdout.write(JSON.stringify(line) + "\n");
const questions = ["no_fit", "minkowski_sum"];
say({ hello: "doubles.js", questions, shapes: "any", numbers: "binary64", reference: "given" });
const lines = readline.createInterface({ input: process.stdin });
lines.on("line", (line) => {
  const given = JSON.parse(line);
  if (given.bye) lines.close();
  else say({ id: given.id, ...answer(given) });
});

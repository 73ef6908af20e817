#!/usr/bin/env node
// Check certificates of version 3, as CERTIFICATES.md in this folder defines them.
//
//     node standalone.js FILE ...
//
// prints `proved: CLAIM` or `not proved: REASON` for each file, and exits with 0 if all are proved, else with 1.
// Written from that page alone, without dependencies. Numbers are fractions of BigInts; floating point only
// skips pairs whose boxes, rounded outward, are disjoint. (a) to (e) are the conditions of the page.
"use strict";

const refuse = (reason) => { throw new Error(reason); };
const need = (condition, reason) => condition || refuse(reason);

let steps = Infinity; // left for a file; a step takes about a microsecond
const spend = (n) => { steps -= n; need(steps >= 0, "too large: exceeds the step limit for its size"); };

// ---- Numbers: n/d with d > 0, not always in lowest terms; `size` bounds the digits of both.

function gcd(a, b, size) {
  for (; b; [a, b] = [b, a % b]) spend(0.2 + size / 500);
  return a < 0n ? -a : a;
}

class Q {
  constructor(n, d = 1n, size = 20) {
    spend(0.1 + size / 1000 + size ** 2 / 80000);
    Object.assign(this, { n, d, size });
  }
  plus(o) {
    if (this.d === o.d) return new Q(this.n + o.n, this.d, Math.max(this.size, o.size) + 1);
    return new Q(this.n * o.d + o.n * this.d, this.d * o.d, this.size + o.size + 1);
  }
  negated() { return new Q(-this.n, this.d, this.size); }
  minus(o) { return this.plus(o.negated()); }
  times(o) { return new Q(this.n * o.n, this.d * o.d, this.size + o.size); }
  over(o) {
    const sign = o.n > 0n ? 1n : o.n < 0n ? -1n : refuse("division by zero");
    return new Q(sign * this.n * o.d, sign * this.d * o.n, this.size + o.size);
  }
  sign() { return this.n > 0n ? 1 : this.n < 0n ? -1 : 0; }
  compare(o) { return this.minus(o).sign(); }
  absolute() { return this.n < 0n ? this.negated() : this; }
  reduced() {
    const g = this.d === 1n ? 1n : gcd(this.n, this.d, this.size), n = this.n / g, d = this.d / g;
    return new Q(n, d, n.toString(16).length + d.toString(16).length);
  }
  key() { spend((this.size + this.size ** 2 / 1000) / 100); const q = this.reduced(); return q.n + "/" + q.d; }
  bound(direction) { // a float below or above the number
    const n = Number(this.n), d = Number(this.d), slack = Math.abs(n / d) * 1e-14 + 1e-300;
    return d < Infinity && slack < 1e280 ? n / d + direction * slack : direction * Infinity; // sums do not overflow
  }
}

const [ZERO, ONE, TWO] = [0n, 1n, 2n].map((n) => new Q(n, 1n, 1));
const less = (a, b) => a.compare(b) < 0;
const largest = (list) => list.reduce((a, b) => (less(a, b) ? b : a));
const smallest = (list) => list.reduce((a, b) => (less(b, a) ? b : a));

// ---- Points, edges [from, to], and rings

const point = (x, y) => ({ x: x.reduced(), y: y.reduced() });
const plus = (p, q) => point(p.x.plus(q.x), p.y.plus(q.y));
const minus = (p, q) => ({ x: p.x.minus(q.x), y: p.y.minus(q.y) });
const opposite = (p) => ({ x: p.x.negated(), y: p.y.negated() });
const cross = (u, v) => u.x.times(v.y).minus(u.y.times(v.x));
const dot = (u, v) => u.x.times(v.x).plus(u.y.times(v.y));
const lexicographic = (p, q) => p.x.compare(q.x) || p.y.compare(q.y);
const same = (p, q) => lexicographic(p, q) === 0;
const pointKey = (p) => p.x.key() + " " + p.y.key();
const edgesOf = (ring) => ring.map((p, i) => [p, ring[(i + 1) % ring.length]]);
const vectorOf = ([a, b]) => minus(b, a);
const reversed = (ring) => [...ring].reverse();
const along = ([a, b], t) => plus(a, { x: b.x.minus(a.x).times(t), y: b.y.minus(a.y).times(t) });
const side = (edge, p) => cross(vectorOf(edge), minus(p, edge[0])).sign(); // 1: p is on the left
const doubleArea = (ring) => edgesOf(ring).reduce((sum, e) => sum.plus(cross(...e)).reduced(), ZERO);

const ORIGIN = { x: ZERO, y: ZERO };
const mean = (points) => along([ORIGIN, points.reduce(plus)], new Q(1n, BigInt(points.length)));

function lineKey([p, q]) {
  const u = minus(q, p), slope = u.x.sign() ? u.y.over(u.x).reduced() : null;
  return slope ? slope.key() + " " + p.y.minus(slope.times(p.x)).key() : "vertical " + p.x.key();
}

function boxOf(points) { // [-left, right, -bottom, top], as floats, rounded outward
  const outward = (name, direction) => Math.max(...points.map((p) => direction * p[name].bound(direction)));
  return [outward("x", -1), outward("x", 1), outward("y", -1), outward("y", 1)];
}
const meet = (a, b) => -a[0] <= b[1] && -b[0] <= a[1] && -a[2] <= b[3] && -b[2] <= a[3];

function forNearPairs(items, visit) { // all pairs whose boxes meet
  const sorted = [...items].sort((a, b) => (a.box[0] > b.box[0] ? -1 : a.box[0] < b.box[0] ? 1 : 0));
  sorted.forEach((a, m) => {
    for (let k = m + 1; k < sorted.length && -sorted[k].box[0] <= a.box[1]; k++) {
      spend(0.05);
      if (meet(a.box, sorted[k].box)) visit(a, sorted[k]);
    }
  });
}

function winding(rings, z) {
  let number = 0;
  for (const [p, q] of rings.flatMap(edgesOf)) {
    const isUp = p.y.compare(z.y) <= 0;
    if (isUp !== q.y.compare(z.y) <= 0 && side(isUp ? [p, q] : [q, p], z) > 0) number += isUp ? 1 : -1;
  }
  return number;
}

const isUpper = (u) => (u.y.sign() || u.x.sign()) > 0; // its angle is below pi
const byAngle = (u, v) => isUpper(v) - isUpper(u) || -cross(u, v).sign();

function checkPiece(ring) {
  const vectors = edgesOf(ring).map(vectorOf), next = (i) => vectors[(i + 1) % vectors.length];
  need(vectors.every((u, i) => cross(u, next(i)).sign() > 0), "a piece does not turn left at every vertex");
  need(vectors.filter((u, i) => !isUpper(u) && isUpper(next(i))).length === 1, "a piece turns more than once");
}

function checkMakesUp(pieces, rings) {
  pieces.forEach(checkPiece);
  const ends = (of, k) => of.flatMap(edgesOf).map((edge) => lineKey(edge) + " " + pointKey(edge[k]));
  const [starts, stops] = [0, 1].map((k) => [...ends(pieces, k), ...ends(rings, 1 - k)].sort().join());
  need(starts === stops, "pieces do not cancel to the edges of their shape");
  const separates = (a, b) => edgesOf(a).some((e) => b.every((p) => side(e, p) <= 0));
  forNearPairs(pieces.map((ring) => ({ ring, box: boxOf(ring) })), ({ ring: a }, { ring: b }) =>
    need(separates(a, b) || separates(b, a), "two pieces overlap"));
}

// ---- Sums of convex pieces and intervals of edges

function minkowski(a, b) { // the edges of the sum
  const vectors = [a, b].flatMap(edgesOf).map(vectorOf).sort(byAngle);
  const lowest = (ring) => ring.reduce((p, q) => ((q.y.compare(p.y) || q.x.compare(p.x)) < 0 ? q : p));
  const vertices = [plus(lowest(a), lowest(b))];
  vectors.forEach((u, i) => {
    const end = plus(vertices.at(-1), u);
    if (i && byAngle(vectors[i - 1], u) === 0) vertices.pop();
    vertices.push(end);
  });
  return edgesOf(vertices.slice(0, -1));
}

const leftOf = (edge) => [edge[0], vectorOf(edge)]; // the half-plane of all z with u x (z - p) > 0, as [p, u]

function segment([p, q]) { // the closed half-planes whose intersection is a segment, or a point
  const v = same(p, q) ? { x: ONE, y: ZERO } : minus(q, p), u = { x: v.y, y: v.x.negated() };
  return [[p, v], [p, opposite(v)], [p, u], [q, opposite(u)]];
}

function clip([a, b], planes, isClosed) { // the interval of all t in [0, 1] with a + t (b - a) in all planes, or null
  let low = { t: ZERO, closed: true }, high = { t: ONE, closed: true };
  for (const [p, u] of planes) {
    const fa = cross(u, minus(a, p)), fb = cross(u, minus(b, p));
    const [hasA, hasB] = [fa, fb].map((f) => f.sign() >= (isClosed ? 0 : 1));
    if (!hasA && !hasB) return null;
    const t = hasA && hasB ? null : fa.over(fa.minus(fb)).reduced();
    if (!hasA && !less(t, low.t)) low = { t, closed: isClosed };
    if (!hasB && !less(high.t, t)) high = { t, closed: isClosed };
  }
  const order = low.t.compare(high.t);
  return order < 0 || (order === 0 && isClosed) ? { low, high } : null;
}
const common = (edge, other) => clip(edge, segment(other), true);

function covers(intervals) { // whether their union contains [0, 1]
  let reach = { t: ZERO, closed: false };
  const found = intervals.filter((interval) => interval);
  for (const { low, high } of found.sort((a, b) => a.low.t.compare(b.low.t) || b.low.closed - a.low.closed)) {
    const start = low.t.compare(reach.t);
    if (start > 0 || (start === 0 && !low.closed && !reach.closed)) return false;
    if ((high.t.compare(reach.t) || high.closed - reach.closed) > 0) reach = high;
  }
  return reach.closed && !less(reach.t, ONE);
}

// ---- The lemma: `entries` ({sides, planes, chains}) prove loops and fits with winding number w.

function checkNoneInside(first, second, known) { // (a)
  const boxes = second.map(boxOf), outward = (v, w) => v + w + 1e-14 * (Math.abs(v) + Math.abs(w));
  first.forEach((a) => second.forEach((b, j) => {
    const box = boxOf(a).map((v, i) => outward(v, boxes[j][i])), near = known.filter((e) => meet(box, e.box));
    spend(0.02 * known.length);
    const planes = near.length ? minkowski(a, b).map(leftOf) : [];
    need(near.every((e) => !clip(e.edge, planes, false)), "a sum contains a point of a known edge");
  }));
}

function checkChains(entries, known) { // (b), (c)
  const named = known.map(() => []);
  for (const { sides, chains } of entries) {
    need(sides.length === chains.length, "a sum does not have a chain for each of its sides");
    sides.forEach((s, i) => need(covers(chains[i].map((name) => {
      need(name < entries.length && -1 - name < known.length, "a chain names nothing");
      if (name >= 0) return clip(s, entries[name].planes, false);
      named[-1 - name].push(s);
      return common(s, known[-1 - name].edge);
    })), "a side is not covered by its chain"));
  }
  known.forEach(({ edge, loop, isPoint }, n) => {
    for (const direction of loop < 0 && !isPoint ? [1, -1] : [1]) {
      const u = vectorOf(edge), hasDirection = (v) => cross(u, v).sign() === 0 && dot(u, v).sign() === direction;
      const sides = named[n].filter((s) => isPoint || hasDirection(vectorOf(s)));
      need(covers(sides.map((s) => common(edge, s))), "a known edge is not covered by sides along it");
    }
  });
}

function groupsOf(pieces) { // a piece of each group
  const parent = pieces.map((_, i) => i), seen = new Map();
  const root = (i) => { while (parent[i] !== i) i = parent[i] = parent[parent[i]]; return i; };
  pieces.forEach((piece, i) => piece.map(pointKey).forEach((key) => {
    if (seen.has(key)) parent[root(i)] = root(seen.get(key));
    else seen.set(key, i);
  }));
  return pieces.filter((_, i) => parent[i] === i);
}

function checkMeetings(known) { // (e)
  const meetings = new Map();
  forNearPairs(known, (e, f) => {
    const met = common(e.edge, f.edge);
    if (!met) return;
    need(!e.isPoint && !f.isPoint, "a fit of one point is on a known edge");
    need(met.low.t.compare(met.high.t) === 0, "two known edges overlap");
    const distance = Math.abs(e.i - f.i), areNeighbors = distance === 1 || distance === e.length - 1;
    need(e.loop < 0 || e.loop !== f.loop || areNeighbors, "two edges of a loop meet");
    if (e.region === undefined || e.region !== f.region || e.loop === f.loop) return;
    const p = pointKey(along(e.edge, met.low.t)), pair = [e.loop, f.loop].sort().join();
    need((meetings.get(pair) ?? p) === p, "two loops of a region meet at two points");
    meetings.set(pair, p);
  });
}

function checkSums(first, second, sums, loops, fits, { w = 1, regions = [], more = [] } = {}) {
  const read = (loop, length = 0) => (edge, i) =>
    ({ edge, i, loop, length, isPoint: same(...edge), box: boxOf(edge), region: regions[loop] });
  const known = [...loops.flatMap((loop, n) => edgesOf(loop).map(read(n, loop.length))), ...fits.map(read(-1))];
  const listed = sums.map(([k, ...chains]) => {
    need(k >= 0 && k < first.length * second.length, "no sum has that number");
    return { sides: minkowski(first[Math.floor(k / second.length)], second[k % second.length]), chains };
  });
  checkMeetings(known);
  checkNoneInside(first, second, known);
  checkChains([...listed, ...more].map((entry) => ({ ...entry, planes: entry.sides.map(leftOf) })), known);
  const [as, bs] = first[0]?.length === 2 ? [first.slice(0, 1), second] : [first, second].map(groupsOf); // (d)
  const isWound = (a, b) => winding(loops, plus(mean(a), mean(b))) === w;
  need(as.every((a) => bs.every((b) => isWound(a, b))), "the winding number of a group of sums is wrong");
}

// ---- Reading: a reader takes a parsed value and returns it, or refuses it.

function parse(json) { // integers only, no duplicate keys
  const value = JSON.parse(json), token = /"(?:[^"\\]|\\.)*"([ \t\n\r]*:)?|-?\d[\d.eE+-]*/g;
  const countKeys = (of) => [...of.matchAll(token)].filter(([, colon]) => colon).length;
  for (const [found] of json.matchAll(token)) need(/^"|^-?\d+$/.test(found), "a number with a fraction or an exponent");
  need(countKeys(json) === countKeys(JSON.stringify(value)), "a duplicate key");
  return value;
}

const optional = (reader, otherwise) => (value) => (value === undefined || value === null ? otherwise : reader(value));
const object = (readers) => (value) => { // every reader that is not optional refuses undefined and null
  need(typeof value === "object" && value !== null && !Array.isArray(value), "not an object");
  for (const key of Object.keys(value)) need(Object.hasOwn(readers, key), "an unknown key: " + key);
  return Object.fromEntries(Object.entries(readers).map(([key, reader]) => [key, reader(value[key])]));
};
const listOf = (reader, least = 0, most = Infinity) => (value) => {
  need(Array.isArray(value) && value.length >= least && value.length <= most, "not a list, or of a wrong length");
  return value.map((item) => reader(item));
};
const kind = (test, name, reader = (value) => value) => (value) => {
  const found = reader(value);
  return need(test(found), "not " + name) && found;
};
const text = kind((value) => typeof value === "string", "a string");
const flag = kind((value) => typeof value === "boolean", "true or false");
const isIndex = (value) => Number.isInteger(value) && Math.abs(value) < 1e9;
const index = kind(isIndex, "an integer, or too large", (value) => value === 0 ? 0 : value); // not -0
const number = (value) => {
  need(text(value).length <= 100000 && value !== "-0", "not a number, or too long");
  const [, n, d] = /^(-?(?:0|[1-9][0-9]*))(?:\/([1-9][0-9]*))?$/.exec(value) ?? refuse("not a number");
  const q = new Q(BigInt(n), BigInt(d ?? 1), value.length);
  need(!d || (q.d > 1n && gcd(q.n, q.d, q.size) === 1n), "a fraction is not in lowest terms");
  return q;
};
const length = kind((q) => q.sign() >= 0, "a length", number);
const vertex = (value) => { const [x, y] = listOf(number, 2, 2)(value); return { x, y }; };
const distinct = (from) => (value) => listOf(vertex)(value).filter((p, i, all) => i < from || !same(p, all.at(i - 1)));
const ring = kind((points) => points.length > 2, "a ring of three points", distinct(0));
const path = kind((points) => points.length > 1, "a path of two points", distinct(1));
const loop = kind((points) => new Set(points.map(pointKey)).size === points.length && doubleArea(points).sign() > 0,
  "a loop: a repeated point, or not counter-clockwise", listOf(vertex, 3));
const loops = listOf(loop), fits = listOf(listOf(vertex, 2, 2)), pieces = listOf(ring, 1), outside = listOf(ring);
const frame = listOf(number, 4, 4), chain = listOf(index);
const sums = listOf((value) => {
  const [k, chains] = listOf((item) => item, 2, 2)(value);
  return [index(k), ...listOf(chain)(chains)];
});
const shapeKeys = { exterior: ring, holes: optional(listOf(ring), []) }, shape = object(shapeKeys);
const exactly = (constant) => kind((value) => value === constant, constant);
const header = { format: exactly("exactsweep certificate"), version: exactly(3), claim: text };

const orient = (r, k) => (k > 0 === doubleArea(r).sign() > 0 ? reversed(r) : r); // ring 0 is the exterior
const ringsOf = ({ exterior, holes }) => [exterior, ...holes].map(orient);

function rectangle([left, bottom, right, top]) {
  need(less(left, right) && less(bottom, top), "a rectangle without interior");
  return [[left, bottom], [right, bottom], [right, top], [left, top]].map(([x, y]) => ({ x, y }));
}

// ---- Claims about polygons

const noFitKeys = { ...header, directrix: shape, generatrix: shape, exterior: loop, holes: loops, exact_fits: fits };
const noFitProof = { directrix: pieces, generatrix: pieces, sums };
const negated = (rings) => rings.map((r) => r.map(opposite));

function checkNoFit(c) {
  const { directrix, generatrix } = c.proof;
  checkMakesUp(directrix, ringsOf(c.directrix));
  checkMakesUp(generatrix, ringsOf(c.generatrix));
  checkSums(directrix, negated(generatrix), c.proof.sums, [c.exterior, ...c.holes.map(reversed)], c.exact_fits);
  return "no-fit polygon";
}

const proveNoFit = (value) => checkNoFit(object({ ...noFitKeys, proof: object(noFitProof) })(value));

function proveSweep(value) {
  const proof = object({ ...noFitProof, swept: sums, slits: fits });
  const c = object({ ...noFitKeys, outer: loop, inner: loop, unswept: loops, area: number, proof })(value);
  const swept = [c.outer, reversed(c.inner), ...c.unswept.map(reversed)];
  checkNoFit(c);
  checkSums(edgesOf(c.exterior), c.proof.generatrix, c.proof.swept, swept, c.proof.slits);
  need(winding([c.inner], mean(c.proof.directrix[0])) === 1, "the directrix is not within the inner loop");
  const area = swept.map(doubleArea).reduce((a, b) => a.plus(b).reduced());
  need(c.area.times(TWO).compare(area) === 0, "the area is wrong");
  return "sweep";
}

function proveSum(value) {
  const proof = object({ shape: pieces, sums, slits: fits });
  const c = object({ ...header, shape, path, exterior: loop, holes: loops, proof })(value);
  checkMakesUp(c.proof.shape, ringsOf(c.shape));
  const segments = edgesOf(c.path).slice(0, -1), loopsOfSum = [c.exterior, ...c.holes.map(reversed)];
  checkSums(segments, c.proof.shape, c.proof.sums, loopsOfSum, c.proof.slits);
  return "sum of a shape and a path";
}

function checkHoles(region) { // directed as in the proof: exterior clockwise, holes counter-clockwise
  for (const hole of region.slice(1)) { // points on a downward edge are inside; another loop has at most one of them
    const down = edgesOf(hole).find(([p, q]) => less(q.y, p.y)), at = (k) => along(down, new Q(1n, k));
    need([2n, 3n].every((k) => winding(region, at(k)) === 0), "a hole is not in its region");
  }
}

function proveInnerFit(value) {
  const proof = object({ frame, outside, part: pieces, sums, around: listOf(chain, 4, 4) });
  const region = object({ exterior: loop, holes: loops });
  const keys = { ...header, container: shape, part: shape, regions: listOf(region), exact_fits: fits, proof };
  const c = object(keys)(value), { part, around } = c.proof;
  checkMakesUp(c.proof.outside, [rectangle(c.proof.frame), ...ringsOf(c.container).map(reversed)]);
  checkMakesUp(part, ringsOf(c.part));
  const ends = [smallest, smallest, largest, largest].map((end, i) => end(part.flat().map((p) => (i % 2 ? p.y : p.x))));
  const within = rectangle(c.proof.frame.map((n, i) => n.minus(ends[i]).reduced()));
  const planes = edgesOf(within).map(reversed), isWithin = (p) => planes.every((plane) => side(plane, p) <= 0);
  const regions = c.regions.map(({ exterior, holes }) => [reversed(exterior), ...holes]);
  checkSums(c.proof.outside, negated(part), c.proof.sums, regions.flat(), c.exact_fits, {
    w: 0, regions: regions.flatMap((region, n) => region.map(() => n)),
    more: planes.map((plane, i) => ({ sides: [plane], chains: [around[i]] })),
  });
  need([...regions.flat(2), ...c.exact_fits.flat()].every(isWithin), "a known edge is not in B");
  regions.forEach(checkHoles);
  return "inner fit of " + regions.length + " regions";
}

// ---- Layouts

const UNIT = 10n ** 100n; // fixed point for sines of degrees
const PI = 31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679n;
const SLACK = new Q(1n, 10n ** 90n, 91); // far above their error

function cosineAndSine(degrees) { // by their series
  const x = ((degrees.n * UNIT) / degrees.d) * PI / (180n * UNIT), values = [0n, 0n];
  for (let k = 0n, term = UNIT; term; k++, term = (term * x) / UNIT / k) values[k % 2n] += k % 4n < 2n ? term : -term;
  return values.map((n) => new Q(n, UNIT, 101));
}

const unit = kind((p) => dot(p, p).compare(ONE) === 0, "a cosine and a sine", vertex);
function rotation(value) { // {key, exact: cosine and sine} if these are rational, else {key, degrees}
  if (Array.isArray(value)) return { key: pointKey(unit(value)), exact: unit(value) };
  const q = number(value), full = 360n * q.d, degrees = new Q(((q.n % full) + full) % full, q.d, q.size + 3);
  if (q.d !== 1n || degrees.n % 90n) return { key: "degrees " + degrees.key(), degrees };
  return rotation([["1", "0"], ["0", "1"], ["-1", "0"], ["0", "-1"]][degrees.n / 90n]);
}
const rounded = (value) => {
  const { points, radius } = object({ points: listOf(vertex, 1), radius: optional(length, ZERO) })(value);
  if (points.length > 2) checkPiece(points);
  return { rings: [points], radius };
};
const isBody = (of) => (of.pieces ? !of.exterior && !of.holes.length : of.exterior);
const body = (keys, least = 1, most = Infinity) => kind(isBody, "either an exterior or rounded pieces", object({
  ...keys, ...shapeKeys, exterior: optional(ring), error: optional(length, ZERO),
  pieces: optional(listOf(rounded, least, most)),
}));
const turns = optional(listOf(rotation)), demand = kind((n) => n >= 0, "a demand", index);
const partKeys = { id: text, demand: optional(demand), turns, mirrored_turns: turns, mirrored: optional(flag, true) };
const motion = { move: vertex, turn: optional(rotation, rotation("0")), mirrored: optional(flag, false) };
const layoutReader = object({
  container: optional(body({}, 0, 1), { pieces: [], error: ZERO }), parts: listOf(body(partKeys)),
  placements: listOf(object({ part: text, ...motion })),
  defects: optional(listOf(body({ spacing: optional(length) })), []),
  spacing: optional(length, ZERO), margin: optional(length, ZERO),
});
const apart = listOf((value) => {
  const [x, y] = listOf((item) => item, 6, 6)(value).slice(4);
  return { of: value.slice(0, 4).map(index), normal: vertex([x, y]) };
});
const layoutProof = object({ frame: optional(frame), pieces: listOf(optional(outside, [])), apart });
const RULES = { // when the placements of a part violate a rule
  missing: (part) => part.used.length < part.demand, // false without a demand
  surplus: (part) => part.used.length > part.demand,
  mirror: (part) => !part.mirrored && part.used.some((use) => use.mirrored),
  turn: (part) => part.used.some((use) => !use.isAllowed),
};

function fault(value) {
  const name = value?.kind, ofPart = { kind: text, part: text };
  if (Object.hasOwn(RULES, name)) return object(ofPart)(value);
  if (name === "shape") return object({ ...ofPart, point: vertex })(value);
  return object({ kind: text, placements: listOf(index, 2, 2), point: vertex })(value);
}

function solidsOf(item, list, around) { // a list of pieces in a proof
  const rings = item.pieces ? [] : around ?? ringsOf(item);
  need(!list || (item.pieces ? !list.length : list.length || around), "not a list of pieces for each shape");
  if (item.pieces || !list) return item.pieces ?? [{ rings, radius: ZERO }];
  checkMakesUp(list, rings);
  return list.map((piece) => ({ rings: [piece], radius: ZERO }));
}

function place({ part: id, turn, move, mirrored }, to, parts) {
  const part = parts.get(id) ?? refuse("a placement of an unknown part"), { key, exact, degrees } = turn;
  let { error } = part;
  need(!exact || same(exact, to), "an entry of `turns` is not the rotation of its placement");
  if (degrees) {
    const [c, s] = cosineAndSine(degrees), e = to.x.minus(c).absolute().plus(to.y.minus(s).absolute()).plus(SLACK);
    const radii = part.solids.flatMap(({ rings }) => rings.flat()).map((p) => p.x.absolute().plus(p.y.absolute()));
    error = error.plus(e.times(largest(radii))).reduced();
  }
  const allowed = (mirrored && part.mirrored_turns) || part.turns;
  part.used.push({ mirrored, isAllowed: !allowed || allowed.some((one) => one.key === key) });
  const u = { x: to.x, y: to.y.negated() }, rotate = (p) => plus({ x: dot(u, p), y: cross(u, p) }, move);
  const put = (r) => (mirrored ? reversed(r).map(({ x, y }) => rotate({ x: x.negated(), y })) : r.map(rotate));
  return { error, solids: part.solids.map(({ rings, radius }) => ({ rings: rings.map(put), radius })) };
}

function readBodies({ layout, valid, proof, turns: used }) { // parts by id, bodies by number
  const { parts: listed, placements, container, defects, spacing, margin } = layout;
  const { frame: given, pieces: cut = [] } = proof ?? {}, others = cut.slice(listed.length);
  const isComplete = !valid || others.length === defects.length + 1;
  need(isComplete && used.length === placements.length, "not an entry for each part, placement or obstacle");
  need(!valid || !given === Boolean(container.pieces), "a frame is for a container that is a shape");
  const read = (part, i) => [part.id, { ...part, used: [], solids: solidsOf(part, cut[i]) }];
  const parts = new Map(listed.map(read)), around = given && [rectangle(given), ...ringsOf(container).map(reversed)];
  need(parts.size === listed.length, "two parts with one id");
  const placed = placements.map((to, n) => ({ n, room: spacing, ...place(to, used[n], parts) }));
  const obstacles = [container, ...defects].map((one, i) => {
    const solids = solidsOf(one, others[i], i ? undefined : around), isOutside = !i && !given;
    return { n: -1 - i, room: one.spacing ?? margin, error: one.error, solids, isOutside };
  });
  return { parts, bodies: new Map([...placed, ...obstacles].map((one) => [one.n, one])) };
}

function squaredDistance(edge, p) {
  const u = vectorOf(edge), projection = dot(u, minus(p, edge[0]));
  const t = projection.sign() > 0 ? smallest([ONE, projection.over(dot(u, u)).reduced()]) : ZERO;
  const w = minus(p, along(edge, t));
  return dot(w, w);
}

function boundaryOf(edges) { // the segments left after cancellation; all edges of a point or a segment
  const keys = edges.map(lineKey), lines = new Map(keys.map((key) => [key, []])), found = [];
  edges.forEach(([p, q], i) => lines.get(keys[i]).push([p, 1], [q, -1]));
  for (const ends of lines.values()) {
    ends.sort(([p], [q]) => lexicographic(p, q)).reduce((n, [p, sign], i) => {
      if (n && !same(ends[i - 1][0], p)) found.push([ends[i - 1][0], p]);
      return n + sign;
    }, 0);
  }
  return found.length ? found : edges;
}

function isDeep({ solids, isOutside }, z, depth) { // whether the depth of z in a body is above `depth`
  return solids.some(({ rings, radius }) => {
    const isIn = winding(rings, z) === (isOutside ? 0 : 1), d = isOutside ? depth.plus(radius) : depth.minus(radius);
    const nearest = smallest(boundaryOf(rings.flatMap(edgesOf)).map((e) => squaredDistance(e, z))), square = d.times(d);
    return isIn ? d.sign() < 0 || less(square, nearest) : d.sign() < 0 && less(nearest, square);
  });
}

function isProved({ kind: name, part: id, placements, point: z }, parts, bodies) {
  const part = id === undefined ? null : parts.get(id) ?? refuse("a fault of an unknown part");
  if (part) return z ? part.solids.some(({ rings }) => ![0, 1].includes(winding(rings, z))) : RULES[name](part);
  const [a, b] = placements.map((n) => bodies.get(n) ?? refuse("no body has that number"));
  const half = b.room.minus(a.error).minus(b.error).over(TWO);
  const both = (test) => a !== b && a.n >= 0 && [a, b].every(test);
  if (name === "too close") return half.sign() > 0 && both((one) => isDeep(one, z, half.negated()));
  return name === (b.n < 0 ? "outside" : "overlap") && both((one) => isDeep(one, z, one.error));
}

const AXES = [[1n, 0n], [0n, 1n], [-1n, 0n], [0n, -1n]].map(([x, y]) => ({ x: new Q(x), y: new Q(y) }));

function isFar(n, one, other, s) { // whether a normal proves that two pieces are at distance s
  const gap = smallest(other.map((v) => dot(n, v))).minus(largest(one.map((v) => dot(n, v)))), squared = dot(n, n);
  return squared.sign() > 0 && gap.sign() >= 0 && !less(gap.times(gap), s.times(s).times(squared));
}

function checkValid({ proof, layout }, parts, bodies) {
  const broken = Object.keys(RULES).filter((name) => [...parts.values()].some(RULES[name]));
  need(!broken.length, "valid, but rules are violated: " + broken);
  const normals = new Map(proof.apart.map(({ of, normal }) => [of.join(), normal]));
  const solids = [], outer = bodies.get(-1);
  const corners = proof.frame && rectangle(proof.frame);
  const reach = largest([...bodies.values()].map((one) => one.room)).over(TWO);
  for (const one of bodies.values()) {
    for (const [i, { rings: [points], radius }] of one.solids.entries()) {
      const r = one.error.plus(radius), s = outer.room.plus(outer.error).plus(r), wide = reach.plus(r).bound(1);
      const isInside = corners ? AXES.every((n, k) => isFar(n, points, [corners[k < 2 ? 2 : 0]], s))
        : !points.some((p) => isDeep(outer, p, s.negated()));
      need(one.n < 0 || isInside, "a placement is not within the container");
      const box = boxOf(points).map((v) => v + wide + Math.abs(v + wide) * 1e-15);
      if (one !== outer || corners) solids.push({ one, i, points, radius, box });
    }
  }
  forNearPairs(solids, (p, q) => {
    const [a, b] = p.one.n < q.one.n ? [p, q] : [q, p], [i, j] = [a.one.n, b.one.n];
    if (i === j || j < 0) return;
    const s = [a.one.error, b.one.error, a.radius, b.radius].reduce((sum, r) => sum.plus(r), a.one.room);
    const listed = normals.get([i, a.i, j, b.i].join()) ?? normals.get([i, -1, j, -1].join());
    const isApart = [...(listed ? [listed] : []), ...AXES].some((n) => isFar(n, a.points, b.points, s));
    need(isApart, "two pieces are not apart");
  });
  return "valid layout of " + layout.placements.length + " placements";
}

function proveLayout(value) {
  const evidence = { proof: optional(layoutProof), faults: optional(listOf(fault, 1)) };
  const c = object({ ...header, layout: layoutReader, turns: listOf(unit), valid: flag, ...evidence })(value);
  need(c.valid ? c.proof && !c.faults : c.faults && !c.proof, "not a proof if valid, and faults if not");
  const { parts, bodies } = readBodies(c);
  if (c.valid) return checkValid(c, parts, bodies);
  for (const f of c.faults) need(isProved(f, parts, bodies), "a fault is not proved: " + f.kind);
  return c.faults.length + " faults of a layout of " + c.layout.placements.length + " placements";
}

// ---- Main

const PROVERS = { no_fit: proveNoFit, sweep: proveSweep, sum: proveSum, inner_fit: proveInnerFit, layout: proveLayout };

function prove(bytes) {
  steps = 5e6 + 150 * bytes.length;
  const value = parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  need(Object.hasOwn(PROVERS, value?.claim), "not a claim");
  return PROVERS[value.claim](value);
}

process.exitCode = process.argv.length > 2 ? 0 : 1;
for (const file of process.argv.slice(2)) {
  try {
    console.log("proved: " + prove(require("node:fs").readFileSync(file)));
  } catch (error) {
    process.exitCode = 1;
    console.log("not proved: " + String(error?.message ?? error).split("\n")[0]);
  }
}

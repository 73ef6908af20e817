#!/usr/bin/env node
// Check certificates of version 3, as CERTIFICATES.md beside this file describes them.
//
//     node standalone.js FILE ...
//
// prints a line for each file, `proved: CLAIM` or `not proved: REASON`, and exits with 0 if all are
// proved, else with 1. Whatever a file makes happen, nothing is proved then. Written from that page
// alone, with no line of standalone.py; no dependency. Numbers are fractions of BigInts; floating
// point only skips pairs whose boxes, rounded outwards, are apart. Letters (a) to (e) are the
// conditions of the page.
"use strict";

class Refused extends Error {}
const refuse = (reason) => { throw new Refused(reason); };
const need = (condition, reason) => condition || refuse(reason);

// ---- Work: steps are charged as they cost, about a microsecond each.

let steps = Infinity; // for a file: 5e6, and 150 for each of its bytes
const spend = (n) => { steps -= n; need(steps >= 0, "too much work for the size of the file"); };

// ---- Numbers: n/d with d > 0, not always in lowest terms; `size` bounds the digits of both.

function gcd(a, b, size) {
  while (b) {
    spend(0.2 + size / 500);
    [a, b] = [b, a % b];
  }
  return a < 0n ? -a : a;
}

class Q {
  constructor(n, d = 1n, size = 20) {
    spend(0.1 + size / 1000);
    Object.assign(this, { n, d, size });
  }
  product(o) { spend((this.size * o.size) / 20000); return this.size + o.size; }
  plus(o) {
    if (this.d === o.d) return new Q(this.n + o.n, this.d, Math.max(this.size, o.size) + 1);
    const size = this.product(o) + 1;
    return new Q(this.n * o.d + o.n * this.d, this.d * o.d, size);
  }
  negated() { return new Q(-this.n, this.d, this.size); }
  minus(o) { return this.plus(o.negated()); }
  times(o) { const size = this.product(o); return new Q(this.n * o.n, this.d * o.d, size); }
  over(o) {
    const size = this.product(o), sign = o.n < 0n ? -1n : 1n;
    need(o.n !== 0n, "division by zero");
    return new Q(sign * this.n * o.d, sign * this.d * o.n, size);
  }
  sign() { return this.n > 0n ? 1 : this.n < 0n ? -1 : 0; }
  compare(o) { return this.minus(o).sign(); }
  absolute() { return this.n < 0n ? this.negated() : this; }
  reduced() {
    const g = this.d === 1n ? 1n : gcd(this.n, this.d, this.size);
    return g === 1n ? this : new Q(this.n / g, this.d / g, this.size);
  }
  key() { spend((this.size + this.size * this.size / 1000) / 100); const q = this.reduced(); return q.n + "/" + q.d; }
  bounds() { // two floats around the number
    const n = Number(this.n), d = Number(this.d), slack = Math.abs(n / d) * 1e-14 + 1e-300;
    return Number.isFinite(n) && Number.isFinite(d) ? [n / d - slack, n / d + slack] : [-Infinity, Infinity];
  }
}

const [ZERO, ONE, TWO] = [0n, 1n, 2n].map((n) => new Q(n, 1n, 1));
const less = (a, b) => a.compare(b) < 0;
const largest = (list) => list.reduce((a, b) => (less(a, b) ? b : a));
const smallest = (list) => list.reduce((a, b) => (less(b, a) ? b : a));

// ---- Points and rings

const point = (x, y) => ({ x: x.reduced(), y: y.reduced() });
const plus = (p, q) => point(p.x.plus(q.x), p.y.plus(q.y));
const difference = (p, q) => ({ x: p.x.minus(q.x), y: p.y.minus(q.y) });
const opposite = (p) => ({ x: p.x.negated(), y: p.y.negated() });
const cross = (u, v) => u.x.times(v.y).minus(u.y.times(v.x));
const dot = (u, v) => u.x.times(v.x).plus(u.y.times(v.y));
const lexicographic = (p, q) => p.x.compare(q.x) || p.y.compare(q.y);
const same = (p, q) => lexicographic(p, q) === 0;
const pointKey = (p) => p.x.key() + " " + p.y.key();
const edgesOf = (ring) => ring.map((p, i) => [p, ring[(i + 1) % ring.length]]);
const vectorOf = ([a, b]) => difference(b, a);
const reversed = (ring) => [...ring].reverse();
const along = ([a, b], t) => plus(a, { x: b.x.minus(a.x).times(t), y: b.y.minus(a.y).times(t) });
const side = ([a, b], p) => cross(difference(b, a), difference(p, a)).sign(); // 1: p is on the left
const doubleArea = (ring) => edgesOf(ring).reduce((sum, e) => sum.plus(cross(...e)).reduced(), ZERO);

function mean(points) {
  const n = new Q(BigInt(points.length)), sum = points.reduce(plus);
  return point(sum.x.over(n), sum.y.over(n));
}

function extents(points) { // [left, bottom, right, top]
  const xs = points.map((p) => p.x), ys = points.map((p) => p.y);
  return [smallest(xs), smallest(ys), largest(xs), largest(ys)];
}
const boxOf = (points) => extents(points).map((q, i) => q.bounds()[i < 2 ? 0 : 1]); // floats, outwards
const isApart = (a, b) => a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1];

function winding(rings, z) {
  let number = 0;
  for (const [p, q] of rings.flatMap(edgesOf)) {
    const low = p.y.compare(z.y) <= 0, high = q.y.compare(z.y) <= 0;
    if (low && !high && side([p, q], z) > 0) number += 1;
    if (!low && high && side([q, p], z) > 0) number -= 1;
  }
  return number;
}

const isUpper = (u) => (u.y.sign() || u.x.sign()) > 0; // its angle is below pi

function checkPiece(ring) {
  const vectors = edgesOf(ring).map(vectorOf), next = (i) => vectors[(i + 1) % vectors.length];
  need(vectors.every((u, i) => cross(u, next(i)).sign() > 0), "a piece does not turn left at every vertex");
  const rounds = vectors.filter((u, i) => !isUpper(u) && isUpper(next(i)));
  need(rounds.length === 1, "a piece goes around more than once");
}

function checkMakesUp(pieces, rings) {
  pieces.forEach(checkPiece);
  const count = new Map();
  const add = (sign) => (ring) => edgesOf(ring).forEach(([p, q]) => {
    const u = difference(q, p), isVertical = u.x.sign() === 0;
    const slope = isVertical ? ZERO : u.y.over(u.x).reduced();
    const offset = isVertical ? p.x : p.y.minus(slope.times(p.x));
    const line = (isVertical ? "vertical " : slope.key() + " ") + offset.key() + " ";
    for (const [end, n] of [[p, sign], [q, -sign]]) {
      const key = line + pointKey(end);
      count.set(key, (count.get(key) ?? 0) + n);
    }
  });
  pieces.forEach(add(1));
  rings.forEach(add(-1));
  for (const n of count.values()) need(n === 0, "pieces do not have the edges of their shape");
  const boxes = pieces.map(boxOf);
  const separates = (a, b) => edgesOf(a).some((e) => b.every((p) => side(e, p) <= 0));
  pieces.forEach((a, i) => pieces.slice(0, i).forEach((b, j) => {
    spend(0.05);
    need(isApart(boxes[i], boxes[j]) || separates(a, b) || separates(b, a), "two pieces overlap");
  }));
}

// ---- Sums of convex pieces, by their sides; an open set is what is strictly left of all.

function walk(piece) { // its lowest vertex, the left one of two, and the edges from there on
  const isLower = (p, q) => (p.y.compare(q.y) || p.x.compare(q.x)) < 0;
  const first = piece.reduce((least, p, i) => (isLower(p, piece[least]) ? i : least), 0);
  const ring = [...piece.slice(first), ...piece.slice(0, first)];
  return [ring[0], edgesOf(ring).map(vectorOf)];
}

function minkowski(a, b) {
  const [p, us] = walk(a), [q, vs] = walk(b), vertices = [plus(p, q)];
  for (let i = 0, j = 0; i < us.length || j < vs.length;) {
    let order = i === us.length ? 1 : j === vs.length ? -1 : isUpper(vs[j]) - isUpper(us[i]);
    if (i < us.length && j < vs.length) order ||= -cross(us[i], vs[j]).sign();
    let next = vertices.at(-1);
    if (order <= 0) next = plus(next, us[i++]);
    if (order >= 0) next = plus(next, vs[j++]);
    vertices.push(next);
  }
  return edgesOf(vertices.slice(0, -1));
}

// Intervals of parameters t in [0, 1], of points a + t (b - a), or null. First: in an open convex set.
function within([a, b], planes) {
  let low = { t: ZERO, closed: true }, high = { t: ONE, closed: true };
  for (const plane of planes) {
    const u = vectorOf(plane), fa = cross(u, difference(a, plane[0])), fb = cross(u, difference(b, plane[0]));
    if (fa.sign() <= 0 && fb.sign() <= 0) return null;
    if (fa.sign() > 0 && fb.sign() > 0) continue;
    const t = fa.over(fa.minus(fb)).reduced();
    if (fa.sign() <= 0 && !less(t, low.t)) low = { t, closed: false };
    if (fb.sign() <= 0 && !less(high.t, t)) high = { t, closed: false };
    if (!less(low.t, high.t)) return null;
  }
  return { low, high };
}

function parameter([a, b], p) { // of a point of the line through a and b
  const u = difference(b, a), v = difference(p, a);
  return (u.x.sign() !== 0 ? v.x.over(u.x) : v.y.over(u.y)).reduced();
}

function common(segment, other) { // with a closed segment, which may be a point
  const u = vectorOf(segment), v = vectorOf(other), w = difference(other[0], segment[0]), turn = cross(u, v);
  let low, high;
  if (turn.sign() === 0) {
    if (side(segment, other[0]) !== 0) return null;
    const ends = other.map((p) => parameter(segment, p));
    [low, high] = [largest([ZERO, smallest(ends)]), smallest([ONE, largest(ends)])];
  } else {
    low = high = cross(w, v).over(turn).reduced();
    if ([low, cross(w, u).over(turn)].some((t) => t.sign() < 0 || less(ONE, t))) return null;
  }
  return less(high, low) ? null : { low: { t: low, closed: true }, high: { t: high, closed: true } };
}

function covers(intervals) { // whether their union contains [0, 1]
  let t = ZERO, included = false;
  for (const { low, high } of intervals.sort((a, b) => a.low.t.compare(b.low.t) || b.low.closed - a.low.closed)) {
    const start = low.t.compare(t), end = high.t.compare(t);
    if (start > 0 || (start === 0 && !low.closed && !included)) return false;
    if (end > 0) [t, included] = [high.t, high.closed];
    else if (end === 0) included ||= high.closed;
  }
  return included && !less(t, ONE);
}

// ---- The lemma: `entries` ({sides, chains}) prove loops and fits with winding number w.

function checkNoneInside(first, second, known) { // (a)
  const boxes = second.map(boxOf);
  const outwards = (v, w, i) => v + w + (i < 2 ? -1e-14 : 1e-14) * (Math.abs(v) + Math.abs(w));
  for (const a of first) {
    const box = boxOf(a);
    second.forEach((b, j) => {
      const bounds = box.map((v, i) => outwards(v, boxes[j][i], i));
      spend(0.02 * known.length);
      const near = known.filter((e) => !isApart(bounds, e.box));
      const sides = near.length ? minkowski(a, b) : [];
      need(near.every((e) => !within(e.edge, sides)), "a sum has a point of a known edge");
    });
  }
}

function checkChains(entries, known) { // (b), (c)
  const named = known.map(() => []);
  for (const { sides, chains } of entries) {
    need(sides.length === chains.length, "a sum does not have a chain for each of its sides");
    sides.forEach((s, i) => {
      const intervals = chains[i].map((name) => {
        need(name < entries.length && -1 - name < known.length, "a chain names nothing");
        if (name >= 0) return within(s, entries[name].sides);
        named[-1 - name].push(s);
        return common(s, known[-1 - name].edge);
      });
      need(covers(intervals.filter((met) => met)), "a side is not contained in what its chain names");
    });
  }
  known.forEach(({ edge, loop, isPoint }, n) => {
    if (isPoint) return need(named[n].some((s) => common(s, edge)), "no side has the point of a fit");
    const u = vectorOf(edge), isParallel = (v) => cross(u, v).sign() === 0;
    for (const direction of loop < 0 ? [1, -1] : [1]) {
      const sides = named[n].filter((s) => isParallel(vectorOf(s)) && dot(u, vectorOf(s)).sign() === direction);
      const intervals = sides.map((s) => common(edge, s)).filter((met) => met);
      need(covers(intervals), "a known edge is not covered by sides along it");
    }
  });
}

function groupsOf(pieces) { // a piece of each
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
  const sorted = [...known].sort((a, b) => (a.box[0] < b.box[0] ? -1 : a.box[0] > b.box[0] ? 1 : 0));
  sorted.forEach((e, m) => {
    for (let k = m + 1; k < sorted.length && sorted[k].box[0] <= e.box[2]; k++) {
      const f = sorted[k];
      spend(0.05);
      if (isApart(e.box, f.box)) continue;
      if (e.isPoint && f.isPoint) { need(!same(e.edge[0], f.edge[0]), "a fit repeats"); continue; }
      const met = e.isPoint ? common(f.edge, e.edge) : common(e.edge, f.edge);
      if (!met) continue;
      need(!e.isPoint && !f.isPoint, "a fit of one point is on a known edge");
      need(!less(met.low.t, met.high.t), "two known edges overlap");
      const distance = Math.abs(e.i - f.i), areNeighbours = distance === 1 || distance === e.length - 1;
      need(e.loop < 0 || e.loop !== f.loop || areNeighbours, "two edges of a loop meet");
      if (e.region === undefined || e.region !== f.region || e.loop === f.loop) continue;
      const p = pointKey(along(e.edge, met.low.t)), pair = Math.min(e.loop, f.loop) + " " + Math.max(e.loop, f.loop);
      need((meetings.get(pair) ?? p) === p, "two loops of a region meet at two points");
      meetings.set(pair, p);
    }
  });
}

function checkSums({ first, second, sums, more = [], loops, regions = [], fits, w, groups = [first, second].map(groupsOf) }) {
  const known = loops.flatMap((loop, n) => edgesOf(loop).map((edge, i) => ({ edge, loop: n, i, length: loop.length })));
  known.push(...fits.map((edge) => ({ edge, loop: -1, isPoint: same(...edge) })));
  for (const e of known) Object.assign(e, { box: boxOf(e.edge), region: regions[e.loop] });
  const entries = sums.map(({ number, chains }) => {
    need(number < first.length * second.length, "there is no sum of that number");
    const i = Math.floor(number / second.length);
    return { sides: minkowski(first[i], second[number % second.length]), chains };
  });
  checkMeetings(known);
  checkNoneInside(first, second, known);
  checkChains([...entries, ...more], known);
  for (const [a, b] of groups[0].flatMap((a) => groups[1].map((b) => [a, b]))) { // (d)
    const z = mean(minkowski(a, b).map(([p]) => p));
    need(winding(loops, z) === w, "the winding number of a group of sums is wrong");
  }
  return known;
}

// ---- Reading

const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
const countKeys = (value) => (typeof value !== "object" || value === null ? 0
  : Object.values(value).reduce((n, item) => n + countKeys(item), isObject(value) ? Object.keys(value).length : 0));

function parse(text) { // JSON with integers only, without duplicate keys
  const value = JSON.parse(text);
  let keys = 0;
  for (const [token, colon] of text.matchAll(/"(?:[^"\\]|\\.)*"([ \t\n\r]*:)?|-?\d[\d.eE+-]*/g)) {
    if (token[0] === '"') keys += colon ? 1 : 0;
    else need(/^-?\d+$/.test(token), "a number with a fraction or an exponent");
  }
  need(keys === countKeys(value), "a duplicate key");
  return value;
}

// Readers take a parsed value and return it, or refuse it.
const optional = (reader, otherwise) => Object.assign(
  (value) => (value === null || value === undefined ? otherwise : reader(value)), { isOptional: true });
const object = (readers) => (value) => {
  need(isObject(value), "not an object");
  for (const key of Object.keys(value)) need(Object.hasOwn(readers, key), "a key that has no meaning");
  return Object.fromEntries(Object.entries(readers).map(([key, reader]) => {
    need(Object.hasOwn(value, key) || reader.isOptional, "a key is missing: " + key);
    return [key, reader(Object.hasOwn(value, key) ? value[key] : undefined)];
  }));
};
const listOf = (reader, shortest = 0, longest = Infinity) => (value) => {
  need(Array.isArray(value) && value.length >= shortest && value.length <= longest, "not a list, or of a wrong length");
  return value.map((item) => reader(item));
};
const kind = (test, what) => (value) => { need(test(value), "not " + what); return value; };
const exactly = (constant) => kind((value) => value === constant, "the constant " + constant);
const text = kind((value) => typeof value === "string", "a string");
const flag = kind((value) => typeof value === "boolean", "true or false");
const index = (value) => {
  need(Number.isSafeInteger(value), "not an integer, or too large");
  return value + 0; // not -0
};
const natural = (value) => kind((n) => n >= 0, "a natural number")(index(value));
const number = (value) => {
  need(text(value).length <= 100000 && value !== "-0", "not a number, or too long");
  const [, n, d] = /^(-?(?:0|[1-9][0-9]*))(?:\/([1-9][0-9]*))?$/.exec(value) ?? refuse("not a number");
  spend(value.length ** 1.5 / 1000);
  const q = new Q(BigInt(n), BigInt(d ?? 1), value.length);
  need(!d || (q.d > 1n && gcd(q.n, q.d, q.size) === 1n), "a fraction is not in lowest terms");
  return q;
};
const distance = (value) => kind((q) => q.sign() >= 0, "a distance")(number(value));
const vertex = (value) => { const [x, y] = listOf(number, 2, 2)(value); return { x, y }; };
const ring = (value) => {
  const points = listOf(vertex)(value).filter((p, i, all) => !same(p, all.at(i - 1)));
  need(points.length >= 3, "a ring of fewer than three points");
  return points;
};
const loop = (value) => {
  const points = listOf(vertex, 3)(value);
  need(new Set(points.map(pointKey)).size === points.length, "a loop repeats a point");
  need(doubleArea(points).sign() > 0, "a loop is not counter-clockwise");
  return points;
};
const fit = listOf(vertex, 2, 2);
const chain = (value) => (Array.isArray(value) ? value : [value]).map(index);
const sums = listOf((value) => {
  need(Array.isArray(value) && value.length > 0, "not an entry of a list of sums");
  return { number: natural(value[0]), chains: value.slice(1).map(chain) };
});
const shapeKeys = { exterior: ring, holes: optional(listOf(ring), []) };
const shape = object(shapeKeys);
const pieces = listOf(ring, 1), outsidePieces = listOf(ring), frame = listOf(number, 4, 4);
const header = { format: exactly("exactsweep certificate"), version: exactly(3), claim: text };

function ringsOf({ exterior, holes }) {
  const turned = (r, isHole) => (isHole === doubleArea(r).sign() > 0 ? reversed(r) : r);
  return [turned(exterior, false), ...holes.map((r) => turned(r, true))];
}

// ---- Claims about polygons

const noFitKeys = {
  ...header, directrix: shape, generatrix: shape, exterior: loop, holes: listOf(loop), exact_fits: listOf(fit),
};
const noFitProof = { directrix: pieces, generatrix: pieces, sums };
const negated = (rings) => rings.map((r) => r.map(opposite));

function checkNoFit(c) {
  const { directrix, generatrix } = c.proof;
  checkMakesUp(directrix, ringsOf(c.directrix));
  checkMakesUp(generatrix, ringsOf(c.generatrix));
  checkSums({
    first: directrix, second: negated(generatrix), sums: c.proof.sums,
    loops: [c.exterior, ...c.holes.map(reversed)], fits: c.exact_fits, w: 1,
  });
}

function proveNoFit(value) {
  checkNoFit(object({ ...noFitKeys, proof: object(noFitProof) })(value));
  return "no-fit polygon";
}

function proveSweep(value) {
  const proof = object({ ...noFitProof, swept: sums, slits: listOf(fit) });
  const c = object({ ...noFitKeys, outer: loop, inner: loop, unswept: listOf(loop), area: number, proof })(value);
  checkNoFit(c);
  const first = edgesOf(c.exterior), second = c.proof.generatrix, others = [c.inner, ...c.unswept];
  checkSums({
    first, second, sums: c.proof.swept, loops: [c.outer, ...others.map(reversed)], fits: c.proof.slits, w: 1,
    groups: [first.slice(0, 1), second],
  });
  const isWithin = c.proof.directrix.some((piece) => winding([reversed(c.inner)], mean(piece)) === -1);
  need(isWithin, "the directrix is not within the inner loop");
  const area = others.reduce((a, l) => a.minus(doubleArea(l)).reduced(), doubleArea(c.outer));
  need(c.area.times(TWO).compare(area) === 0, "the area is wrong");
  return "sweep";
}

const path = (value) => {
  const points = listOf(vertex)(value).filter((p, i, all) => i === 0 || !same(p, all[i - 1]));
  need(points.length >= 2, "a path of fewer than two points");
  return points;
};

function proveSum(value) {
  const proof = object({ shape: pieces, sums, slits: listOf(fit) });
  const c = object({ ...header, shape, path, exterior: loop, holes: listOf(loop), proof })(value);
  const first = edgesOf(c.path).slice(0, -1), second = c.proof.shape;
  checkMakesUp(second, ringsOf(c.shape));
  checkSums({
    first, second, sums: c.proof.sums, loops: [c.exterior, ...c.holes.map(reversed)], fits: c.proof.slits, w: 1,
    groups: [first.slice(0, 1), second],
  });
  return "sum of a shape and a path";
}

function rectangle([left, bottom, right, top]) {
  need(less(left, right) && less(bottom, top), "a rectangle without interior");
  return [[left, bottom], [right, bottom], [right, top], [left, top]].map(([x, y]) => ({ x, y }));
}

function checkHoles(loops) { // of a region, as directed: exterior clockwise, holes counter-clockwise
  loops.slice(1).forEach((hole, n) => {
    const others = loops.filter((_, i) => i !== n + 1), edges = others.flatMap(edgesOf);
    const isOn = (p) => edges.some((e) => common(e, [p, p]));
    let k = 2n, p; // another edge has at most one point of this one
    do p = along([hole[0], hole[1]], new Q(1n, k++)); while (isOn(p));
    need(winding(others, p) === -1, "a hole is not in its region");
  });
}

function proveInnerFit(value) {
  const region = object({ exterior: loop, holes: listOf(loop) });
  const proof = object({ frame, outside: outsidePieces, part: pieces, sums, around: listOf(chain, 4, 4) });
  const keys = { container: shape, part: shape, regions: listOf(region), exact_fits: listOf(fit), proof };
  const c = object({ ...header, ...keys })(value), { outside, part, around } = c.proof;
  checkMakesUp(outside, [rectangle(c.proof.frame), ...ringsOf(c.container).map(reversed)]);
  checkMakesUp(part, ringsOf(c.part));
  const box = extents(part.flat());
  const [p, q, r, s] = rectangle(c.proof.frame.map((x, i) => x.minus(box[i]).reduced()));
  const planes = [[q, p], [r, q], [s, r], [p, s]];
  const regions = c.regions.map(({ exterior, holes }) => [reversed(exterior), ...holes]);
  const known = checkSums({
    first: outside, second: negated(part), sums: c.proof.sums,
    more: planes.map((plane, i) => ({ sides: [plane], chains: [around[i]] })),
    loops: regions.flat(), regions: regions.flatMap((loops, n) => loops.map(() => n)), fits: c.exact_fits, w: 0,
  });
  const isIn = (end) => planes.every((plane) => side(plane, end) <= 0);
  need(known.every((e) => e.edge.every(isIn)), "a known edge is not in B");
  regions.forEach(checkHoles);
  return "inner fit of " + regions.length + " regions";
}

// ---- Layouts

const UNIT = 10n ** 130n; // fixed point for sines of degrees
const SLACK = new Q(1n, 10n ** 100n, 101); // far above their error

function arctangent(k) { // of 1/k
  let sum = 0n;
  for (let n = 1n, power = UNIT / k; power; n += 2n, power /= -k * k) sum += power / n;
  return sum;
}
const PI = 4n * (4n * arctangent(5n) - arctangent(239n));

function cosineAndSine(degrees) { // by their series
  const x = ((degrees.n * UNIT) / degrees.d) * PI / (180n * UNIT), values = [0n, 0n];
  for (let k = 0n, term = UNIT; term; k++, term = (term * x) / UNIT / k) values[k % 2n] += k % 4n < 2n ? term : -term;
  return values.map((n) => new Q(n, UNIT, 132));
}

const unit = (value) => {
  const p = vertex(value);
  need(dot(p, p).compare(ONE) === 0, "cosine and sine of another length than 1");
  return p;
};
const rotation = (value) => { // {key, exact: [cosine, sine]} where rational, else {key, degrees}
  let exact;
  if (Array.isArray(value)) exact = unit(value);
  else {
    const q = number(value), full = 360n * q.d;
    const degrees = new Q(((q.n % full) + full) % full, q.d, q.size + 3);
    if (q.d !== 1n || degrees.n % 90n) return { key: "degrees " + degrees.key(), degrees };
    const [x, y] = [[1n, 0n], [0n, 1n], [-1n, 0n], [0n, -1n]][degrees.n / 90n];
    exact = { x: new Q(x), y: new Q(y) };
  }
  return { key: pointKey(exact), exact };
};
const rounded = (value) => {
  const { points, radius } = object({ points: listOf(vertex, 1), radius: optional(distance, ZERO) })(value);
  if (points.length > 2) checkPiece(points);
  return { rings: [points], radius };
};
const bodyKeys = {
  exterior: optional(ring), holes: shapeKeys.holes, pieces: optional(listOf(rounded)), error: optional(distance, ZERO),
};
const body = (keys, fewest = 1, most = Infinity) => (value) => { // with `solids`: rings and a radius
  const found = object({ ...keys, ...bodyKeys })(value), { exterior, holes, pieces } = found;
  need(pieces ? !exterior && !holes.length : exterior, "not either an exterior or rounded pieces");
  const solids = pieces ?? [{ rings: ringsOf(found), radius: ZERO }];
  need(solids.length >= fewest && solids.length <= most, "another number of rounded pieces");
  return { ...found, solids };
};
const demand = (value) => kind((n) => n <= 999999999, "a demand")(natural(value));
const turns = optional(listOf(rotation));
const partKeys = { id: text, demand: optional(demand), turns, mirrored_turns: turns, mirrored: optional(flag, true) };
const placementKeys = { part: text, move: vertex, turn: optional(rotation, rotation("0")), mirrored: optional(flag, false) };
const layoutReader = object({
  container: optional(body({}, 0, 1), { solids: [], pieces: [], error: ZERO }), parts: listOf(body(partKeys)),
  placements: listOf(object(placementKeys)), defects: optional(listOf(body({ spacing: optional(distance) })), []),
  spacing: optional(distance, ZERO), margin: optional(distance, ZERO),
});
const ofPart = { kind: text, part: text }, ofBodies = { kind: text, placements: listOf(index, 2, 2), point: vertex };
const FAULTS = {
  missing: ofPart, surplus: ofPart, turn: ofPart, mirror: ofPart, shape: { ...ofPart, point: vertex },
  overlap: ofBodies, outside: ofBodies, "too close": ofBodies,
};
const fault = (value) => {
  const name = isObject(value) && value.kind;
  need(typeof name === "string" && Object.hasOwn(FAULTS, name), "not a kind of fault");
  return object(FAULTS[name])(value);
};
const apart = listOf((value) => {
  need(Array.isArray(value) && value.length === 6, "not an entry of `apart`");
  return { of: value.slice(0, 4).map(index), normal: vertex(value.slice(4)) };
});
const layoutProof = object({
  frame: optional(frame), outside: listOf(optional(outsidePieces)), pieces: listOf(optional(pieces)), apart,
});
const pointsOf = (solids) => solids.flatMap(({ rings }) => rings.flat());

function place(layout, turns) { // give parts their counts, placements their part, error and map
  const byId = new Map(layout.parts.map((part) => [part.id, part]));
  need(byId.size === layout.parts.length, "two parts with one id");
  need(turns.length === layout.placements.length, "not a turn for each placement");
  for (const part of layout.parts) part.count = 0;
  layout.placements.forEach((placement, i) => {
    const of = byId.get(placement.part) ?? refuse("a placement of an unknown part"), turn = turns[i];
    const { exact, degrees, key } = placement.turn, { move, mirrored } = placement;
    let error = of.error;
    if (exact) need(same(exact, turn), "a turn is not the rotation of its placement");
    else {
      const [c, s] = cosineAndSine(degrees);
      const e = turn.x.minus(c).absolute().plus(turn.y.minus(s).absolute()).plus(SLACK);
      const r = largest(pointsOf(of.solids).map((p) => p.x.absolute().plus(p.y.absolute())));
      error = error.plus(e.times(r)).reduced();
    }
    const map = ({ x, y }) => {
      const p = { x: mirrored ? x.negated() : x, y };
      return plus(point(p.x.times(turn.x).minus(y.times(turn.y)), p.x.times(turn.y).plus(y.times(turn.x))), move);
    };
    const putRing = (r) => (mirrored ? reversed(r.map(map)) : r.map(map));
    const put = (solids) => solids.map(({ rings, radius }) => ({ rings: rings.map(putRing), radius }));
    const allowed = (mirrored && of.mirrored_turns) || of.turns;
    const isTurned = !allowed || allowed.some((t) => t.key === key), isMirrored = of.mirrored || !mirrored;
    of.count += 1;
    Object.assign(placement, { of, error, put, isTurned, isMirrored });
  });
  return byId;
}

function bodyOf(layout, n) { // {solids, error, isOutside}: of a container, what is outside it
  const { placements, container, defects } = layout;
  need(n < placements.length && -n - 2 < defects.length, "there is no body of that number");
  if (n >= 0) return { solids: placements[n].put(placements[n].of.solids), error: placements[n].error };
  return n === -1 ? { ...container, isOutside: true } : defects[-n - 2];
}

function squaredDistance(edge, p) {
  const u = vectorOf(edge), v = difference(p, edge[0]);
  const way = dot(u, v), t = way.sign() > 0 ? smallest([ONE, way.over(dot(u, u)).reduced()]) : ZERO;
  const w = difference(p, along(edge, t));
  return dot(w, w);
}

function boundaryOf(edges) { // the segments that opposite edges leave; all edges of a point or a segment
  const lines = new Map(), found = [];
  for (const [p, q] of edges) {
    const u = difference(q, p), slope = u.x.sign() ? u.y.over(u.x).reduced() : null;
    const line = slope ? slope.key() + " " + p.y.minus(slope.times(p.x)).key() : p.x.key();
    if (!lines.has(line)) lines.set(line, []);
    lines.get(line).push([p, 1], [q, -1]);
  }
  for (const ends of lines.values()) {
    ends.sort(([p], [q]) => lexicographic(p, q));
    ends.reduce((n, [p, sign], i) => {
      if (n && !same(ends[i - 1][0], p)) found.push([ends[i - 1][0], p]);
      return n + sign;
    }, 0);
  }
  return found.length ? found : edges;
}

function isDeep({ solids, isOutside }, z, depth) { // in a body, farther than `depth` from its boundary
  return solids.some(({ rings, radius }) => {
    const isIn = winding(rings, z) === (isOutside ? 0 : 1), d = isOutside ? depth.plus(radius) : depth.minus(radius);
    const nearest = smallest(boundaryOf(rings.flatMap(edgesOf)).map((e) => squaredDistance(e, z))), square = d.times(d);
    return isIn ? d.sign() < 0 || less(square, nearest) : d.sign() < 0 && less(nearest, square);
  });
}

function isProved({ kind, part: id, placements, point: z }, layout, byId) {
  if (id !== undefined) {
    const part = byId.get(id) ?? refuse("a fault of an unknown part");
    const placed = layout.placements.filter((p) => p.of === part);
    if (kind === "missing") return part.count < part.demand; // false without a demand
    if (kind === "surplus") return part.count > part.demand;
    if (kind === "turn") return placed.some((p) => !p.isTurned);
    if (kind === "mirror") return placed.some((p) => !p.isMirrored);
    return part.solids.some(({ rings }) => ![0, 1].includes(winding(rings, z)));
  }
  const [a, b] = placements, both = placements.map((n) => bodyOf(layout, n));
  if (a < 0 || a === b || (kind !== "too close" && (kind === "outside") !== b < 0)) return false;
  const room = b < 0 ? both[1].spacing ?? layout.margin : layout.spacing, r = room.minus(both[0].error).minus(both[1].error).over(TWO);
  if (kind !== "too close") return both.every((body) => isDeep(body, z, body.error));
  return r.sign() > 0 && both.every((body) => isDeep(body, z, r.negated()));
}

function checkFaults(faults, layout, byId) {
  const keys = faults.map((f) => (f.placements ? [...f.placements].sort((a, b) => a - b).join() : f.kind + " " + f.part));
  need(new Set(keys).size === faults.length, "a fault is listed twice");
  for (const f of faults) need(isProved(f, layout, byId), "a fault is not proved: " + f.kind);
}

const isFar = (p, q, s) => // boxes, along an axis
  [[p[2], q[0]], [p[3], q[1]], [q[2], p[0]], [q[3], p[1]]].some(([a, b]) => !less(b, a.plus(s)));

function checkApart(a, b, room, normals) {
  for (const [i, p] of a.solids.entries()) {
    for (const [j, q] of b.solids.entries()) {
      spend(0.1);
      if (isFar(a.boxes[i], b.boxes[j], room)) continue;
      const n = normals.get([a.n, i, b.n, j].join()) ?? normals.get([a.n, -1, b.n, -1].join());
      need(n && (n.x.sign() || n.y.sign()), "two pieces have no normal");
      const gap = smallest(q.rings[0].map((v) => dot(n, v))).minus(largest(p.rings[0].map((v) => dot(n, v))));
      const s = room.plus(p.radius).plus(q.radius), isEnough = !less(gap.times(gap), s.times(s).times(dot(n, n)));
      need(gap.sign() >= 0 && isEnough, "two pieces are not apart");
    }
  }
}

function cutTo(list, item, rings) { // the convex pieces of a part or an obstacle
  need(item.pieces ? list === undefined : list, "not a list of pieces for each shape");
  if (item.pieces) return item.solids;
  checkMakesUp(list, rings ?? ringsOf(item));
  return list.map((piece) => ({ rings: [piece], radius: ZERO }));
}

const widened = ({ rings, radius }) => extents(rings[0]).map((x, i) => (i < 2 ? x.minus(radius) : x.plus(radius)));
const around = (boxes) => [0, 1, 2, 3].map((i) => (i < 2 ? smallest : largest)(boxes.map((box) => box[i])));

function checkValid({ frame, outside, pieces, apart }, layout) {
  const { parts, placements, container, defects, margin, spacing } = layout;
  need(parts.every((p) => p.demand === undefined || p.count === p.demand), "a demand is not met");
  need(placements.every((p) => p.isTurned && p.isMirrored), "a rotation or a mirroring is not allowed");
  need(outside.length === defects.length + 1 && pieces.length === parts.length, "not a list of pieces for each shape");
  need(outside.slice(1).every((list) => !list || list.length), "a defect without pieces");
  need(container.pieces ? !frame : frame, "a frame is for a container that is a shape");
  const beyond = cutTo(outside[0], container, frame && [rectangle(frame), ...ringsOf(container).map(reversed)]);
  const obstacles = defects.map((defect, i) => cutTo(outside[i + 1], defect));
  parts.forEach((part, i) => { part.cut = cutTo(pieces[i], part); });
  const isIndex = (n) => n >= -outside.length && n <= 999999999;
  need(apart.every((e) => e.of.every(isIndex)), "an entry of `apart` for no body");
  const normals = new Map(apart.map(({ of, normal }) => [of.join(), normal]));
  need(normals.size === apart.length, "two entries of `apart` for the same pieces");
  const body = (n, solids, { error, spacing: own = margin }) => {
    const boxes = solids.map(widened);
    return { n, solids, error, own, boxes, box: boxes.length ? around(boxes) : null };
  };
  const bodies = obstacles.map((list, i) => body(-2 - i, list, defects[i]));
  if (frame) bodies.push(body(-1, beyond, container));
  placements.forEach((p, n) => {
    const b = body(n, p.put(p.of.cut), p), room = margin.plus(p.error).plus(container.error).reduced();
    const isInside = frame
      ? frame.every((line, i) => !less(i < 2 ? b.box[i].minus(line) : line.minus(b.box[i]), room))
      : !b.solids.some(({ rings, radius }) => rings[0].some(
        (q) => isDeep({ solids: beyond, isOutside: true }, q, room.plus(radius).negated())));
    need(isInside, "a placement is not within the container");
    for (const a of bodies) {
      const s = (a.n < 0 ? a.own : spacing).plus(a.error).plus(b.error).reduced();
      if (a.box && !isFar(a.box, b.box, s)) checkApart(a, b, s, normals);
    }
    bodies.push(b);
  });
}

function proveLayout(value) {
  const evidence = { proof: optional(layoutProof), faults: optional(listOf(fault, 1)) };
  const c = object({ ...header, layout: layoutReader, turns: listOf(unit), valid: flag, ...evidence })(value);
  need(c.valid ? c.proof && !c.faults : c.faults && !c.proof, "not a proof if valid, and faults if not");
  const byId = place(c.layout, c.turns), of = c.layout.placements.length + " placements";
  if (c.valid) checkValid(c.proof, c.layout);
  else checkFaults(c.faults, c.layout, byId);
  return c.valid ? "valid layout of " + of : c.faults.length + " faults of a layout of " + of;
}

// ---- Main

const PROVERS = { no_fit: proveNoFit, sweep: proveSweep, sum: proveSum, inner_fit: proveInnerFit, layout: proveLayout };

function prove(bytes) { // what is proved, or an exception
  steps = 5e6 + 150 * bytes.length;
  const value = parse(new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes));
  const claim = isObject(value) && value.claim;
  need(typeof claim === "string" && Object.hasOwn(PROVERS, claim), "not a claim");
  return PROVERS[claim](value);
}

let isAll = process.argv.length > 2;
for (const file of process.argv.slice(2)) {
  let line;
  try {
    line = "proved: " + prove(require("node:fs").readFileSync(file));
  } catch (error) {
    isAll = false;
    line = "not proved: " + String(error?.message ?? error).split("\n")[0];
  }
  console.log(line);
}
process.exitCode = isAll ? 0 : 1;

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

function need(condition, reason) {
  if (!condition) throw new Refused(reason);
}

// ---- Work: steps are charged as they cost, about a microsecond each.

const BUDGET = { base: 5e6, perByte: 200 };
let steps = Infinity;

function spend(n) {
  steps -= n;
  if (steps < 0) throw new Refused("too much work for the size of the file");
}

// ---- Numbers: n/d with d > 0, not always in lowest terms; `size` bounds the digits of both.

function gcd(a, b, size) {
  if (a < 0n) a = -a;
  while (b) {
    spend(0.2 + size / 500);
    [a, b] = [b, a % b];
  }
  return a;
}

class Q {
  constructor(n, d = 1n, size = 20) {
    spend(0.1 + size / 1000);
    Object.assign(this, { n, d, size });
  }
  plus(o) {
    const size = this.product(o) + 1;
    if (this.d === o.d) return new Q(this.n + o.n, this.d, Math.max(this.size, o.size) + 1);
    return new Q(this.n * o.d + o.n * this.d, this.d * o.d, size);
  }
  product(o) {
    spend((this.size * o.size) / 20000);
    return this.size + o.size;
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
    if (this.d === 1n) return this;
    const g = gcd(this.n, this.d, this.size);
    return g === 1n ? this : new Q(this.n / g, this.d / g, this.size);
  }
  key() { const q = this.reduced(); spend(q.size * q.size / 1e5); return q.n + "/" + q.d; }
  bounds() { // two floats around the number
    const n = Number(this.n), d = Number(this.d);
    if (!Number.isFinite(n) || !Number.isFinite(d)) return [-Infinity, Infinity];
    const slack = Math.abs(n / d) * 1e-14 + 1e-300;
    return [n / d - slack, n / d + slack];
  }
}

const ZERO = new Q(0n, 1n, 1), ONE = new Q(1n, 1n, 1), TWO = new Q(2n, 1n, 1);
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
const same = (p, q) => p.x.compare(q.x) === 0 && p.y.compare(q.y) === 0;
const pointKey = (p) => p.x.key() + " " + p.y.key();
const edgesOf = (ring) => ring.map((p, i) => [p, ring[(i + 1) % ring.length]]);
const reversed = (ring) => [...ring].reverse();
const along = ([a, b], t) => plus(a, { x: difference(b, a).x.times(t), y: difference(b, a).y.times(t) });
const side = ([a, b], p) => cross(difference(b, a), difference(p, a)); // > 0: p is on the left

function doubleArea(ring) {
  return edgesOf(ring).reduce((sum, [p, q]) => sum.plus(cross(p, q)).reduced(), ZERO);
}

function mean(points) {
  const n = new Q(BigInt(points.length));
  const sum = points.reduce((p, q) => plus(p, q));
  return point(sum.x.over(n), sum.y.over(n));
}

function boxOf(points) { // floats, outwards
  const xs = points.map((p) => p.x.bounds()), ys = points.map((p) => p.y.bounds());
  const low = (list) => list.reduce((m, b) => Math.min(m, b[0]), Infinity);
  const high = (list) => list.reduce((m, b) => Math.max(m, b[1]), -Infinity);
  return [low(xs), low(ys), high(xs), high(ys)];
}
const isApart = (a, b) => a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1];

function winding(rings, z) {
  let number = 0;
  for (const ring of rings) {
    for (const [p, q] of edgesOf(ring)) {
      const low = p.y.compare(z.y) <= 0, high = q.y.compare(z.y) <= 0;
      if (low && !high && side([p, q], z).sign() > 0) number += 1;
      if (!low && high && side([q, p], z).sign() > 0) number -= 1;
    }
  }
  return number;
}

const isUpper = (u) => u.y.sign() > 0 || (u.y.sign() === 0 && u.x.sign() > 0); // angle below pi

function checkPiece(ring) {
  const directions = edgesOf(ring).map(([p, q]) => difference(q, p));
  let rounds = 0;
  directions.forEach((u, i) => {
    const v = directions[(i + 1) % directions.length];
    need(cross(u, v).sign() > 0, "a piece does not turn left at every vertex");
    if (!isUpper(u) && isUpper(v)) rounds += 1;
  });
  need(rounds === 1, "a piece goes around more than once");
}

function checkMakesUp(pieces, rings) {
  pieces.forEach(checkPiece);
  const count = new Map();
  const add = (ring, sign) => {
    for (const [p, q] of edgesOf(ring)) {
      const u = difference(q, p), vertical = u.x.sign() === 0;
      const slope = vertical ? ZERO : u.y.over(u.x).reduced();
      const offset = vertical ? p.x : p.y.minus(slope.times(p.x));
      const line = (vertical ? "v" : slope.key()) + " " + offset.key() + " ";
      for (const [end, n] of [[p, sign], [q, -sign]]) {
        const key = line + pointKey(end);
        count.set(key, (count.get(key) ?? 0) + n);
      }
    }
  };
  pieces.forEach((ring) => add(ring, 1));
  rings.forEach((ring) => add(ring, -1));
  for (const n of count.values()) need(n === 0, "pieces do not have the edges of their shape");
  const boxes = pieces.map(boxOf);
  const separates = (a, b) => edgesOf(a).some((e) => b.every((p) => side(e, p).sign() <= 0));
  pieces.forEach((a, i) => {
    for (let j = 0; j < i; j++) {
      spend(0.05);
      const b = pieces[j];
      if (isApart(boxes[i], boxes[j])) continue;
      need(separates(a, b) || separates(b, a), "two pieces overlap");
    }
  });
}

// ---- Sums of convex pieces: {sides, planes}; a plane is [a, b], the points strictly left of it.

function steps_of(piece) { // edge vectors from the lowest vertex on, the left one of two
  let first = 0;
  piece.forEach((p, i) => {
    const c = p.y.compare(piece[first].y);
    if (c < 0 || (c === 0 && less(p.x, piece[first].x))) first = i;
  });
  const ring = [...piece.slice(first), ...piece.slice(0, first)];
  return [ring[0], edgesOf(ring).map(([p, q]) => difference(q, p))];
}

function minkowski(a, b) {
  const [p, us] = steps_of(a), [q, vs] = steps_of(b);
  const vertices = [plus(p, q)];
  let i = 0, j = 0;
  while (i < us.length || j < vs.length) {
    let order = i === us.length ? 1 : j === vs.length ? -1 : 0; // which turns less
    if (order === 0 && isUpper(us[i]) !== isUpper(vs[j])) order = isUpper(us[i]) ? -1 : 1;
    else if (order === 0) order = -cross(us[i], vs[j]).sign();
    let next = vertices[vertices.length - 1];
    if (order <= 0) next = plus(next, us[i++]);
    if (order >= 0) next = plus(next, vs[j++]);
    vertices.push(next);
  }
  vertices.pop();
  const sides = edgesOf(vertices);
  return { sides, planes: sides, vertices };
}

// Parameters t in [0, 1] at which a + t (b - a) is in an open convex set, or null.
function within([a, b], planes) {
  let low = { t: ZERO, closed: true }, high = { t: ONE, closed: true };
  for (const plane of planes) {
    const fa = side(plane, a), fb = side(plane, b);
    if (fa.sign() <= 0 && fb.sign() <= 0) return null;
    if (fa.sign() > 0 && fb.sign() > 0) continue;
    const t = fa.over(fa.minus(fb)).reduced();
    if (fa.sign() <= 0 && t.compare(low.t) >= 0) low = { t, closed: false };
    if (fb.sign() <= 0 && t.compare(high.t) <= 0) high = { t, closed: false };
    if (low.t.compare(high.t) >= 0) return null;
  }
  return { low, high };
}

function parameter([a, b], p) { // of a point of the line through a and b
  const u = difference(b, a), v = difference(p, a);
  return (u.x.sign() !== 0 ? v.x.over(u.x) : v.y.over(u.y)).reduced();
}

// Parameters t in [0, 1] at which the segment meets a closed one, which may be a point, or null.
function common(segment, other) {
  const closed = (low, high) =>
    less(high, low) ? null : { low: { t: low, closed: true }, high: { t: high, closed: true } };
  const [a, b] = segment, [c, d] = other;
  const u = difference(b, a), v = difference(d, c);
  const turn = cross(u, v);
  if (turn.sign() === 0) {
    if (side(segment, c).sign() !== 0) return null;
    const [s, t] = [parameter(segment, c), parameter(segment, d)];
    return closed(largest([ZERO, smallest([s, t])]), smallest([ONE, largest([s, t])]));
  }
  const t = cross(difference(c, a), v).over(turn), s = cross(difference(c, a), u).over(turn);
  const inside = [s, t].every((x) => x.sign() >= 0 && !less(ONE, x));
  return inside ? closed(t.reduced(), t.reduced()) : null;
}

function covers(intervals) { // whether their union contains [0, 1]
  intervals.sort((a, b) =>
    a.low.t.compare(b.low.t) || Number(b.low.closed) - Number(a.low.closed));
  let t = ZERO, included = false;
  for (const { low, high } of intervals) {
    const start = low.t.compare(t);
    if (start > 0 || (start === 0 && !low.closed && !included)) return false;
    const end = high.t.compare(t);
    if (end > 0) [t, included] = [high.t, high.closed];
    else if (end === 0) included ||= high.closed;
  }
  return included && t.compare(ONE) >= 0;
}

// ---- The lemma: `entries` ({sides, planes, chains}) prove loops and fits with winding number w.

function checkLoop(loop) {
  const least = (p, q) => p.x.compare(q.x) || p.y.compare(q.y);
  need(new Set(loop.map(pointKey)).size === loop.length, "a loop repeats a point");
  need(loop.every((p) => least(loop[0], p) <= 0), "a loop does not start at its least point");
  need(doubleArea(loop).sign() > 0, "a loop is not counter-clockwise");
  loop.forEach((p, i) => {
    const q = loop[(i + 1) % loop.length], r = loop[(i + 2) % loop.length];
    need(side([p, q], r).sign() !== 0, "a loop has a straight angle");
  });
}

function knownEdges(loops, fits) {
  const known = [];
  loops.forEach((loop, n) => edgesOf(loop).forEach((edge, i) =>
    known.push({ edge, loop: n, i, length: loop.length })));
  fits.forEach((edge) => known.push({ edge, loop: -1, single: same(...edge) }));
  known.forEach((e) => { e.box = boxOf(e.edge); });
  return known;
}

function checkNoneInside(first, second, known) { // (a)
  const boxes = second.map(boxOf);
  first.forEach((a) => {
    const box = boxOf(a);
    second.forEach((b, j) => {
      const [o, slack] = [boxes[j], 1e-14];
      const bounds = box.map((v, i) => v + o[i] + (i < 2 ? -1 : 1) * slack * (Math.abs(v) + Math.abs(o[i])));
      let sum = null;
      for (const e of known) {
        spend(0.02);
        if (isApart(bounds, e.box)) continue;
        sum ??= minkowski(a, b);
        need(within(e.edge, sum.planes) === null, "a sum has a point of a known edge");
      }
    });
  });
}

function checkChains(entries, known) { // (b), (c)
  const named = known.map(() => []);
  for (const { sides, chains } of entries) {
    need(sides.length === chains.length, "a sum does not have a chain for each of its sides");
    sides.forEach((s, i) => {
      const intervals = [];
      for (const name of chains[i]) {
        spend(0.1);
        need(name < entries.length && -1 - name < known.length, "a chain names nothing");
        if (name < 0) named[-1 - name].push(s);
        const met = name < 0 ? common(s, known[-1 - name].edge) : within(s, entries[name].planes);
        if (met) intervals.push(met);
      }
      need(covers(intervals), "a side is not contained in what its chain names");
    });
  }
  known.forEach(({ edge, loop, single }, n) => {
    if (single) {
      need(named[n].some((s) => common(s, edge)), "no side has the point of a fit");
      return;
    }
    const u = difference(edge[1], edge[0]);
    for (const direction of loop < 0 ? [1, -1] : [1]) {
      const parts = named[n].filter((s) => {
        const v = difference(s[1], s[0]);
        return cross(u, v).sign() === 0 && dot(u, v).sign() === direction;
      });
      const intervals = parts.map((s) => common(edge, s)).filter((m) => m);
      need(covers(intervals), "a known edge is not covered by sides along it");
    }
  });
}

function groupsOf(pieces) { // one piece of each
  const parent = pieces.map((_, i) => i), seen = new Map();
  const root = (i) => { while (parent[i] !== i) i = parent[i] = parent[parent[i]]; return i; };
  pieces.forEach((piece, i) => piece.forEach((p) => {
    const key = pointKey(p);
    if (seen.has(key)) parent[root(i)] = root(seen.get(key));
    else seen.set(key, i);
  }));
  return pieces.filter((_, i) => parent[i] === i);
}

function checkMeetings(known) { // (e)
  const sorted = [...known].sort((a, b) => (a.box[0] < b.box[0] ? -1 : a.box[0] > b.box[0] ? 1 : 0));
  sorted.forEach((e, m) => {
    for (const f of sorted.slice(m + 1)) {
      spend(0.05);
      if (f.box[0] > e.box[2]) break;
      if (isApart(e.box, f.box)) continue;
      const [segment, other] = e.single ? [f.edge, e.edge] : [e.edge, f.edge];
      if (e.single && f.single) { need(!same(e.edge[0], f.edge[0]), "a fit repeats"); continue; }
      const met = common(segment, other);
      if (!met) continue;
      need(!e.single && !f.single, "a fit of one point is on a known edge");
      need(met.low.t.compare(met.high.t) === 0, "two known edges overlap");
      if (e.loop < 0 || e.loop !== f.loop) continue;
      const apart = Math.abs(e.i - f.i);
      need(apart === 1 || apart === e.length - 1, "two edges of a loop meet");
    }
  });
}

function checkSums({ first, second, sums, more = [], loops, fits, w, groups = [groupsOf(first), groupsOf(second)] }) {
  const known = knownEdges(loops, fits);
  const entries = sums.map(({ number, chains }) => {
    need(number < first.length * second.length, "there is no sum of that number");
    const i = Math.floor(number / second.length);
    return { ...minkowski(first[i], second[number % second.length]), chains };
  });
  entries.push(...more);
  checkMeetings(known);
  checkNoneInside(first, second, known);
  checkChains(entries, known);
  for (const a of groups[0]) {
    for (const b of groups[1]) { // (d)
      const z = mean(minkowski(a, b).vertices);
      need(winding(loops, z) === w, "the winding number of a group of sums is wrong");
    }
  }
  return known;
}

// ---- Reading. The parser refuses keys that occur twice, and numbers with a point or an exponent.

function parse(text) {
  let at = 0;
  const fail = () => { throw new Refused("not JSON at character " + at); };
  const skip = () => { while (at < text.length && " \t\n\r".includes(text[at])) at++; };
  const take = (c) => { skip(); return text[at] === c && ++at > 0; };
  const string = () => {
    const match = /"(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/y;
    match.lastIndex = at;
    const found = match.exec(text) ?? fail();
    at = match.lastIndex;
    return JSON.parse(found[0]);
  };
  const list = (end, item) => {
    if (take(end)) return;
    do { item(); } while (take(","));
    if (!take(end)) fail();
  };
  const value = (depth) => {
    skip();
    spend(0.1);
    if (depth > 50) fail();
    if (text[at] === '"') return string();
    if (take("[")) {
      const items = [];
      list("]", () => items.push(value(depth + 1)));
      return items;
    }
    if (take("{")) {
      const object = new Map();
      list("}", () => {
        skip();
        const key = string();
        need(!object.has(key), "a key occurs twice");
        if (!take(":")) fail();
        object.set(key, value(depth + 1));
      });
      return object;
    }
    const match = /(?:true|false|null|-?(?:0|[1-9][0-9]*))(?![\w.+])/y;
    match.lastIndex = at;
    const found = match.exec(text) ?? fail();
    at = match.lastIndex;
    need(found[0].length < 1000, "an index is too long");
    const constants = { true: true, false: false, null: null };
    return found[0] in constants ? constants[found[0]] : BigInt(found[0]);
  };
  const result = value(0);
  skip();
  return at === text.length ? result : fail();
}

// Readers take a parsed value and return it, or refuse it.
const optional = (reader, otherwise) => Object.assign(
  (value) => (value === null || value === undefined ? otherwise : reader(value)), { isOptional: true });
const object = (readers) => (value) => {
  need(value instanceof Map, "not an object");
  for (const key of value.keys()) need(Object.hasOwn(readers, key), "a key that has no meaning");
  const result = {};
  for (const [key, reader] of Object.entries(readers)) {
    need(value.has(key) || reader.isOptional, "a key is missing: " + key);
    result[key] = reader(value.get(key));
  }
  return result;
};
const listOf = (reader, shortest = 0, longest = Infinity) => (value) => {
  need(Array.isArray(value), "not a list");
  need(value.length >= shortest && value.length <= longest, "a list of a wrong length");
  return value.map((item) => reader(item));
};
const kind = (test, what) => (value) => { need(test(value), "not " + what); return value; };
const exactly = (constant) => kind((value) => value === constant, "the constant " + constant);
const text = kind((value) => typeof value === "string", "a string");
const flag = kind((value) => typeof value === "boolean", "true or false");
const index = kind((value) => typeof value === "bigint", "an integer");
const small = (value) => {
  const limit = BigInt(Number.MAX_SAFE_INTEGER);
  need(index(value) >= -limit && value <= limit, "an index is too large");
  return Number(value);
};
const natural = kind((value) => small(value) >= 0, "a number of a sum");
const number = (value) => {
  need(text(value).length <= 100000, "a number is too long");
  need(/^-?(0|[1-9][0-9]*)(\/[1-9][0-9]*)?$/.test(value) && value !== "-0" && !/[^0-9/-]/.test(value), "not a number");
  spend(value.length ** 1.5 / 1000);
  const [n, d] = value.split("/");
  const q = new Q(BigInt(n), BigInt(d ?? 1), Math.max(value.length, 1));
  need(d === undefined || (q.d > 1n && gcd(q.n, q.d, q.size) === 1n), "a fraction is not in lowest terms");
  return q;
};
const size = kind((value) => value.sign() >= 0, "a size");
const sizeOf = (value) => size(number(value));
const pair = listOf(number, 2, 2);
const vertex = (value) => { const [x, y] = pair(value); return { x, y }; };
const ring = (value) => {
  const all = listOf(vertex)(value);
  const points = all.filter((p, i) => !same(p, all[(i || all.length) - 1]));
  need(points.length >= 3, "a ring of fewer than three points");
  return points;
};
const loop = (value) => { const points = listOf(vertex, 3)(value); checkLoop(points); return points; };
const fit = listOf(vertex, 2, 2);
const chain = (value) => (Array.isArray(value) ? value : [value]).map(small);
const sums = listOf((value) => {
  need(Array.isArray(value) && value.length > 0, "not an entry of a list of sums");
  return { number: small(natural(value[0])), chains: value.slice(1).map(chain) };
});
const shapeKeys = { exterior: ring, holes: optional(listOf(ring), []) };
const shape = object(shapeKeys);
const pieces = listOf(ring, 1), outsidePieces = listOf(ring);

function ringsOf({ exterior, holes }) {
  const turned = (r, isHole) => (isHole === doubleArea(r).sign() > 0 ? reversed(r) : r);
  return [turned(exterior, false), ...holes.map((r) => turned(r, true))];
}

const header = { format: exactly("exactsweep certificate"), version: exactly(3n), claim: text };

// ---- Claims about polygons

const noFitKeys = {
  ...header, directrix: shape, generatrix: shape, exterior: loop, holes: listOf(loop), exact_fits: listOf(fit),
};
const noFitProof = { directrix: pieces, generatrix: pieces, sums };

function checkNoFit(c) {
  const { directrix, generatrix } = c.proof;
  checkMakesUp(directrix, ringsOf(c.directrix));
  checkMakesUp(generatrix, ringsOf(c.generatrix));
  checkSums({
    first: directrix, second: generatrix.map((r) => r.map(opposite)), sums: c.proof.sums,
    loops: [c.exterior, ...c.holes.map(reversed)], fits: c.exact_fits, w: 1,
  });
}

function proveNoFit(value) {
  const c = object({ ...noFitKeys, proof: object(noFitProof) })(value);
  checkNoFit(c);
  return "no-fit polygon";
}

function proveSweep(value) {
  const proof = object({ ...noFitProof, swept: sums, slits: listOf(fit) });
  const c = object({ ...noFitKeys, outer: loop, inner: loop, unswept: listOf(loop), area: number, proof })(value);
  checkNoFit(c);
  const first = edgesOf(c.exterior), second = c.proof.generatrix, inner = reversed(c.inner);
  checkSums({
    first, second, sums: c.proof.swept, loops: [c.outer, inner, ...c.unswept.map(reversed)],
    fits: c.proof.slits, w: 1, groups: [first.slice(0, 1), second],
  });
  const within = c.proof.directrix.some((piece) => winding([inner], mean(piece)) === -1);
  need(within, "the directrix is not within the inner loop");
  const area = [c.inner, ...c.unswept].reduce((a, l) => a.minus(doubleArea(l)).reduced(), doubleArea(c.outer));
  need(c.area.times(TWO).compare(area) === 0, "the area is wrong");
  return "sweep";
}

function rectangle([left, bottom, right, top]) {
  need(less(left, right) && less(bottom, top), "a rectangle without interior");
  return [[left, bottom], [right, bottom], [right, top], [left, top]].map(([x, y]) => ({ x, y }));
}

function checkHoles(loops) { // of a region, as directed: exterior clockwise, holes counter-clockwise
  loops.slice(1).forEach((hole, n) => {
    const others = loops.filter((_, i) => i !== n + 1);
    const edges = others.flatMap(edgesOf);
    for (let k = 2n; ; k++) { // another edge has at most one point of this one
      const p = along([hole[0], hole[1]], new Q(1n, k));
      if (edges.some((e) => common(e, [p, p]))) continue;
      need(winding(others, p) === -1, "a hole is not in its region");
      break;
    }
  });
}

function proveInnerFit(value) {
  const region = object({ exterior: loop, holes: listOf(loop) });
  const proof = object({ frame: listOf(number, 4, 4), outside: outsidePieces, part: pieces, sums, around: listOf(chain, 4, 4) });
  const c = object({
    ...header, container: shape, part: shape, regions: listOf(region), exact_fits: listOf(fit), proof,
  })(value);
  const { frame, outside, part, around } = c.proof;
  checkMakesUp(outside, [rectangle(frame), ...ringsOf(c.container).map(reversed)]);
  checkMakesUp(part, ringsOf(c.part));
  const xs = c.part.exterior.map((p) => p.x), ys = c.part.exterior.map((p) => p.y);
  const box = [frame[0].minus(smallest(xs)), frame[1].minus(smallest(ys)), frame[2].minus(largest(xs)), frame[3].minus(largest(ys))];
  const [p, q, r, s] = rectangle(box.map((x) => x.reduced()));
  const planes = [[q, p], [r, q], [s, r], [p, s]];
  const more = planes.map((plane, i) => ({ sides: [plane], planes: [plane], chains: [around[i]] }));
  const regions = c.regions.map(({ exterior, holes }) => [reversed(exterior), ...holes]);
  const known = checkSums({
    first: outside, second: part.map((ring) => ring.map(opposite)), sums: c.proof.sums, more,
    loops: regions.flat(), fits: c.exact_fits, w: 0,
  });
  for (const { edge } of known) {
    for (const end of edge) need(planes.every((e) => side(e, end).sign() <= 0), "a known edge leaves the frame");
  }
  regions.forEach(checkHoles);
  return "inner fit of " + regions.length + " regions";
}

// ---- Layouts

const DIGITS = 130n, UNIT = 10n ** DIGITS; // fixed point for sines of degrees
const SLACK = new Q(1n, 10n ** 100n, 101); // far above their error

function piInUnits() { // Machin
  const arctan = (k) => {
    let sum = 0n, power = UNIT / k;
    for (let n = 1n, sign = 1n; power; n += 2n, sign = -sign, power /= k * k) sum += (sign * power) / n;
    return sum;
  };
  return 4n * (4n * arctan(5n) - arctan(239n));
}
const PI = piInUnits();

function cosineAndSine(degrees) { // each within SLACK / 2
  const x = ((degrees.n * UNIT) / degrees.d) * PI / (180n * UNIT);
  const sums = [0n, 0n];
  for (let k = 0n, term = UNIT; term; k++, term = (term * x) / UNIT / k) {
    sums[k % 2n] += k % 4n < 2n ? term : -term;
  }
  return sums.map((n) => new Q(n, UNIT, 132));
}

// A rotation: {key, point} with [cosine, sine] where rational, else {key, degrees}.
const unit = (value) => {
  const p = vertex(value);
  need(dot(p, p).compare(ONE) === 0, "cosine and sine of another length than 1");
  return p;
};
const rotation = (value) => {
  if (Array.isArray(value)) {
    const p = unit(value);
    return { key: pointKey(p), point: p };
  }
  const q = number(value), full = 360n * q.d;
  const degrees = new Q(((q.n % full) + full) % full, q.d, q.size + 3);
  if (q.d !== 1n || degrees.n % 90n) return { key: "degrees " + degrees.key(), degrees };
  const [x, y] = [[1n, 0n], [0n, 1n], [-1n, 0n], [0n, -1n]][Number(degrees.n / 90n)];
  const p = { x: new Q(x), y: new Q(y) };
  return { key: pointKey(p), point: p };
};
const demandOf = (value) => {
  need(small(value) >= 0 && small(value) <= 999999999, "a demand out of range");
  return small(value);
};

const solidKeys = { ...shapeKeys, error: optional(sizeOf, ZERO) };
const layoutReader = object({
  container: object(solidKeys),
  parts: listOf(object({
    id: text, ...solidKeys, demand: optional(demandOf, null), turns: optional(listOf(rotation), null),
    mirrored: optional(flag, true),
  })),
  placements: listOf(object({
    part: text, move: vertex, turn: optional(rotation, rotation("0")), mirrored: optional(flag, false),
  })),
  defects: optional(listOf(object(solidKeys)), []),
  spacing: optional(sizeOf, ZERO),
  margin: optional(sizeOf, ZERO),
});
const bodies = listOf((value) => small(value), 2, 2);
const faultReaders = (() => {
  const ofPart = object({ kind: text, part: text });
  const ofBodies = object({ kind: text, placements: bodies, point: vertex });
  return {
    missing: ofPart, surplus: ofPart, turn: ofPart, mirror: ofPart,
    shape: object({ kind: text, part: text, point: vertex }),
    overlap: ofBodies, outside: ofBodies, "too close": ofBodies,
  };
})();
const fault = (value) => {
  const name = value instanceof Map && value.get("kind");
  need(typeof name === "string" && Object.hasOwn(faultReaders, name), "not a kind of fault");
  return faultReaders[name](value);
};
const entry = (value) => {
  need(Array.isArray(value) && value.length === 6, "not an entry of `apart`");
  const key = value.slice(0, 4).map(small);
  need(key.every((n) => n <= 999999999), "an index is too large");
  return { key: key.join(" "), least: Math.min(...key), normal: vertex(value.slice(4)) };
};
const layoutProof = object({
  frame: listOf(number, 4, 4), outside: listOf(outsidePieces), pieces: listOf(pieces), apart: listOf(entry),
});

class Layout { // with placed parts; bodies by their numbers
  constructor(layout, turns) {
    Object.assign(this, layout);
    this.byId = new Map(this.parts.map((part) => [part.id, part]));
    need(this.byId.size === this.parts.length, "two parts with one id");
    for (const part of this.parts) Object.assign(part, { rings: ringsOf(part), count: 0 });
    need(turns.length === this.placements.length, "not a turn for each placement");
    this.placements.forEach((p, i) => this.place(p, turns[i]));
  }
  place(placement, turn) {
    const part = this.byId.get(placement.part);
    need(part, "a placement of an unknown part");
    part.count += 1;
    const { point: exact, degrees } = placement.turn;
    let error = part.error;
    if (exact) need(same(exact, turn), "a turn is not the rotation of its placement");
    else {
      const [c, s] = cosineAndSine(degrees);
      const e = turn.x.minus(c).absolute().plus(turn.y.minus(s).absolute()).plus(SLACK);
      const r = largest(part.rings.flat().map((p) => p.x.absolute().plus(p.y.absolute())));
      error = error.plus(e.times(r)).reduced();
    }
    const put = (r) => {
      const points = r.map((p) => {
        const x = placement.mirrored ? p.x.negated() : p.x;
        return plus(point(x.times(turn.x).minus(p.y.times(turn.y)), x.times(turn.y).plus(p.y.times(turn.x))), placement.move);
      });
      return placement.mirrored ? reversed(points) : points;
    };
    Object.assign(placement, { of: part, error, put });
  }
  isTurnAllowed({ of, turn }) { return !of.turns || of.turns.some((t) => t.key === turn.key); }
  isMirroringAllowed({ of, mirrored }) { return of.mirrored || !mirrored; }
  body(n) { // {rings, error, inside}: the winding number within
    need(n < this.placements.length && -n - 2 < this.defects.length, "there is no body of that number");
    if (n >= 0) {
      const p = this.placements[n];
      return { rings: (p.rings ??= p.of.rings.map(p.put)), error: p.error, inside: 1 };
    }
    const solid = n === -1 ? this.container : this.defects[-n - 2];
    return { rings: ringsOf(solid), error: solid.error, inside: n === -1 ? 0 : 1 };
  }
}

function squaredDistance([a, b], p) {
  const u = difference(b, a), v = difference(p, a), length = dot(u, u);
  if (length.sign() === 0) return dot(v, v);
  const t = smallest([ONE, largest([ZERO, dot(u, v).over(length).reduced()])]);
  const w = difference(p, along([a, b], t));
  return dot(w, w);
}

function isProved(fault, layout) {
  const part = layout.byId.get(fault.part), { kind, point: z } = fault;
  if (fault.part !== undefined) {
    need(part, "a fault of an unknown part");
    const placed = layout.placements.filter((p) => p.of === part);
    if (kind === "missing") return part.demand !== null && part.count < part.demand;
    if (kind === "surplus") return part.demand !== null && part.count > part.demand;
    if (kind === "turn") return placed.some((p) => !layout.isTurnAllowed(p));
    if (kind === "mirror") return placed.some((p) => !layout.isMirroringAllowed(p));
    return ![0, 1].includes(winding(part.rings, z)); // "shape"
  }
  const [a, b] = fault.placements;
  if (a < 0 || a === b || (kind === "outside" && b >= 0) || (kind === "overlap" && b < 0)) return false;
  const both = [a, b].map((n) => layout.body(n));
  const isIn = (body) => winding(body.rings, z) === body.inside;
  const edges = (body) => body.rings.flatMap(edgesOf);
  if (kind !== "too close") {
    return both.every((body) => isIn(body) &&
      edges(body).every((e) => less(body.error.times(body.error), squaredDistance(e, z))));
  }
  const distance = b < 0 ? layout.margin : layout.spacing;
  const r = distance.minus(both[0].error).minus(both[1].error).over(TWO);
  return r.sign() > 0 && both.every((body) => isIn(body) ||
    edges(body).some((e) => less(squaredDistance(e, z), r.times(r))));
}

function checkFaults(faults, layout) {
  const seen = new Set();
  for (const f of faults) {
    const key = f.placements ? [...f.placements].sort((a, b) => a - b).join(" ") : f.kind + " of " + f.part;
    need(!seen.has(key), "two faults of one kind");
    seen.add(key);
    need(isProved(f, layout), "a fault is not proved: " + f.kind);
  }
}

function extents(points) { // exact: [left, bottom, right, top]
  const xs = points.map((p) => p.x), ys = points.map((p) => p.y);
  return [smallest(xs), smallest(ys), largest(xs), largest(ys)];
}

function isFar(p, q, s) { // boxes, along an axis
  return [[p[2], q[0]], [p[3], q[1]], [q[2], p[0]], [q[3], p[1]]].some(([a, b]) => !less(b, a.plus(s)));
}

function checkApart(a, b, s, normals) {
  for (const [i, p] of a.pieces.entries()) {
    for (const [j, q] of b.pieces.entries()) {
      spend(0.1);
      if (isFar(a.extents[i], b.extents[j], s)) continue;
      const n = normals.get([a.n, i, b.n, j].join(" ")) ?? normals.get([a.n, -1, b.n, -1].join(" "));
      need(n, "two pieces are not apart along an axis, and have no normal");
      const gap = smallest(q.map((v) => dot(n, v))).minus(largest(p.map((v) => dot(n, v))));
      need(n.x.sign() || n.y.sign(), "a normal is zero");
      need(gap.sign() >= 0 && !less(gap.times(gap), s.times(s).times(dot(n, n))), "two pieces are not apart");
    }
  }
}

function checkValid({ frame, outside, pieces: ofParts, apart }, layout) {
  for (const part of layout.parts) need(part.demand === null || part.count === part.demand, "a demand is not met");
  for (const p of layout.placements) {
    need(layout.isTurnAllowed(p) && layout.isMirroringAllowed(p), "a rotation or a mirroring is not allowed");
  }
  need(outside.length === layout.defects.length + 1, "not a list of pieces for each defect");
  need(ofParts.length === layout.parts.length, "not a list of pieces for each part");
  checkMakesUp(outside[0], [rectangle(frame), ...ringsOf(layout.container).map(reversed)]);
  layout.defects.forEach((defect, i) => {
    need(outside[i + 1].length > 0, "a defect without pieces");
    checkMakesUp(outside[i + 1], ringsOf(defect));
  });
  layout.parts.forEach((part, i) => { checkMakesUp(ofParts[i], part.rings); part.pieces = ofParts[i]; });
  need(apart.every((e) => e.least >= -outside.length), "an entry of `apart` for no body");
  const normals = new Map(apart.map(({ key, normal }) => [key, normal]));
  need(normals.size === apart.length, "two entries of `apart` for the same pieces");
  const body = (n, list, error) => ({ n, pieces: list, error, extents: list.map(extents) });
  const all = outside.map((list, i) => body(-1 - i, list, (i ? layout.defects[i - 1] : layout.container).error));
  layout.placements.forEach((p, n) => {
    const b = body(n, p.of.pieces.map(p.put), p.error);
    const room = layout.margin.plus(p.error).plus(layout.container.error).reduced();
    const [left, bottom, right, top] = frame;
    for (const e of b.extents) {
      const gaps = [e[0].minus(left), e[1].minus(bottom), right.minus(e[2]), top.minus(e[3])];
      need(gaps.every((gap) => !less(gap, room)), "a piece is not within the frame");
    }
    all.push(b);
  });
  for (const b of all) b.box = b.pieces.length ? extents(b.pieces.flat()) : null;
  for (const [m, b] of all.entries()) {
    if (b.n < 0) continue;
    for (const a of all.slice(0, m)) {
      const s = (a.n < 0 ? layout.margin : layout.spacing).plus(a.error).plus(b.error).reduced();
      if (a.box && !isFar(a.box, b.box, s)) checkApart(a, b, s, normals);
    }
  }
}

function proveLayout(value) {
  const keys = { ...header, layout: layoutReader, turns: listOf(unit), valid: flag };
  const isValid = value.get("valid") === true;
  const c = object({ ...keys, ...(isValid ? { proof: layoutProof } : { faults: listOf(fault, 1) }) })(value);
  const layout = new Layout(c.layout, c.turns);
  if (isValid) checkValid(c.proof, layout);
  else checkFaults(c.faults, layout);
  const of = c.layout.placements.length + " placements";
  return isValid ? "valid layout of " + of : c.faults.length + " faults of a layout of " + of;
}

// ---- Main

const PROVERS = { no_fit: proveNoFit, sweep: proveSweep, inner_fit: proveInnerFit, layout: proveLayout };

function prove(bytes) { // what is proved, or an exception
  steps = BUDGET.base + BUDGET.perByte * bytes.length;
  const value = parse(new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes));
  const claim = value instanceof Map && value.get("claim");
  need(typeof claim === "string" && Object.hasOwn(PROVERS, claim), "not a claim");
  return PROVERS[claim](value);
}

function main(files) {
  let all = files.length > 0;
  for (const file of files) {
    let line;
    try {
      line = "proved: " + prove(require("node:fs").readFileSync(file));
    } catch (error) {
      all = false;
      line = "not proved: " + String(error?.message ?? error).split("\n")[0];
    }
    console.log(line);
  }
  process.exitCode = all ? 0 : 1;
}

if (require.main === module) main(process.argv.slice(2));
else module.exports = { prove };

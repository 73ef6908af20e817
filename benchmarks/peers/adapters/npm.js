// Minkowski sums by npm packages, one pair per line.
//
//   node npm.js PACKAGE FOLDER
//
// FOLDER contains node_modules. A line of input contains two polygons, each as the number of
// vertices and their coordinates. The answer is the number of rings of the sum and the rings in the
// same form, or a line that starts with "error".
'use strict';
const path = require('path');
const readline = require('readline');

const [name, folder] = process.argv.slice(2);
const place = path.resolve(folder, 'node_modules', name);
const points = (ring) => ring.map(([x, y]) => ({ x, y }));
const pairs = (ring) => ring.map((p) => [p.x, p.y]);
const move = (ring, [dx, dy]) => ring.map(([x, y]) => [x + dx, y + dy]);
const doubledArea = (ring) => ring.reduce((sum, [x, y], k) => {
  const [u, v] = ring[(k + 1) % ring.length];
  return sum + x * v - u * y;
}, 0);

// Shapes whose union with the sum of two boundaries is the sum of the polygons.
const fillings = (d, g) => [move(d, g[0]), move(g, d[0])];

// Fill the sum of two boundaries if it has a hole, or a ring that may hide one.
function fill(d, g, sum, unite) {
  const rings = sum.map(pairs);
  const isPlain = (ring) => doubledArea(ring) > 0 && new Set(ring.map(String)).size === ring.length;
  return rings.every(isPlain) ? rings : unite([...rings, ...fillings(d, g)].map(points)).map(pairs);
}

async function load() {
  if (name === 'clipper2-ts') {
    const { Clipper, FillRule } = await import(path.join(place, 'dist', 'index.js'));
    const unite = (rings) => Clipper.union(rings, FillRule.NonZero);
    return (d, g) => fill(d, g, Clipper.minkowskiSum(points(g), points(d), true), unite);
  }
  const found = require(place);
  if (name === 'js-angusj-clipper') {
    const clipper = await found.loadNativeClipperLibInstanceAsync(
      found.NativeClipperLibRequestedFormat.WasmWithAsmJsFallback);
    const unite = (rings) => clipper.clipToPaths({
      clipType: found.ClipType.Union,
      subjectFillType: found.PolyFillType.NonZero,
      subjectInputs: rings.map((data) => ({ data, closed: true })),
    });
    return (d, g) => fill(d, g, clipper.minkowskiSumPath(points(g), points(d), true), unite);
  }
  if (name === 'convex-minkowski-sum') return (d, g) => [goAround(found(d, g))];
  const edges = (ring) => ring.map((p, k) => [p, ring[(k + 1) % ring.length]]);
  return (d, g) => {
    const sums = edges(d).flatMap(([a, b]) => edges(g).map(([p, q]) =>
      [[a, p], [b, p], [b, q], [a, q]].map(([u, v]) => [u[0] + v[0], u[1] + v[1]])));
    return found.union(...[...sums, ...fillings(d, g)].map((ring) => [ring])).flat();
  };
}

// Sort the corners of a convex polygon counter-clockwise.
function goAround(corners) {
  const [x, y] = [0, 1].map((k) => corners.reduce((sum, p) => sum + p[k], 0) / corners.length);
  const angle = new Map(corners.map((p) => [p, Math.atan2(p[1] - y, p[0] - x)]));
  return corners.sort((p, q) => angle.get(p) - angle.get(q));
}

function answer(add, line) {
  const numbers = line.split(' ').map(Number);
  let at = 0;
  const ring = () => Array.from({ length: numbers[at++] }, () => [numbers[at++], numbers[at++]]);
  const rings = add(ring(), ring());
  return [rings.length, ...rings.map((found) => [found.length, ...found.flat()].join(' '))].join(' ');
}

load().then((add) => {
  readline.createInterface({ input: process.stdin }).on('line', (line) => {
    let said;
    try {
      said = answer(add, line);
    } catch (error) {
      said = `error ${String(error.message).replace(/\s+/g, ' ')}`;
    }
    process.stdout.write(`${said}\n`);
  });
});

// No-fit polygons by SVGnest or Deepnest, from their own source, one pair per line.
//
//   node nest.js svgnest orbit|clipper FOLDER
//   node nest.js deepnest clipper FOLDER
//
// A line of input contains "trajectory", "no_fit" or "inner_fit", and both polygons: the number of
// rings and, for each ring, the number of vertices and their coordinates. The answer is the number
// of rings and the rings in the same form, or a line that starts with "error".
'use strict';
const fs = require('fs');
const path = require('path');
const readline = require('readline');
const vm = require('vm');

const [project, method, folder] = process.argv.slice(2);
const quiet = () => {};
const world = { console: { log: quiet, time: quiet, timeEnd: quiet, warn: quiet }, alert: quiet };
world.window = world.self = world.global = world;
world.navigator = { userAgent: 'node', appName: 'node' };
vm.createContext(world);

function run(file, text) {
  const source = text || fs.readFileSync(path.join(folder, file), 'utf8');
  vm.runInContext(source, world, { filename: file });
}

// Return the source of a nested function.
function extract(source, name) {
  const start = source.indexOf(`function ${name}(`);
  if (start < 0) throw new Error(`no function ${name} in the source`);
  let depth = 0;
  for (let k = source.indexOf('{', start); k < source.length; k++) {
    if (source[k] === '{') depth++;
    if (source[k] === '}' && --depth === 0) return source.slice(start, k + 1);
  }
  throw new Error(`unbalanced braces in ${name}`);
}

if (project === 'svgnest') {
  run('util/clipper.js');
  run('util/geometryutil.js');
  const source = fs.readFileSync(path.join(folder, 'svgnest.js'), 'utf8');
  for (const name of ['toClipperCoordinates', 'toNestCoordinates', 'minkowskiDifference']) {
    // Several functions have these names; use those near minkowskiDifference.
    run(name, extract(source.slice(source.indexOf('p.map(function(pair)')), name));
  }
} else {
  run('main/util/clipper.js');
  run('main/util/geometryutil.js');
  const source = fs.readFileSync(path.join(folder, 'main/background.js'), 'utf8');
  for (const name of ['toClipperCoordinates', 'toNestCoordinates', 'getOuterNfp']) {
    run(name, extract(source, name));
  }
  world.db = { find: () => null, insert: quiet };
}

function orbit(part, d, g) {
  const geometry = world.GeometryUtil;
  const [exterior, ...holes] = d;
  if (part === 'inner_fit') {
    if (geometry.isRectangle(exterior, 0.001)) return geometry.noFitPolygonRectangle(exterior, g) || [];
    return geometry.noFitPolygon(exterior, g, true, true) || [];
  }
  const found = geometry.noFitPolygon(exterior, g, false, true);
  if (!found || !found.length) throw new Error('no answer');
  const rings = [...found];
  for (const hole of holes) {
    // A hole needs the orientation of a container; holes are clockwise here.
    rings.push(...(geometry.noFitPolygon(hole.reverse(), g, true, true) || []));
  }
  return rings;
}

function answer(line) {
  const words = line.split(' ');
  const part = words.shift();
  const numbers = words.map(Number);
  let at = 0;
  const shape = () => Array.from({ length: numbers[at++] }, () =>
    Array.from({ length: numbers[at++] }, () => ({ x: numbers[at++], y: numbers[at++] })));
  const d = shape();
  const [g] = shape();
  let rings;
  if (method === 'orbit') rings = orbit(part, d, g);
  else if (project === 'svgnest') rings = world.minkowskiDifference(d[0], g);
  else rings = [world.getOuterNfp(d[0], g, false)];
  if (!rings || !rings[0] && part !== 'inner_fit') throw new Error('no answer');
  const ring = (points) => [points.length, ...points.flatMap((p) => [p.x, p.y])].join(' ');
  return [rings.length, ...rings.map(ring)].join(' ');
}

readline.createInterface({ input: process.stdin }).on('line', (line) => {
  let said;
  try {
    said = answer(line);
  } catch (error) {
    said = `error ${String(error.message).replace(/\s+/g, ' ')}`;
  }
  process.stdout.write(`${said}\n`);
});

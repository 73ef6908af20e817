// No-fit polygons by SVGnest or Deepnest, from their own source, a pair a line.
//
//   node nest.js svgnest orbit|clipper FOLDER
//   node nest.js deepnest clipper FOLDER
//
// Reads a line: "trajectory", "no_fit" or "inner_fit"; the number of rings of the one polygon, and
// each ring as the number of its vertices and their coordinates; the same of the other one. Answers
// with the number of rings and the rings in the same form, or with a line that starts with "error".
'use strict';
const fs = require('fs');
const path = require('path');
const readline = require('readline');
const vm = require('vm');

const [project, way, folder] = process.argv.slice(2);
const quiet = () => {};
const world = { console: { log: quiet, time: quiet, timeEnd: quiet, warn: quiet }, alert: quiet };
world.window = world.self = world.global = world;
world.navigator = { userAgent: 'node', appName: 'node' };
vm.createContext(world);

function run(file, text) {
  const source = text || fs.readFileSync(path.join(folder, file), 'utf8');
  vm.runInContext(source, world, { filename: file });
}

// A function that is declared inside another one, as its source has it.
function extract(source, name) {
  const start = source.indexOf(`function ${name}(`);
  if (start < 0) throw new Error(`no function ${name}`);
  let depth = 0;
  for (let k = source.indexOf('{', start); k < source.length; k++) {
    if (source[k] === '{') depth++;
    if (source[k] === '}' && --depth === 0) return source.slice(start, k + 1);
  }
  throw new Error(`${name} does not end`);
}

if (project === 'svgnest') {
  run('util/clipper.js');
  run('util/geometryutil.js');
  const source = fs.readFileSync(path.join(folder, 'svgnest.js'), 'utf8');
  for (const name of ['toClipperCoordinates', 'toNestCoordinates', 'minkowskiDifference']) {
    // Of those with one name the last is the one beside minkowskiDifference.
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
    // Inside it wants the orientation of a bin, and holes run clockwise here.
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
  if (way === 'orbit') rings = orbit(part, d, g);
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

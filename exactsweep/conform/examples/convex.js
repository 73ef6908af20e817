// The trajectory of convex pairs of integers: the hull of the differences of their vertices.
// node convex.js
"use strict";
const readline = require("node:readline");

// Numbers come and go as strings: a JSON number of JavaScript is a double.
const read = (ring) => ring.map(([x, y]) => [BigInt(x), BigInt(y)]);
const write = (loop) => loop.map(([x, y]) => [String(x), String(y)]);
const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);

// The corners to the right of sorted points, without the last one.
function rightSide(points) {
  const found = [];
  for (const [x, y] of points) {
    while (found.length > 1) {
      const [[ax, ay], [bx, by]] = found.slice(-2);
      if ((bx - ax) * (y - ay) > (x - ax) * (by - ay)) break;
      found.pop();
    }
    found.push([x, y]);
  }
  return found.slice(0, -1);
}

// The answer to a case: put your own code in its place.
function answer(given) {
  if (given.class !== "CC") return { unsupported: "not convex" };
  const [d, g] = [read(given.directrix), read(given.generatrix)];
  const [[x, y]] = read([given.reference]);
  const sums = d.flatMap(([dx, dy]) => g.map(([gx, gy]) => [dx - gx + x, dy - gy + y]));
  sums.sort((p, q) => compare(p[0], q[0]) || compare(p[1], q[1]));
  const right = rightSide(sums);
  return { trajectory: write([...right, ...rightSide(sums.reverse())]) };
}

// One write a line: it is flushed at once, into a pipe, too.
const say = (line) => process.stdout.write(JSON.stringify(line) + "\n");
say({ hello: "convex.js", loops: ["trajectory"], numbers: "integer", reference: "given" });
const lines = readline.createInterface({ input: process.stdin });
lines.on("line", (line) => {
  const given = JSON.parse(line);
  if (given.bye) lines.close();
  else say({ id: given.id, ...answer(given) });
});

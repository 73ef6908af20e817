// Contacts of G at a stop, computed on demand in exact arithmetic. Floats only discard features
// that are farther apart than this; places are near 1, and their errors are far smaller.
const FAR = 1e-7;

// All contacts at an exact position, as [event, index in G, index in D]: VV for equal vertices,
// EV and VE for a vertex inside an edge, EE for edges that share a segment.
function contactsAt(position, [dx, dy]) {
  const { generatrix: g, directrix: d } = data;
  const moved = g.places.map((c, i) => c + (i % 2 ? dy : dx));
  const cornerOfG = cornersOf(g, [0, 1].map((axis) =>
    rational.minus(position[axis], rational.parse(data.reference[axis]))));
  const cornerOfD = cornersOf(d, [[0n, 1n], [0n, 1n]]);
  const shared = overlap(bounds(moved), bounds(d.places));
  const found = [];
  const pairs = [];
  for (const [i, j] of near(moved, g, d.places, d, shared)) {
    const where = between(cornerOfG(i), cornerOfD(j), cornerOfD(d.after[j]));
    if (where === "inside") found.push(["VE", g.vertices[i], d.edges[j]]);
    if (where === "start") found.push(["VV", g.vertices[i], d.vertices[j]]);
    if (where) pairs.push([i, j], [g.before[i], j]);
  }
  for (const [j, i] of near(d.places, d, moved, g, shared)) {
    const where = between(cornerOfD(j), cornerOfG(i), cornerOfG(g.after[i]));
    if (where === "inside") found.push(["EV", g.edges[i], d.vertices[j]]);
    if (where) pairs.push([i, j], [i, d.before[j]]);
  }
  // If two edges overlap, an end of one is on the other.
  const seen = new Set();
  for (const [i, j] of pairs) {
    if (seen.has(`${i} ${j}`)) continue;
    seen.add(`${i} ${j}`);
    const ends = [cornerOfG(i), cornerOfG(g.after[i]), cornerOfD(j), cornerOfD(d.after[j])];
    if (overlapAlong(...ends)) found.push(["EE", g.edges[i], d.edges[j]]);
  }
  return found.sort(([a, i, j], [b, k, l]) => (a < b ? -1 : a > b ? 1 : i - k || j - l));
}

// Momentary contacts at a stop, except those implied by a contact of two edges.
function briefContacts(track, k) {
  track.brief ||= [];
  if (track.brief[k]) return track.brief[k];
  const here = contactsAt(exactStop(k, track), placeOn(track, k));
  const lasting = [...track.contacts[k], ...track.contacts.at(k - 1)];
  const known = new Set(lasting.map(String));
  track.brief[k] = withoutParts(here, [...here, ...lasting]).filter(
    (contact) => !known.has(String(contact)),
  );
  return track.brief[k];
}

// Contacts except EV and VE contacts that an EE contact implies.
function withoutParts(contacts, all) {
  const parts = new Set();
  for (const [event, i, j] of all) {
    if (event !== "EE") continue;
    for (const end of endsOf(data.directrix, j)) parts.add(`EV,${i},${end}`);
    for (const end of endsOf(data.generatrix, i)) parts.add(`VE,${end},${j}`);
  }
  return contacts.filter((contact) => !parts.has(String(contact)));
}

function endsOf({ vertices, edgeOf, after }, number) {
  const k = edgeOf.get(number);
  return [vertices[k], vertices[after[k]]];
}

// The exact vertices of a translated polygon, cached.
function cornersOf({ exact }, by) {
  const read = new Map();
  return (k) => {
    if (!read.has(k)) {
      read.set(k, [0, 1].map((axis) => rational.plus(rational.parse(exact[2 * k + axis]), by[axis])));
    }
    return read.get(k);
  };
}

function overlap([a, b, c, d], [e, f, g, h]) {
  return [Math.max(a, e) - FAR, Math.max(b, f) - FAR, Math.min(c, g) + FAR, Math.min(d, h) + FAR];
}

// Candidate pairs of a vertex of one polygon and an edge of another in a box.
function* near(points, one, places, other, [left, low, right, high]) {
  const edges = [];
  for (let j = 0; j < other.after.length; j++) {
    const k = other.after[j];
    const [ax, ay, bx, by] = [places[2 * j], places[2 * j + 1], places[2 * k], places[2 * k + 1]];
    const box = [Math.min(ax, bx) - FAR, Math.min(ay, by) - FAR, Math.max(ax, bx) + FAR, Math.max(ay, by) + FAR];
    if (box[0] > right || box[2] < left || box[1] > high || box[3] < low) continue;
    edges.push([j, ax, ay, bx - ax, by - ay, ...box]);
  }
  for (let i = 0; i < one.after.length; i++) {
    const [x, y] = [points[2 * i], points[2 * i + 1]];
    if (x < left || x > right || y < low || y > high) continue;
    for (const [j, ax, ay, ux, uy, a, b, c, d] of edges) {
      if (x < a || x > c || y < b || y > d) continue;
      const off = Math.abs(ux * (y - ay) - uy * (x - ax));
      if (off <= FAR * (Math.abs(ux) + Math.abs(uy) + 1)) yield [i, j];
    }
  }
}

// The position of a point on an edge: "start", "inside", "end", or "" if it is off the edge.
function between(point, start, end) {
  if (rational.areEqual(point, start)) return "start";
  if (rational.areEqual(point, end)) return "end";
  const [u, v] = [rational.vector(start, point), rational.vector(point, end)];
  return rational.cross(u, v) === 0n && rational.dot(u, v) > 0n ? "inside" : "";
}

function overlapAlong(a, b, c, d) {
  const [u, v, w] = [rational.vector(a, b), rational.vector(a, c), rational.vector(a, d)];
  if (rational.cross(u, v) !== 0n || rational.cross(u, w) !== 0n) return false;
  // Numerators of parameters along edge ab.
  const along = (point) => rational.scalar(u, rational.vector(a, point));
  const [end, ...others] = [b, c, d].map(along);
  const [low, high] = rational.isLess(others[0], others[1]) ? others : others.reverse();
  return rational.isLess(low, end) && rational.isLess([0n, 1n], high);
}

// Features under the pointer, and their descriptions.

// The reach of the pointer, in pixels.
const REACH = 9;
const MAX_NAMED = 8;

function point(x, y) {
  pointer = [x, y];
  pointed = vertexAt(x, y) || fitAt(x, y) || undercutAt(x, y) || {};
  const tip = element("tip");
  tip.hidden = !pointed.lines;
  top.classList.toggle("on-generatrix", isOnGeneratrix(x, y));
  if (!pointed.lines) return;
  for (const node of [tip, element("pointed")]) setLines(node, pointed.lines);
  tip.style.left = `${x < view.width / 2 ? x + 14 : Math.max(0, x - 14 - tip.offsetWidth)}px`;
  tip.style.top = `${Math.max(0, Math.min(y + 12, view.height - tip.offsetHeight))}px`;
}

function vertexAt(x, y) {
  const [dx, dy] = place();
  const groups = [
    [data.generatrix.places, dx, dy, (k) => `vertex ${data.generatrix.vertices[k]} of G`, exactCorner],
    [data.directrix.places, 0, 0, (k) => `vertex ${data.directrix.vertices[k]} of D`, listed(data.directrix)],
    ...tracks.slice(0, firstFit).map((track) => [track.places, 0, 0, nameOfStop(track), listed(track)]),
    [data.inner.places, 0, 0, (k) => `vertex ${k} of the inner loop`, listed(data.inner)],
    [data.outer.places, 0, 0, (k) => `vertex ${k} of the outer loop`, listed(data.outer)],
    ...data.unswept.map((hole, i) => [hole.places, 0, 0, (k) => `vertex ${k} of unswept hole ${i}`, listed(hole)]),
  ];
  let best = REACH;
  const near = [];
  for (const [places, mx, my, name, exact] of groups) {
    for (let i = 0; i < places.length; i += 2) {
      const spot = [places[i] + mx, places[i + 1] + my];
      const off = Math.hypot(view.x(spot[0]) - x, view.y(spot[1]) - y);
      if (off <= best + 0.5) near.push({ off, spot, k: i / 2, name, exact });
      best = Math.min(best, off);
    }
  }
  const nearby = near.filter(({ off }) => off <= best + 0.5);
  if (!nearby.length) return null;
  const found = new Map();
  for (const { k, name, exact } of nearby.slice(0, MAX_NAMED)) {
    const text = exact(k);
    found.set(text, [...(found.get(text) || []), name(k)]);
  }
  const lines = [...found].flatMap(([text, names]) => [...names, text]);
  if (nearby.length > MAX_NAMED) lines.push(`and ${nearby.length - MAX_NAMED} more; zoom in to see them`);
  return { lines, place: nearby[0].spot };
}

const listed = ({ exact }) => (k) => `(${exact[2 * k]}, ${exact[2 * k + 1]})`;

const nameOfStop = ({ name, vertex }) => (k) =>
  vertex[k] === null ? `stop ${k}, on an edge of ${name}` : `vertex ${vertex[k]} of ${name}`;

// The current coordinates of a vertex of G.
function exactCorner(k) {
  const position = exactPosition();
  return pair([0, 1].map((axis) => {
    const own = rational.parse(data.generatrix.exact[2 * k + axis]);
    const reference = rational.parse(data.reference[axis]);
    return rational.plus(own, rational.minus(position[axis], reference));
  }));
}

function fitAt(x, y) {
  const k = data.fits.findIndex(({ places: [ax, ay, bx, by] }) =>
    nearest(x, y, view.x(ax), view.y(ay), view.x(bx), view.y(by))[1] < REACH);
  return k < 0 ? null : describeFit(k);
}

const isSingle = ({ exact: [ax, ay, bx, by] }) => ax === bx && ay === by;

function describeFit(k) {
  const fit = data.fits[k];
  const [start, inner] = [0, 1].map(listed(fit));
  return {
    fit,
    lines: [
      isSingle(fit)
        ? `exact fit ${k}: G fits at ${inner} and cannot move`
        : `exact fit ${k}: G can slide from ${start} to ${inner}, touching D on both sides`,
    ],
  };
}

function undercutAt(x, y) {
  const [px, py] = view.place(x, y);
  const k = data.undercuts.findIndex(({ places }) => contains([places], px, py));
  return k < 0 ? null : describeUndercut(k);
}

function describeUndercut(k) {
  const undercut = data.undercuts[k];
  const [a, b] = [0, 1].map(listed({ exact: undercut.extremes }));
  const positions = [...new Set(undercut.stops)].map(listed(tracks[0]));
  const shown = positions.slice(0, 4).join(undercut.slides ? " to " : ", ");
  return {
    undercut,
    lines: [
      `undercut ${k}, area ${[undercut.area, about([rational.parse(undercut.area)])].filter(Boolean).join(", ")}`,
      `extreme contact points ${a} and ${b}`,
      `closed by G ${undercut.slides ? "from" : "at"} ${shown}${positions.length > 4 ? ", ..." : ""}`,
    ],
  };
}

// Move to the next undercut along the trajectory, or to another one at the same stop.
function visitUndercut() {
  const { span } = tracks[0];
  const shown = pointed.undercut ? pointed.number : -1;
  const here = stops === tracks[0] ? at : 0;
  const ahead = data.undercuts.map(
    ({ stops: [first] }, k) => (first * PARTS - here + span) % span || (k > shown ? 0 : span),
  );
  const k = ahead.indexOf(Math.min(...ahead));
  visit(k, "undercut", () => moveTo(data.undercuts[k].stops[0] * PARTS, tracks[0]), describeUndercut);
}

// Move to the next exact fit, starting at its end on a loop.
function visitFit() {
  const shown = isFit(stops) ? tracks.indexOf(stops) - firstFit : -1;
  const k = data.fits.length ? (shown + 1) % data.fits.length : -1;
  visit(k, "exact fit", () => moveTo(0, tracks[firstFit + k]), describeFit);
}

function visit(k, name, move, describe) {
  pointer = null;
  element("tip").hidden = true;
  if (k < 0) {
    pointed = {};
    setLines(element("pointed"), [`There is no ${name}.`]);
    return;
  }
  move();
  pointed = { ...describe(k), number: k };
  setLines(element("pointed"), pointed.lines);
}

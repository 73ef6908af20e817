// The page: state, panel and motion of G.

const data = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);

// The number of positions between two stops; each has exact coordinates.
const PARTS = 1_000_000;
const SLIDER_STEP = PARTS / 1000;
const ROUND_SECONDS = 24;
// The distance, in pixels, at which a dragged G snaps to another track.
const SNAP = 12;

// Tracks: the trajectory, holes of the no-fit polygon, and exact fits, traced back and forth.
const { tracks } = data;
const firstFit = data.loops;
for (const track of tracks) {
  track.size = track.contacts.length;
  track.span = track.size * PARTS;
  track.lengths = track.contacts.map((_, k) => {
    const [[ax, ay], [bx, by]] = [placeOn(track, k), placeOn(track, k + 1)];
    return Math.hypot(bx - ax, by - ay);
  });
  track.around = track.lengths.reduce((sum, length) => sum + length, 0);
}
for (const polygon of [data.generatrix, data.directrix]) {
  polygon.vertexOf = new Map(polygon.vertices.map((number, k) => [number, k]));
  polygon.edgeOf = new Map(polygon.edges.map((number, k) => [number, k]));
  const around = (step) => {
    let first = 0;
    return polygon.rings.flatMap((size) => {
      first += size;
      return Array.from({ length: size }, (_, i) => first - size + (i + step + size) % size);
    });
  };
  polygon.after = around(1);
  polygon.before = around(-1);
}

const all = [data.directrix, data.outer, ...tracks].flatMap(({ places }) => places);
const view = new View(bounds(all), data.stretched, data.down);
const scene = new Scene(data, view, element("ground"), element("top"));
const top = element("top");

// State: a track, and the number of steps from its first stop.
let stops = tracks[0];
let at = 0;
let pointed = {};
let pointer = null;
let playing = null;

const stopBefore = () => Math.floor(at / PARTS) % stops.size;
const stopPlace = (k) => placeOn(stops, k);

function placeOn({ places, contacts }, k) {
  const i = 2 * (k % contacts.length);
  return [places[i], places[i + 1]];
}

// The location of the anchor; at a stop, exactly as in the data.
function place() {
  const k = stopBefore();
  const share = (at % PARTS) / PARTS;
  const [ax, ay] = stopPlace(k);
  const [bx, by] = stopPlace(k + 1);
  return [ax + share * (bx - ax), ay + share * (by - ay)];
}

function exactStop(k, track = stops) {
  return [0, 1].map((axis) => rational.parse(track.exact[2 * (k % track.size) + axis]));
}

// The exact position of the reference point.
function exactPosition() {
  const [start, end] = [exactStop(stopBefore()), exactStop(stopBefore() + 1)];
  const share = rational.reduced(BigInt(at % PARTS), BigInt(PARTS));
  return [0, 1].map((axis) =>
    rational.plus(start[axis], rational.times(share, rational.minus(end[axis], start[axis]))),
  );
}

const pair = (exact) => `(${exact.map(rational.text).join(", ")})`;
const about = (exact) => {
  const short = exact.map((number) => rational.about(number) || rational.text(number));
  return exact.some(rational.about) ? `about ${short.length > 1 ? `(${short.join(", ")})` : short}` : "";
};

// Contacts, with a note for those that begin or end at the stop.
function contactsHere() {
  if (data.asked !== "sweep") return contactsAnywhere().map((contact) => ({ contact, note: "" }));
  const k = stopBefore();
  const onward = stops.contacts[k];
  if (at % PARTS) return onward.map((contact) => ({ contact, note: "" }));
  const lasts = new Set(onward.map(String));
  const before = stops.contacts.at(k - 1);
  const lasted = new Set(before.map(String));
  return [
    ...briefContacts(stops, k).map((contact) => ({
      contact,
      note: contact[0] === "VV" ? "" : ", here only",
    })),
    ...before
      .filter((contact) => !lasts.has(String(contact)))
      .map((contact) => ({ contact, note: ", until here" })),
    ...onward.map((contact) => ({
      contact,
      note: lasted.has(String(contact)) ? "" : ", from here on",
    })),
  ];
}

// Contacts that are not stored, cached for the current place.
let found = { at: null };
function contactsAnywhere() {
  if (found.at !== at || found.stops !== stops) {
    const here = contactsAt(exactPosition(), place());
    found = { at, stops, contacts: withoutParts(here, here) };
  }
  return found.contacts;
}

function words([event, i, j]) {
  const g = `${event[0] === "E" ? "edge" : "vertex"} ${i} of G`;
  const d = `${event[1] === "E" ? "edge" : "vertex"} ${j} of D`;
  return `${g} on ${d}`;
}

// Update the picture and the panel, at most once per frame.
let isGroundStale = true;
let isWaiting = false;
function refresh(isAll) {
  isGroundStale ||= isAll;
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(() => {
    isWaiting = false;
    if (isGroundStale) scene.drawGround();
    isGroundStale = false;
    scene.drawTop(place(), contactsHere().map(({ contact }) => contact), pointed);
    write();
  });
}

function write() {
  const k = stopBefore();
  const exact = exactPosition();
  const position = pair(exact);
  setNumber(element("position"), position);
  setText(element("position-about"), about(exact));
  const where = whereIs(k);
  setText(element("where"), where);
  const list = contactsHere().map(({ contact, note }) => [contact[0], ` ${words(contact)}${note}`]);
  const spoken = list.map((item) => item.join("")).join("; ");
  if (element("contacts").dataset.spoken !== spoken) {
    element("contacts").dataset.spoken = spoken;
    element("contacts").replaceChildren(...list.map(([event, text]) => {
      const item = document.createElement("li");
      const name = document.createElement("b");
      name.className = name.textContent = event;
      item.append(name, text);
      return item;
    }));
  }
  const slider = element("slider");
  slider.value = at;
  slider.setAttribute("aria-valuetext", `${about(exact) || position}, ${where}`);
}

function whereIs(k) {
  const { name, size, vertex } = stops;
  if (size === 1) return `${name}, a single position`;
  if (at % PARTS) return `between stops ${k} and ${(k + 1) % size} of ${size}${stops === tracks[0] ? "" : `, ${name}`}`;
  const here = vertex[k] === null ? "a stop on an edge" : `${isFit(stops) ? "end" : "vertex"} ${vertex[k]}`;
  return `${here} of ${name}, stop ${k} of ${size}`;
}

const isFit = (track) => tracks.indexOf(track) >= firstFit;

function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

// Shorten long numbers; copying uses the full text.
function setNumber(node, text) {
  node.dataset.full = text;
  setText(node, text.replace(/-?\d+(\/\d+)?/g, rational.brief));
}

function setLines(node, lines) {
  node.dataset.full = lines.join("\n");
  node.replaceChildren(...lines.map((line) => {
    const item = document.createElement("div");
    setNumber(item, line);
    return item;
  }));
}

function moveTo(parts, track = stops) {
  if (track !== stops) {
    stops = track;
    element("slider").max = stops.span;
    element("track").value = tracks.indexOf(stops);
    element("contacts").dataset.spoken = "";
  }
  at = Math.min(stops.span, Math.max(0, Math.round(parts)));
  if (pointer) point(...pointer);
  refresh(false);
}

function moveToStop(k) {
  moveTo(((k % stops.size) + stops.size) % stops.size * PARTS);
}

// Animate G along the track at constant speed.
function play(isOn) {
  const button = document.querySelector("[data-do=play]");
  // Do not announce each contact to screen readers.
  element("contacts").setAttribute("aria-live", isOn ? "off" : "polite");
  button.setAttribute("aria-label", isOn ? "Pause" : "Play");
  button.textContent = isOn ? "\u275a\u275a Pause" : "\u25b6 Play";
  cancelAnimationFrame(playing);
  playing = null;
  if (!isOn) return;
  let last = null;
  let exact = at;
  const step = (now) => {
    if (at !== Math.round(exact)) exact = at;
    const { around, lengths, size } = stops;
    let distance = last === null ? 0 : (around * (now - last)) / 1000 / ROUND_SECONDS;
    last = now;
    for (;;) {
      const k = Math.floor(exact / PARTS) % size;
      const left = (1 - (exact % PARTS) / PARTS) * lengths[k];
      if (distance < left) {
        exact += (distance / lengths[k]) * PARTS;
        break;
      }
      distance -= left;
      exact = (k + 1) % size * PARTS;
      if (!left) break;
    }
    moveTo(exact);
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
}

// Drag G to the nearest point of the track, preferring points that are close along the track.
function slideTo(x, y) {
  const [tx, ty] = view.place(x, y);
  const [px, py] = place();
  const { kx, ky } = view;
  const limit = 3 * Math.hypot(kx * (px - tx), ky * (py - ty)) + 2 / view.zoom.k;
  let best = [Infinity, at];
  const start = stopBefore();
  const { size } = stops;
  for (const direction of [1, -1]) {
    let traveled = 0;
    for (let n = 0; n <= size && traveled <= limit; n++) {
      const k = (((start + direction * n) % size) + size) % size;
      const [[ax, ay], [bx, by]] = [stopPlace(k), stopPlace(k + 1)];
      const [share, off] = nearest(kx * tx, ky * ty, kx * ax, ky * ay, kx * bx, ky * by);
      if (off < best[0]) best = [off, (k + share) * PARTS];
      if (n) traveled += Math.hypot(kx * (bx - ax), ky * (by - ay));
    }
  }
  let track = stops;
  if (best[0] * view.zoom.k > SNAP) [track, best] = snapped(x, y, best);
  const stop = Math.round(best[1] / PARTS);
  const [sx, sy] = placeOn(track, stop);
  const [ax, ay] = placeOn(track, Math.floor(best[1] / PARTS));
  const [bx, by] = placeOn(track, Math.floor(best[1] / PARTS) + 1);
  const share = (best[1] % PARTS) / PARTS;
  const dx = view.x(ax + share * (bx - ax)) - view.x(sx);
  const dy = view.y(ay + share * (by - ay)) - view.y(sy);
  moveTo(Math.hypot(dx, dy) < 5 ? (stop % track.size) * PARTS : best[1] % track.span, track);
}

// Return another track near the pointer, if there is one.
function snapped(x, y, best) {
  let found = [stops, best];
  let reach = SNAP;
  for (const track of tracks) {
    if (track === stops) continue;
    for (let k = 0; k < track.size; k++) {
      const [[ax, ay], [bx, by]] = [placeOn(track, k), placeOn(track, k + 1)];
      const [share, off] = nearest(x, y, view.x(ax), view.y(ay), view.x(bx), view.y(by));
      if (off >= reach) continue;
      reach = off;
      found = [track, [off, (k + share) * PARTS]];
    }
  }
  return found;
}

function isOnGeneratrix(x, y) {
  const [px, py] = view.place(x, y);
  const [dx, dy] = place();
  return contains(ringsOf(data.generatrix.rings, data.generatrix.places), px - dx, py - dy);
}

// The page: where G is, what is told of it, and how it moves.

const data = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);

// Between two stops, G stands at one of so many places; the exact position is known at each.
const PARTS = 1_000_000;
const SLIDER_STEP = PARTS / 1000;
const ROUND_SECONDS = 24;

const stops = data.stops;
const size = stops.contacts.length;
const SPAN = size * PARTS;
for (const polygon of [data.generatrix, data.directrix]) {
  polygon.vertexOf = new Map(polygon.vertices.map((number, k) => [number, k]));
  polygon.edgeOf = new Map(polygon.edges.map((number, k) => [number, k]));
}

const view = new View(bounds([...data.outer.places, ...stops.places]), data.stretched);
const scene = new Scene(data, view, element("ground"), element("top"));
const top = element("top");

// Where G is: parts from the first stop, an integer from 0 to SPAN.
let at = 0;
let pointed = {};
let pointer = null;
let playing = null;

const stopBefore = () => Math.floor(at / PARTS) % size;
const stopPlace = (k) => [stops.places[2 * (k % size)], stops.places[2 * (k % size) + 1]];

// Where the anchor is; at a stop exactly the place in the data.
function place() {
  const k = stopBefore();
  const share = (at % PARTS) / PARTS;
  const [ax, ay] = stopPlace(k);
  const [bx, by] = stopPlace(k + 1);
  return [ax + share * (bx - ax), ay + share * (by - ay)];
}

function exactStop(k) {
  return [0, 1].map((axis) => rational.parse(stops.exact[2 * (k % size) + axis]));
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

// What touches, each with a note: at a stop, whether it ends or begins there.
function contactsHere() {
  const k = stopBefore();
  const onward = stops.contacts[k];
  if (at % PARTS) return onward.map((contact) => ({ contact, note: "" }));
  const lasts = new Set(onward.map(String));
  const before = stops.contacts.at(k - 1);
  const lasted = new Set(before.map(String));
  return [
    ...stops.brief[k].map((contact) => ({
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

function words([event, i, j]) {
  const g = `${event[0] === "E" ? "edge" : "vertex"} ${i} of G`;
  const d = `${event[1] === "E" ? "edge" : "vertex"} ${j} of D`;
  return `${g} on ${d}`;
}

// Drawing and writing, at most once a frame.
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
  setText(element("position"), position);
  setText(element("position-about"), about(exact));
  const number = stops.vertex[k];
  const here = number === null ? "a stop on an edge" : `vertex ${number}`;
  const where = at % PARTS ? `between stops ${k} and ${(k + 1) % size} of ${size}` : `${here} of the trajectory, stop ${k} of ${size}`;
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

function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

function setLines(node, lines) {
  node.replaceChildren(...lines.map((line) => {
    const item = document.createElement("div");
    item.textContent = line;
    return item;
  }));
}

function moveTo(parts) {
  at = Math.min(SPAN, Math.max(0, Math.round(parts)));
  if (pointer) point(...pointer);
  refresh(false);
}

function moveToStop(k) {
  moveTo(((k % size) + size) % size * PARTS);
}

// Round and round, at an even pace along the trajectory.
const lengths = stops.contacts.map((_, k) => {
  const [[ax, ay], [bx, by]] = [stopPlace(k), stopPlace(k + 1)];
  return Math.hypot(bx - ax, by - ay);
});
const around = lengths.reduce((sum, length) => sum + length, 0);

function play(isOn) {
  const button = document.querySelector("[data-do=play]");
  // Nobody wants to hear each contact on the way.
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
    let way = last === null ? 0 : (around * (now - last)) / 1000 / ROUND_SECONDS;
    last = now;
    for (;;) {
      const k = Math.floor(exact / PARTS) % size;
      const left = (1 - (exact % PARTS) / PARTS) * lengths[k];
      if (way < left) {
        exact += (way / lengths[k]) * PARTS;
        break;
      }
      way -= left;
      exact = (k + 1) % size * PARTS;
      if (!left) break;
    }
    moveTo(exact);
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
}

// Sliding under the pointer: to the nearest place that is not much farther off along the way.
function slideTo(x, y) {
  const [tx, ty] = view.place(x, y);
  const [px, py] = place();
  const { kx, ky } = view;
  const limit = 3 * Math.hypot(kx * (px - tx), ky * (py - ty)) + 2 / view.zoom.k;
  let best = [Infinity, at];
  const start = stopBefore();
  for (const way of [1, -1]) {
    let travelled = 0;
    for (let n = 0; n <= size && travelled <= limit; n++) {
      const k = (((start + way * n) % size) + size) % size;
      const [[ax, ay], [bx, by]] = [stopPlace(k), stopPlace(k + 1)];
      const [share, off] = nearest(kx * tx, ky * ty, kx * ax, ky * ay, kx * bx, ky * by);
      if (off < best[0]) best = [off, (k + share) * PARTS];
      if (n) travelled += Math.hypot(kx * (bx - ax), ky * (by - ay));
    }
  }
  const stop = Math.round(best[1] / PARTS);
  const [sx, sy] = stopPlace(stop);
  const [ax, ay] = stopPlace(Math.floor(best[1] / PARTS));
  const [bx, by] = stopPlace(Math.floor(best[1] / PARTS) + 1);
  const share = (best[1] % PARTS) / PARTS;
  const dx = view.x(ax + share * (bx - ax)) - view.x(sx);
  const dy = view.y(ay + share * (by - ay)) - view.y(sy);
  moveTo(Math.hypot(dx, dy) < 5 ? (stop % size) * PARTS : best[1] % SPAN);
}

function isOnGeneratrix(x, y) {
  const [px, py] = view.place(x, y);
  const [dx, dy] = place();
  return contains(data.generatrix.places, px - dx, py - dy);
}

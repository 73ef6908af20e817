// Zooming and panning, search for parts, and steps through the faults.
"use strict";
const picture = document.getElementById("picture");
const whole = picture.viewBox.baseVal;
const full = { x: whole.x, y: whole.y, width: whole.width, height: whole.height };
const status = document.getElementById("status");
const rows = [...document.querySelectorAll("tr[data-parts]")];
const MOST = 64;
let box = { ...full };
let current = -1;

function show(next) {
  const width = Math.min(full.width, Math.max(full.width / MOST, next.width));
  const share = width / full.width;
  const height = full.height * share;
  const x = Math.min(full.x + full.width - width, Math.max(full.x, next.x + (next.width - width) / 2));
  const y = Math.min(full.y + full.height - height, Math.max(full.y, next.y + (next.height - height) / 2));
  box = { x, y, width, height };
  picture.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
  picture.style.setProperty("--share", share);
  for (const mark of picture.querySelectorAll("circle.mark")) mark.setAttribute("r", 10 * share);
}

function zoom(factor, x = box.x + box.width / 2, y = box.y + box.height / 2) {
  const width = Math.min(full.width, Math.max(full.width / MOST, box.width / factor));
  const by = width / box.width;
  show({ x: x - (x - box.x) * by, y: y - (y - box.y) * by, width, height: box.height * by });
}

function place(event) {
  const frame = picture.getBoundingClientRect();
  return [
    box.x + ((event.clientX - frame.left) / frame.width) * box.width,
    box.y + ((event.clientY - frame.top) / frame.height) * box.height,
  ];
}

picture.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(2 ** (-event.deltaY / 300), ...place(event));
}, { passive: false });

const pointers = new Map();
picture.addEventListener("pointerdown", (event) => {
  pointers.set(event.pointerId, place(event));
});
picture.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const now = place(event);
  if (pointers.size === 2) {
    const [, other] = [...pointers].find(([id]) => id !== event.pointerId);
    const far = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
    zoom(far(now) / Math.max(far(before), 1e-9), ...other);
  } else {
    picture.setPointerCapture(event.pointerId);
    show({ ...box, x: box.x + before[0] - now[0], y: box.y + before[1] - now[1] });
  }
  pointers.set(event.pointerId, place(event));
});
for (const end of ["pointerup", "pointercancel"])
  picture.addEventListener(end, (event) => pointers.delete(event.pointerId));
picture.addEventListener("dblclick", (event) => zoom(2, ...place(event)));

function focusOn(numbers, text) {
  for (const old of picture.querySelectorAll(".found")) old.classList.remove("found");
  const parts = numbers.map((k) => document.getElementById(`part-${k}`)).filter(Boolean);
  if (!parts.length) return;
  for (const part of parts) part.classList.add("found");
  const boxes = parts.map((part) => part.getBBox());
  const x = Math.min(...boxes.map((one) => one.x)), y = Math.min(...boxes.map((one) => one.y));
  const right = Math.max(...boxes.map((one) => one.x + one.width));
  const low = Math.max(...boxes.map((one) => one.y + one.height));
  const share = Math.max((right - x) / full.width, (low - y) / full.height);
  const width = Math.max(full.width * share, 8) * 1.6, height = (width * full.height) / full.width;
  show({ x: (x + right - width) / 2, y: (y + low - height) / 2, width, height });
  status.textContent = text;
}

function showFault(k) {
  if (!rows.length) return;
  current = (k + rows.length) % rows.length;
  rows.forEach((row, i) => row.classList.toggle("current", i === current));
  const row = rows[current];
  focusOn(row.dataset.parts.split(" ").filter(Boolean), row.title);
}

rows.forEach((row, k) => {
  row.addEventListener("click", () => {
    showFault(k);
    picture.scrollIntoView({ block: "nearest" });
  });
});

const names = [...picture.querySelectorAll("[data-name]")];
const find = document.getElementById("find");
find.addEventListener("change", () => {
  const word = find.value.trim().toLowerCase();
  if (!word) return;
  const exact = names.filter((part) => part.dataset.name.toLowerCase() === word);
  const found = exact.length ? exact : names.filter((part) => part.dataset.name.toLowerCase().includes(word));
  if (!found.length) status.textContent = `no part ${find.value}`;
  else focusOn(found.slice(0, 1).map((part) => part.id.slice(5)), `${found[0].dataset.name}${found.length > 1 ? `, the first of ${found.length}` : ""}`);
});

const actions = {
  closer: () => zoom(1.5),
  farther: () => zoom(1 / 1.5),
  all: () => show(full),
  next: () => showFault(current + 1),
  previous: () => showFault(current - 1),
};
for (const [name, act] of Object.entries(actions)) {
  const button = document.getElementById(name);
  if (button) button.addEventListener("click", act);
}
const keys = { "+": "closer", "-": "farther", 0: "all", n: "next", p: "previous" };
document.addEventListener("keydown", (event) => {
  if (event.target !== find && keys[event.key]) actions[keys[event.key]]();
});
document.body.classList.add("live");

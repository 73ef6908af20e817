// Pointer, wheel, touch, keyboard and buttons.

// While the pointer moves, slow drawings are moved as an image.
const REST = 120;
let resting = null;

// What the arrow keys move when the picture has the focus: G after a drag.
let arrowsMove = "picture";

const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
const zoom = d3.zoom().scaleExtent([0.5, 1e9]).duration(isStill ? 0 : 250).on("zoom", ({ transform }) => {
  view.zoom = transform;
  clearTimeout(resting);
  if (scene.isDense) {
    scene.moveGround();
    resting = setTimeout(refresh, REST, true);
  }
  refresh(!scene.isDense);
});
const surface = d3.select(top);
const zoomBy = (factor) => surface.call(zoom.scaleBy, factor);
const pan = (x, y) => surface.call(zoom.translateBy, x / view.zoom.k, y / view.zoom.k);

surface
  .call(
    d3.drag()
      .subject(({ x, y }) => {
        if (!isOnGeneratrix(x, y)) return null;
        const [px, py] = place();
        return { x: view.x(px), y: view.y(py) };
      })
      .on("start", () => {
        play(false);
        arrowsMove = "generatrix";
        pointer = null;
        element("tip").hidden = true;
      })
      .on("drag", ({ x, y }) => slideTo(x, y)),
  )
  .call(zoom)
  .on("pointermove", (event) => {
    if (event.buttons) return;
    point(event.offsetX, event.offsetY);
    refresh(false);
  })
  .on("pointerdown", (event) => {
    if (!isOnGeneratrix(event.offsetX, event.offsetY)) arrowsMove = "picture";
    // Touch has no hover.
    if (event.pointerType !== "touch") return;
    point(event.offsetX, event.offsetY);
    refresh(false);
  })
  .on("pointerleave", (event) => {
    if (event.pointerType === "touch") return;
    pointer = null;
    pointed = {};
    element("tip").hidden = true;
    refresh(false);
  });

// Zoom until G fills a third of the picture.
function zoomToGeneratrix() {
  const [px, py] = place();
  const [left, low, right, high] = bounds(data.generatrix.places);
  const sizes = [view.width / (view.kx * (right - left)), view.height / (view.ky * (high - low))];
  const k = Math.min(zoom.scaleExtent()[1], Math.min(...sizes) / 3);
  const x = view.x0 + view.kx * (px + (left + right) / 2);
  const y = view.y0 + view.sign * view.ky * (py + (low + high) / 2);
  const shown = d3.zoomIdentity.translate(view.width / 2 - k * x, view.height / 2 - k * y).scale(k);
  surface.call(zoom.transform, shown);
}

const actions = {
  closer: () => zoomBy(1.5),
  farther: () => zoomBy(1 / 1.5),
  whole: () => surface.call(zoom.transform, d3.zoomIdentity),
  generatrix: zoomToGeneratrix,
  back: () => moveToStop(at % PARTS ? stopBefore() : stopBefore() - 1),
  on: () => moveToStop(stopBefore() + 1),
  play: () => play(playing === null),
  start: () => moveTo(0),
  end: () => moveTo(stops.span),
  undercut: visitUndercut,
  fit: visitFit,
  track: () => moveTo(0, tracks[(tracks.indexOf(stops) + 1) % tracks.length]),
  grid() {
    scene.hasGrid = !scene.hasGrid;
    refresh(true);
  },
};
const keys = {
  "+": "closer", "=": "closer", "-": "farther", 0: "whole", PageUp: "back", PageDown: "on",
  z: "generatrix", Home: "start", End: "end", " ": "play", u: "undercut", f: "fit", t: "track", g: "grid",
};
const slides = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
const pans = { ArrowRight: [-1, 0], ArrowLeft: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

document.documentElement.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key, target } = event;
  // The panel keeps the keys for scrolling, a button the space bar, and a list all keys.
  const isOwn = target.matches("select") || target.closest("aside")
    ? slides[key] || [" ", "PageUp", "PageDown", "Home", "End"].includes(key)
    : key === " " && target.matches("button");
  if (isOwn) return;
  const action = keys[key.length === 1 ? key.toLowerCase() : key];
  if (target === top && pans[key] && arrowsMove === "picture") pan(...pans[key].map((step) => step * 60));
  else if (slides[key]) {
    const step = event.shiftKey ? SLIDER_STEP : 20 * SLIDER_STEP;
    moveTo((at + slides[key] * step + stops.span) % stops.span);
  } else if (action) actions[action]();
  else return;
  event.preventDefault();
});

for (const button of document.querySelectorAll("[data-do]")) {
  button.addEventListener("click", () => actions[button.dataset.do]());
}
for (const button of document.querySelectorAll("[data-copy]")) {
  button.addEventListener("click", async () => {
    const isCopied = await copied(element(button.dataset.copy).dataset.full || "");
    button.textContent = isCopied ? "copied" : "not permitted";
    setTimeout(() => setText(button, "copy"), 1500);
  });
}

// Without clipboard access, a page can still copy a selection.
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = document.body.appendChild(document.createElement("textarea"));
    field.value = text;
    field.select();
    const isCopied = document.execCommand("copy");
    field.remove();
    return isCopied;
  }
}

element("track").replaceChildren(...tracks.map(({ name }, k) => new Option(name, k)));
element("track").hidden = tracks.length === 1;
element("track").addEventListener("change", ({ target }) => {
  play(false);
  moveTo(0, tracks[target.value]);
});
element("slider").max = stops.span;
element("slider").step = SLIDER_STEP;
element("slider").addEventListener("input", ({ target }) => {
  play(false);
  moveTo(Number(target.value));
});

new ResizeObserver(([{ contentRect }]) => {
  scene.resize(Math.max(1, contentRect.width), Math.max(1, contentRect.height));
  zoom.extent([[0, 0], [view.width, view.height]]);
  refresh(true);
}).observe(element("stage"));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  scene.readColors();
  refresh(true);
});

setText(document.querySelector("h1"), data.title);
setText(element("class"), data.class);
setNumber(element("area"), data.area);
for (const [k, id] of ["called-g", "called-d"].entries()) {
  setText(element(id), data.names ? `, ${data.names[k]}` : "");
}
setText(element("area-about"), about([rational.parse(data.area)]));
setText(element("path"), `of the reference point of G${data.path && `; the dot is ${data.path}`}`);
setText(element("undercuts"), `undercut (${data.undercuts.length})`);
setText(element("fits"), `exact fit (${data.fits.length})`);
const holes = data.loops - data.outside;
setText(element("holes"), data.outside ? `hole of the no-fit polygon (${holes})` : `free positions (${holes})`);
element("hole").hidden = !holes;
setText(element("area-name"), data.areaName);
for (const item of document.querySelectorAll(".of-sweep")) item.hidden = data.asked !== "sweep";
element("stretched").hidden = !data.stretched;
element("incomplete").hidden = data.hasMeetings;

// An interface for scripts.
window.exactsweep = {
  track: () => stops.name,
  position: () => exactPosition().map(rational.text),
  corners() {
    const [dx, dy] = place();
    return data.generatrix.places.map((c, i) => c + (i % 2 ? dy : dx));
  },
  pixels: () => Array.from(view.pixels(data.generatrix.places, ...place())),
  roundStep,
  contacts: (k, track) => contactsAt(exactStop(k, tracks[track]), placeOn(tracks[track], k)),
  brief: (k, track) => briefContacts(tracks[track], k),
  about: (text) => rational.about(rational.parse(text)),
};

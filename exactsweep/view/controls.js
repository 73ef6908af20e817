// Pointer, wheel, touch, keyboard and buttons.

// What takes long to draw is moved as a picture until the hand rests.
const REST = 120;
let resting = null;

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
    // A finger does not hover.
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

const actions = {
  closer: () => zoomBy(1.5),
  farther: () => zoomBy(1 / 1.5),
  whole: () => surface.call(zoom.transform, d3.zoomIdentity),
  back: () => moveToStop(at % PARTS ? stopBefore() : stopBefore() - 1),
  on: () => moveToStop(stopBefore() + 1),
  play: () => play(playing === null),
  start: () => moveTo(0),
  end: () => moveTo(stops.span),
  undercut: visitUndercut,
  fit: visitFit,
  track: () => moveTo(0, tracks[(tracks.indexOf(stops) + 1) % tracks.length]),
};
const keys = {
  "+": "closer", "=": "closer", "-": "farther", 0: "whole", PageUp: "back", PageDown: "on",
  Home: "start", End: "end", " ": "play", u: "undercut", f: "fit", t: "track",
};
const slides = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
const pans = { ArrowRight: [-1, 0], ArrowLeft: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

document.documentElement.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key, target } = event;
  // In the panel, these keys scroll; on a button, the space bar presses it; a list has keys itself.
  const isOwn = target.matches("select") || target.closest("aside")
    ? slides[key] || [" ", "PageUp", "PageDown", "Home", "End"].includes(key)
    : key === " " && target.matches("button");
  if (isOwn) return;
  const action = keys[key.length === 1 ? key.toLowerCase() : key];
  if (target === top && pans[key]) pan(...pans[key].map((step) => step * 60));
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
setText(element("area"), data.area);
setText(element("area-about"), about([rational.parse(data.area)]));
setText(element("path"), `of the reference point of G${data.path && `; the dot is ${data.path}`}`);
setText(element("undercuts"), `undercut (${data.undercuts.length})`);
setText(element("fits"), `exact fit (${data.fits.length})`);
setText(element("holes"), `hole of the no-fit polygon (${data.holes})`);
element("hole").hidden = !data.holes;
element("stretched").hidden = !data.stretched;
element("incomplete").hidden = data.allBrief;

// For scripts: where G is, exactly, where its corners are drawn, and long numbers in short.
window.exactsweep = {
  track: () => stops.name,
  position: () => exactPosition().map(rational.text),
  corners() {
    const [dx, dy] = place();
    return data.generatrix.places.map((c, i) => c + (i % 2 ? dy : dx));
  },
  pixels: () => Array.from(view.pixels(data.generatrix.places, ...place())),
  about: (text) => rational.about(rational.parse(text)),
};

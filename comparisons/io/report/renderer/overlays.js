// The place that shows one overlay at a time, and the links from matrices to it.

const overlayPlaces = new Map();   // id -> { show }
const chosenListeners = new Map(); // id -> functions (key, highlight)

function onChosen(id, listener) {
  if (!chosenListeners.has(id)) chosenListeners.set(id, []);
  chosenListeners.get(id).push(listener);
}

function chooseOverlay(id, key, highlight) {
  overlayPlaces.get(id).show(key, highlight);
}

function renderOverlays(overlays, later) {
  const title = element("h3", { "aria-live": "polite" });
  const note = element("p", { class: "note" });
  const tables = element("div", { class: "overlay-tables" });
  const group = figureGroup();
  const root = element("div", { class: "overlays", id: `overlays-${overlays.id}` }, title, note, group.root, tables);

  function show(key, highlight) {
    const overlay = overlays.items.find((item) => item.key === key);
    root.dataset.shown = key;
    title.textContent = highlight ? `${overlay.title}: ${highlight} brought forward` : overlay.title;
    note.textContent = overlay.note;
    note.hidden = overlay.note === "";
    const draw = group.show(overlay.figures, highlight);
    tables.replaceChildren(...overlay.tables.map(renderTable));
    (chosenListeners.get(overlays.id) ?? []).forEach((listener) => listener(key, highlight));
    return draw;
  }

  overlayPlaces.set(overlays.id, {
    show(key, highlight) {
      show(key, highlight)();
      const box = root.getBoundingClientRect();
      const visible = Math.min(box.bottom, window.innerHeight) - Math.max(box.top, 0);
      if (visible < Math.min(box.height, window.innerHeight) / 2) root.scrollIntoView({ block: "start" });
    },
  });
  later.push(() => show(overlays.chosen, "")());
  return root;
}

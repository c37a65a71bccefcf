// Puts the page together.

const kDark = matchMedia('(prefers-color-scheme: dark)');
const kThemeNames = ['system', 'light', 'dark'];

function currentTheme() {
  const {theme} = document.documentElement.dataset;
  return kThemes[theme ?? (kDark.matches ? 'dark' : 'light')];
}

// What both maps, the table and the tips know: the pointer and the chosen pit.
class State {
  constructor(view, pits, redraw) {
    this.view = view;
    this.pits = pits;
    this.redraw = redraw;
    this.pointer = null;
    this.chosen = null;
    this.onChoose = () => {};
  }

  setPointer(pointer) {
    this.pointer = pointer;
    this.redraw();
  }

  choose(pit, {fly = false} = {}) {
    this.chosen = pit;
    this.pointer = null;
    this.onChoose(pit);
    if (pit && fly) {
      const close = this.view.fittingScale() * Math.max(4, Math.sqrt(this.pits.spacing ? 1.2 / this.pits.spacing : 1) * 2);
      this.view.flyTo(pit.x, pit.y, Math.max(this.view.scale, close));
    }
    this.redraw();
  }

  // By depth, the deepest first.
  chooseNext(step) {
    const order = this.pits.byDepth;
    if (order.length === 0) return;
    const at = order.indexOf(this.chosen);
    const next = at < 0 ? (step > 0 ? 0 : order.length - 1) : (at + step + order.length) % order.length;
    this.choose(order[next], {fly: true});
  }
}

// Paints both maps when they need it and can be painted in time; else shows the last pictures, moved, and paints once
// the reader pauses.
class Frames {
  constructor() {
    this.maps = [];
    this.cost = 0;  // milliseconds that painting takes
    this.stale = true;
    this.waiting = false;
    this.pause = 0;
  }

  begin(maps, tips) {
    this.maps = maps;
    this.tips = tips;
  }

  repaint() {
    this.stale = true;
    this.request();
  }

  moved() {
    clearTimeout(this.pause);
    if (this.cost < 30 || !this.maps[0]?.painted) return this.repaint();
    this.pause = setTimeout(() => this.repaint(), 110);
    return this.request();
  }

  request() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      if (this.stale) this.paint();
      for (const map of this.maps) map.show();
      this.tips?.update();
    });
  }

  paint() {
    this.stale = false;
    const start = performance.now();
    for (const map of this.maps) map.paint();
    if (this.measuring) return;
    this.measuring = true;
    this.maps[0].shader.whenPainted(() => {
      const took = performance.now() - start;
      this.measuring = false;
      this.cost = this.cost === 0 ? took : 0.5 * (this.cost + took);
    });
  }
}

function makeLayerControls(style, redraw) {
  const fill = element('select', {id: 'fill', onchange: () => {
    style.fill = fill.value;
    redraw();
  }}, ...[['elevation', 'elevation'], ['basins', 'basins'], ['orders', 'order of triangles'], ['none', 'nothing']]
      .map(([value, label]) => element('option', {value}, label)));
  byId('layers').append(
    element('label', {class: 'choice'}, 'Colour by ', fill),
    ...kLayers.map((layer) => {
      const box = element('input', {type: 'checkbox', id: `layer-${layer.name}`, onchange: () => {
        style[layer.name] = box.checked;
        redraw();
      }});
      box.checked = layer.on;
      return element('label', {class: 'choice'}, box, layer.label);
    }));
}

function makeLegend() {
  const entries = [['dot removed', 'pit removed'], ['dot remaining', 'pit remaining'], ['dot boundary', 'boundary pit'],
                   ['stroke old', 'edge given up'], ['stroke fresh', 'new edge'], ['stroke water', 'flow path']];
  byId('legend').append(
    ...entries.map(([name, label]) => element('span', {}, element('i', {class: name}), label)),
    element('span', {class: 'ramp-key'}, 'low', element('i', {class: 'ramp'}), 'high'),
    element('span', {class: 'hint'}, 'Circles are larger the deeper the pit: how far water must rise in it to run off to lower ground. ' +
      'Of very many in sight only the deepest are drawn, and edges only from nearer by.'));
}

function makeTabs(onShow) {
  const tabs = [...document.querySelectorAll('[role=tab]')];
  const show = (tab) => {
    for (const other of tabs) {
      const chosen = other === tab;
      other.setAttribute('aria-selected', String(chosen));
      other.tabIndex = chosen ? 0 : -1;
      byId(other.getAttribute('aria-controls')).hidden = !chosen;
    }
    onShow(tab.id);
  };
  tabs.forEach((tab, i) => {
    tab.addEventListener('click', () => show(tab));
    tab.addEventListener('keydown', (event) => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (!step) return;
      const next = tabs[(i + step + tabs.length) % tabs.length];
      next.focus();
      show(next);
    });
  });
}

function makeThemeButton(onChange) {
  const button = byId('theme');
  let at = 0;
  const show = () => {
    const name = kThemeNames[at];
    if (name === 'system') delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = name;
    button.textContent = {system: 'Colours: system', light: 'Colours: light', dark: 'Colours: dark'}[name];
    onChange();
  };
  button.addEventListener('click', () => {
    at = (at + 1) % kThemeNames.length;
    show();
  });
  kDark.addEventListener('change', onChange);
  show();
}

function showHead(data, terrain) {
  byId('file-name').textContent = baseName(data.file);
  byId('file-facts').textContent = [
    plural(data.vertices, 'vertex', 'vertices'), plural(data.triangles, 'triangle', 'triangles'),
    `order ${data.order}`, data.method ? `method ${data.method}` : 'compared with Delaunay'].join('  \u00b7  ');
  byId('headline').append(...headline(data));
  if (terrain.thinned) {
    byId('thinned').hidden = false;
    byId('thinned').textContent =
        `The maps show ${count(terrain.common + terrain.after)} of ${count(data.triangles)} triangles: all detail around pits and changed edges, ` +
        'thinned out elsewhere. Figures and coordinates are those of the whole terrain; flow paths run straight over what was left out.';
  }
}

async function start() {
  const data = JSON.parse(byId('report-data').textContent);
  const terrain = new Terrain(data, await decodePayload(byId('report-payload').textContent.trim(), data.drawn));
  byId('report-payload').remove();
  const pits = new Pits(data, terrain);
  const view = new View(terrain);
  const style = {fill: 'elevation'};
  for (const layer of kLayers) style[layer.name] = layer.on;

  const frames = new Frames();
  const redraw = () => frames.repaint();
  const state = new State(view, pits, () => frames.request());
  const shader = new Shader(terrain);
  const shared = {terrain, pits, view, shader, style, state, data};
  const maps = ['map-before', 'map-after'].map((id, which) => new MapView(byId(id), which, shared));
  frames.begin(maps, new Tips(maps, shared));
  view.onChange(() => frames.moved());

  showHead(data, terrain);
  document.querySelectorAll('.caption-figure').forEach((span, which) => {
    span.textContent = `${plural(data.pits.total[which], 'pit', 'pits')}, ${plural(data.water.basins[which], 'basin', 'basins')}`;
  });
  makeLayerControls(style, redraw);
  makeLegend();
  showFigures(data);
  const table = new PitTable(pits, state);
  state.onChoose = (pit) => {
    table.mark();
    byId('announce').textContent =
        pit ? `${pitTitle(pit)}, elevation ${exact(pit.realZ)}, depth ${depthInWords(pit)}; ${reasonInWords(pit, data)}` : '';
  };
  const scene = new SceneView(terrain, pits, shader);
  makeThemeButton(() => {
    redraw();
    scene.colour();
  });
  makeTabs((id) => {
    if (id === 'tab-scene') scene.open();
    if (id === 'tab-maps') fitCanvases();
  });
  const fitCanvases = () => {
    if (matchMedia('print').matches) return;  // paper gets what the screen has
    const {clientWidth, clientHeight} = maps[0].canvas.parentElement;
    if (clientWidth > 0) view.resize(clientWidth, clientHeight, Math.min(2, devicePixelRatio));
    scene.resize();
  };
  new ResizeObserver(fitCanvases).observe(maps[0].canvas.parentElement);
  new ResizeObserver(() => scene.resize()).observe(byId('scene').parentElement);
  fitCanvases();
  window.thalwegReport = {theme: currentTheme, data, terrain, pits, view, style, state, maps, scene, table, frames};
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  document.documentElement.dataset.ready = 'true';
}

start().catch((error) => {
  byId('file-facts').textContent = `This report cannot be shown: ${error.message}`;
  console.error(error);
});

// Tips: what is under the pointer, or at the chosen pit, in words.

function reasonInWords(pit, data) {
  if (pit.kind === 'removed') return 'removed: drains over a new edge';
  const need = pit.need === null
      ? (pit.spill === null ? 'nothing is lower' : `it would need an order above ${data.order_searched}`)
      : `it would need order ${pit.need}`;
  switch (pit.reason) {
    case 'unremovable': return `stays: no way out at order ${data.order}; ${need}`;
    case 'conflict': return `stays: its ways out are in conflict with others (order ${pit.need} leads out)`;
    default: return `stays: the method did not open it; ${need}`;
  }
}

function pitTitle(pit) {
  const kind = {removed: 'Pit removed', remaining: 'Pit remaining', boundary: 'Boundary pit'}[pit.shownAs];
  return pit.vertices > 1 ? `${kind} of ${count(pit.vertices)} vertices` : kind;
}

function depthInWords(pit) {
  return Number.isFinite(pit.depth) ? about(pit.depth, 6) : 'the lowest of all';
}

function row(label, value) {
  return element('div', {class: 'tip-row'}, element('span', {}, label), element('b', {}, value));
}

// How far from Delaunay a map is at a vertex.
function orderRow(terrain, map, vertex) {
  return row('its triangles', `order ${terrain.orderAround(map, vertex)} at most`);
}

// A coordinate in full, or what is left of it in a float.
function coordinateRow(label, axis, vertex) {
  return axis.known ? row(label, exact(axis.at(vertex))) : row(`${label}, about`, about(axis.at(vertex), 8));
}

function pitTip(pit, terrain, map) {
  return [
    element('div', {class: `tip-title ${pit.shownAs}`}, pitTitle(pit)),
    row('elevation', exact(pit.realZ)),
    row('depth', depthInWords(pit)),
    row('x', exact(pit.realX)),
    row('y', exact(pit.realY)),
    row('vertex', String(pit.name)),
    orderRow(terrain, map, pit.vertex),
    element('div', {class: 'tip-text'}, reasonInWords(pit, terrain.data)),
  ];
}

function vertexTip(terrain, map, vertex) {
  const [x, y, z] = terrain.axes;
  return [
    element('div', {class: 'tip-title'}, `Vertex ${terrain.names[vertex]}`),
    coordinateRow('elevation', z, vertex),
    coordinateRow('x', x, vertex),
    coordinateRow('y', y, vertex),
    orderRow(terrain, map, vertex),
  ];
}

function placeTip(terrain, map, x, y) {
  const t = terrain.triangleAt(map, x, y);
  if (t < 0) return null;
  const digits = (value) => about(value, 9);
  const standsForOthers = terrain.thinned && t < terrain.common;
  const {a, b, c} = terrain.weights(t, x, y);
  return [
    element('div', {class: 'tip-title'}, `Triangle of order ${terrain.order(t)}${standsForOthers ? ', or thinned out' : ''}`),
    row('elevation', about(terrain.elevationAt(t, x, y), 6)),
    row('x', digits(terrain.realX(x))),
    row('y', digits(terrain.realY(y))),
    row('vertices', [a, b, c].map((v) => terrain.names[v]).join(', ')),
  ];
}

const kVertexReach = 5;  // pixels

class Tips {
  constructor(maps, shared) {
    Object.assign(this, shared);
    this.maps = maps;
  }

  // The chosen pit has a tip in both maps unless the pointer is about.
  update() {
    const {state, view, terrain} = this;
    for (const map of this.maps) {
      const {pointer, chosen} = state;
      if (pointer && pointer.map === map.which) {
        this.show(map, this.under(map.which, pointer.px, pointer.py), pointer.px, pointer.py);
      } else if (chosen && !pointer) {
        const [px, py] = view.toScreen(chosen.x, chosen.y);
        const inside = px >= 0 && py >= 0 && px <= view.width && py <= view.height;
        this.show(map, inside ? pitTip(chosen, terrain, map.which) : null, px, py);
      } else {
        this.show(map, null, 0, 0);
      }
    }
  }

  // A pit, else a vertex, else a place in a triangle.
  under(map, px, py) {
    const {view, pits, style, terrain} = this;
    const pit = pits.near(view, px, py, style);
    if (pit) return pitTip(pit, terrain, map);
    const [x, y] = view.fromScreen(px, py);
    const vertex = terrain.vertexNear(map, x, y, kVertexReach / view.scale);
    return vertex >= 0 ? vertexTip(terrain, map, vertex) : placeTip(terrain, map, x, y);
  }

  // For those who cannot see the tip; only what is new is read out.
  announce(tip) {
    const text = [...tip.children].map((line) => [...line.childNodes].map((part) => part.textContent).join(' ')).join(', ');
    if (byId('announce').textContent !== text) byId('announce').textContent = text;
  }

  show(map, content, px, py) {
    const {tip} = map;
    tip.hidden = content === null;
    if (content === null) return;
    tip.replaceChildren(...content);
    if (this.state.pointer?.middle) this.announce(tip);
    const right = px + 18 + tip.offsetWidth > this.view.width;
    const low = py + 18 + tip.offsetHeight > this.view.height;
    const left = right ? Math.max(4, px - 18 - tip.offsetWidth) : px + 18;
    const top = low ? Math.max(4, py - 18 - tip.offsetHeight) : py + 18;
    tip.style.transform = `translate(${left}px, ${top}px)`;
  }
}

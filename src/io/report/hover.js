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

function pitTip(pit, data) {
  return [
    element('div', {class: `tip-title ${pit.shownAs}`}, pitTitle(pit)),
    row('elevation', exact(pit.realZ)),
    row('depth', depthInWords(pit)),
    row('x', exact(pit.realX)),
    row('y', exact(pit.realY)),
    row('vertex', String(pit.name)),
    element('div', {class: 'tip-text'}, reasonInWords(pit, data)),
  ];
}

function placeTip(terrain, map, x, y) {
  const t = terrain.triangleAt(map, x, y);
  if (t < 0) return null;
  const digits = (value) => about(value, 9);
  const {a, b, c} = terrain.weights(t, x, y);
  return [
    element('div', {class: 'tip-title'}, `Triangle of order ${terrain.order(t)}`),
    row('elevation', about(terrain.elevationAt(t, x, y), 6)),
    row('x', digits(terrain.realX(x))),
    row('y', digits(terrain.realY(y))),
    row('vertices', [a, b, c].map((v) => terrain.names[v]).join(', ')),
  ];
}

class Tips {
  constructor(maps, shared) {
    Object.assign(this, shared);
    this.maps = maps;
  }

  // The chosen pit has a tip in both maps unless the pointer is about.
  update() {
    const {state, view, pits, style, terrain} = this;
    for (const map of this.maps) {
      const {pointer, chosen} = state;
      if (pointer && pointer.map === map.which) {
        const pit = pits.near(view, pointer.px, pointer.py, style);
        const content = pit ? pitTip(pit, this.data) : placeTip(terrain, map.which, ...view.fromScreen(pointer.px, pointer.py));
        this.show(map, content, pointer.px, pointer.py);
      } else if (chosen && !pointer) {
        const [px, py] = view.toScreen(chosen.x, chosen.y);
        const inside = px >= 0 && py >= 0 && px <= view.width && py <= view.height;
        this.show(map, inside ? pitTip(chosen, this.data) : null, px, py);
      } else {
        this.show(map, null, 0, 0);
      }
    }
  }

  show(map, content, px, py) {
    const {tip} = map;
    tip.hidden = content === null;
    if (content === null) return;
    tip.replaceChildren(...content);
    const right = px + 18 + tip.offsetWidth > this.view.width;
    const low = py + 18 + tip.offsetHeight > this.view.height;
    const left = right ? Math.max(4, px - 18 - tip.offsetWidth) : px + 18;
    const top = low ? Math.max(4, py - 18 - tip.offsetHeight) : py + 18;
    tip.style.transform = `translate(${left}px, ${top}px)`;
  }
}

// What is drawn over the triangles: edges, changes, water, pits, scale bar.

const kLayers = [
  {name: 'shading', label: 'Relief', on: true},
  {name: 'edges', label: 'Edges', on: true},
  {name: 'changes', label: 'Changed edges', on: true},
  {name: 'flow', label: 'Flow paths', on: false},
  {name: 'removed', label: 'Pits removed', on: true},
  {name: 'remaining', label: 'Pits remaining', on: true},
  {name: 'boundary', label: 'Boundary pits', on: true},
];

const kMostEdges = 24000;  // triangles in sight beyond which edges would be a grey veil
const kMostFlow = 9000;
const kMostPits = 2500;
const kMostChanges = 12000;

class Overlay {
  constructor(terrain, pits, map) {
    this.terrain = terrain;
    this.pits = pits;
    this.map = map;
    const next = terrain.downstream[map];
    this.longest = [];
    for (let v = terrain.data.water.from[map]; v !== kNoVertex && v !== undefined; v = next[v]) this.longest.push(v);
  }

  // Vertices that water flows through on its way, the largest streams first.
  get rivers() {
    if (!this.madeRivers) {
      const amount = this.terrain.accumulated[this.map];
      const next = this.terrain.downstream[this.map];
      this.madeRivers = Uint32Array.from(next.keys()).filter((v) => next[v] !== kNoVertex && amount[v] > 1);
      this.madeRivers.sort((u, v) => amount[v] - amount[u]);
    }
    return this.madeRivers;
  }

  draw(context, view, style, theme) {
    context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
    context.lineCap = 'round';
    context.lineJoin = 'round';
    if (style.edges) this.drawEdges(context, view, theme);
    if (style.flow) this.drawFlow(context, view, theme);
    if (style.changes) this.drawChanges(context, view, theme);
    this.drawPits(context, view, style, theme);
  }

  drawEdges(context, view, theme) {
    const {terrain} = this;
    const box = view.box();
    if (view.scale * view.scale < 20 * terrain.triangles / 4 || terrain.grid.amount(box) > 3 * kMostEdges) return;
    context.beginPath();
    terrain.grid.forEach(box, (t) => {
      if (!terrain.shows(this.map, t)) return;
      for (let i = 0; i < 3; ++i) {
        const u = terrain.corners[3 * t + i], v = terrain.corners[3 * t + ((i + 1) % 3)];
        if (u < v) this.line(context, view, u, v);
      }
    });
    context.lineWidth = 0.6;
    context.strokeStyle = theme.edge;
    context.stroke();
  }

  line(context, view, u, v) {
    const {x, y} = this.terrain;
    context.moveTo(...view.toScreen(x[u], y[u]));
    context.lineTo(...view.toScreen(x[v], y[v]));
  }

  inSight(box, u, v) {
    const {x, y} = this.terrain;
    return Math.max(x[u], x[v]) >= box.left && Math.min(x[u], x[v]) <= box.right && Math.max(y[u], y[v]) >= box.bottom &&
           Math.min(y[u], y[v]) <= box.top;
  }

  // Before, edges that will go are dashed; after, they are still shown so, beside those that came instead.
  drawChanges(context, view, theme) {
    const {oldEdges, newEdges} = this.terrain;
    const box = view.box();
    const thin = view.scale / Math.sqrt(this.terrain.vertices) < 4;
    const draw = (edges, width, colour, dash) => {
      const shown = [];
      for (let i = 0; i < edges.length; i += 2) if (this.inSight(box, edges[i], edges[i + 1])) shown.push(i);
      if (shown.length > kMostChanges) return;
      context.beginPath();
      for (const i of shown) this.line(context, view, edges[i], edges[i + 1]);
      context.lineWidth = thin ? 0.6 * width : width;
      context.strokeStyle = colour;
      context.setLineDash(thin ? [] : dash);
      context.stroke();
      context.setLineDash([]);
    };
    draw(oldEdges, this.map === 0 ? 1.5 : 1.1, theme.old, [4, 4]);
    if (this.map === 1) draw(newEdges, 2, theme.fresh, []);
  }

  // The largest in sight, the wider the more vertices drain through them; and the longest path.
  drawFlow(context, view, theme) {
    const {terrain, map} = this;
    const amount = terrain.accumulated[map], next = terrain.downstream[map];
    const box = view.box();
    const classes = new Map();
    let drawn = 0;
    for (let i = 0; i < this.rivers.length && drawn < kMostFlow; ++i) {
      const v = this.rivers[i];
      if (!this.inSight(box, v, next[v])) continue;
      const width = Math.min(12, Math.floor(2 * Math.log2(amount[v])));
      if (!classes.has(width)) classes.set(width, []);
      classes.get(width).push(v);
      ++drawn;
    }
    const slim = Math.min(1, Math.max(0.35, (view.scale / Math.sqrt(terrain.vertices)) / 5));
    context.strokeStyle = theme.water;
    for (const [width, vertices] of classes) {
      context.beginPath();
      for (const v of vertices) this.line(context, view, v, next[v]);
      context.lineWidth = slim * (0.5 + 0.26 * width);
      context.stroke();
    }
    context.beginPath();
    for (const v of this.longest) context.lineTo(...view.toScreen(terrain.x[v], terrain.y[v]));
    context.lineWidth = 5;
    context.strokeStyle = theme.halo;
    context.stroke();
    context.lineWidth = 2.5;
    context.strokeStyle = theme.water;
    context.stroke();
  }

  drawPits(context, view, style, theme) {
    const shown = this.pits.inSight(view, style);
    for (const kind of ['removed', 'boundary', 'remaining']) {
      if (!style[kind]) continue;
      const hollow = kind === 'removed' && this.map === 1;
      context.beginPath();
      for (const pit of shown) {
        if (pit.shownAs !== kind) continue;
        const [px, py] = view.toScreen(pit.x, pit.y);
        const radius = this.pits.radius(view, pit.part);
        context.moveTo(px + radius, py);
        context.arc(px, py, radius, 0, 2 * Math.PI);
      }
      context.lineWidth = hollow ? 3.4 : 2.4;
      context.strokeStyle = theme.halo;
      context.stroke();
      context.fillStyle = hollow ? theme.ring : theme[kind];
      context.fill();
      context.lineWidth = hollow ? 1.8 : 0.6;
      context.strokeStyle = theme[kind];
      context.stroke();
    }
  }

  drawScaleBar(context, view, theme) {
    const units = this.terrain.units / view.scale;
    if (!Number.isFinite(units * view.width) || !(units > 0)) return;
    const most = units * Math.min(180, view.width / 3);
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map((factor) => factor * power).find((value) => value <= most) ?? power;
    const drawn = length / units;
    const left = 14, bottom = view.height - 14;
    const path = () => {
      context.beginPath();
      context.moveTo(left, bottom - 6);
      context.lineTo(left, bottom);
      context.lineTo(left + drawn, bottom);
      context.lineTo(left + drawn, bottom - 6);
    };
    path();
    context.lineWidth = 4;
    context.strokeStyle = theme.halo;
    context.stroke();
    path();
    context.lineWidth = 1.5;
    context.strokeStyle = theme.text;
    context.stroke();
    context.font = '12px ' + kFont;
    context.textAlign = 'left';
    context.lineWidth = 4;
    context.strokeStyle = theme.halo;
    context.strokeText(about(length, 3), left + 4, bottom - 9);
    context.fillStyle = theme.text;
    context.fillText(about(length, 3), left + 4, bottom - 9);
  }
}

const kFont = 'ui-sans-serif, system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif';

// The pits of both maps, with what is known of each.
class Pits {
  constructor(data, terrain) {
    this.list = [];
    for (const kind of ['removed', 'remaining']) {
      const columns = data[kind];
      for (let i = 0; i < columns.vertex.length; ++i) {
        const vertex = columns.vertex[i];
        const level = terrain.level[vertex];
        const top = columns.spill[i] === null ? Infinity
            : terrain.range > 0 ? ((columns.spill[i] - data.drawn.z.origin) / data.drawn.z.unit - terrain.low) / terrain.range
            : 0.5;
        this.list.push({
          kind,
          vertex,
          name: terrain.names[vertex],
          x: terrain.x[vertex],
          y: terrain.y[vertex],
          realX: columns.x[i],
          realY: columns.y[i],
          realZ: columns.z[i],
          spill: columns.spill[i],
          depth: columns.spill[i] === null ? Infinity : columns.spill[i] - columns.z[i],
          levels: Math.max(0, top - level),
          boundary: columns.boundary[i],
          vertices: columns.vertices[i],
          reason: columns.reason[i],
          need: columns.need[i],
          shownAs: kind === 'removed' ? 'removed' : columns.boundary[i] ? 'boundary' : 'remaining',
        });
      }
    }
    const deepest = this.list.reduce((most, pit) => (Number.isFinite(pit.levels) ? Math.max(most, pit.levels) : most), 0);
    for (const pit of this.list) {
      pit.part = !Number.isFinite(pit.levels) ? 1 : deepest > 0 ? Math.min(1, pit.levels / deepest) : 0;
    }
    this.spacing = 2 / Math.sqrt(Math.max(1, this.list.length));
    this.byDepth = [...this.list].sort((p, q) => q.part - p.part || p.name - q.name);
  }

  // Those that a map shows: in sight, and of a layer that is on; the deepest, if there are too many to be told apart.
  inSight(view, style) {
    const box = view.box();
    const reach = 12 / view.scale;
    const shown = [];
    for (const pit of this.byDepth) {
      if (!style[pit.shownAs] || pit.x < box.left - reach || pit.x > box.right + reach) continue;
      if (pit.y < box.bottom - reach || pit.y > box.top + reach) continue;
      if (shown.push(pit) === kMostPits) break;
    }
    this.crowded = shown.length === kMostPits;
    return shown;
  }

  // In pixels: areas grow with depth, and all shrink where there are many.
  radius(view, part) {
    const room = Math.max(this.spacing, 2 / Math.sqrt(kMostPits)) * view.scale;
    const most = Math.min(11, Math.max(2, 0.22 * room)), least = Math.min(4, Math.max(0.9, 0.07 * room));
    return least + (most - least) * Math.sqrt(part);
  }

  // The pit nearest to a place of the screen among those shown; undefined if none is near.
  near(view, px, py, style) {
    let best;
    let nearest = Infinity;
    for (const pit of this.inSight(view, style)) {
      const [x, y] = view.toScreen(pit.x, pit.y);
      const distance = Math.hypot(x - px, y - py) - this.radius(view, pit.part);
      if (distance >= nearest || distance > 5) continue;
      nearest = distance;
      best = pit;
    }
    return best;
  }
}

// The terrain in the page's own units: x and y in [-1, 1] (the longer side spans it all), level in [0, 1].
// Everything here is for looking at; what was decided was decided exactly, before.

class Terrain {
  constructor(data, payload) {
    this.data = data;
    this.names = payload.names;
    this.axes = payload.axes;
    this.downstream = payload.downstream;
    this.afterOrder = payload.afterOrder;
    this.common = data.drawn.common;
    this.before = data.drawn.before;
    this.after = data.drawn.after;
    this.corners = new Uint32Array(payload.common.length + payload.before.length + payload.after.length);
    this.corners.set(payload.common, 0);
    this.corners.set(payload.before, payload.common.length);
    this.corners.set(payload.after, payload.common.length + payload.before.length);
    this.setPlaces(payload);
    this.findChanges();
    this.shade = new Uint8Array(this.triangles);
    this.shadeTriangles();
  }

  get vertices() {
    return this.x.length;
  }

  get triangles() {
    return this.corners.length / 3;
  }

  // How much flows through each vertex, and where its water ends, in both maps; worked out when first asked for.
  get accumulated() {
    return (this.madeAccumulated ??= this.downstream.map(accumulate));
  }
  get sinks() {
    return (this.madeSinks ??= this.downstream.map(findSinks));
  }

  // Whether triangle t belongs to map 0 (before) or 1 (after).
  shows(map, t) {
    return t < this.common || (t < this.common + this.before) === (map === 0);
  }

  // Whether triangles have been left out of the page; others then stand for them.
  get thinned() {
    return this.common + this.after < this.data.triangles;
  }

  order(t) {
    const changed = t - this.common - this.before;
    return changed >= 0 ? this.afterOrder[changed] : 0;
  }

  // Frames may have different units; both axes are brought to the larger one.
  setPlaces(payload) {
    const frame = this.data.drawn;
    const unit = Math.max(frame.x.unit, frame.y.unit);
    const stretch = [frame.x.unit / unit, frame.y.unit / unit];
    let half = 0;
    for (const [axis, values] of [payload.x, payload.y].entries()) {
      for (let i = 0; i < values.length; ++i) half = Math.max(half, Math.abs(values[i] * stretch[axis]));
    }
    if (!(half > 0)) half = 1;
    this.unit = unit;
    this.half = half;
    this.x = payload.x.map((value) => (value * stretch[0]) / half);
    this.y = payload.y.map((value) => (value * stretch[1]) / half);
    let low = Infinity;
    let high = -Infinity;
    for (let i = 0; i < payload.z.length; ++i) {
      low = Math.min(low, payload.z[i]);
      high = Math.max(high, payload.z[i]);
    }
    this.low = low;
    this.range = high - low;
    this.level = payload.z.map((value) => (this.range > 0 ? (value - low) / this.range : 0.5));
    this.box = {left: Math.min(...extremes(this.x)), right: Math.max(...extremes(this.x)),
                bottom: Math.min(...extremes(this.y)), top: Math.max(...extremes(this.y))};
  }

  realX(x) {
    return this.data.drawn.x.origin + x * this.half * this.unit;
  }
  realY(y) {
    return this.data.drawn.y.origin + y * this.half * this.unit;
  }
  realZ(level) {
    const {origin, unit} = this.data.drawn.z;
    return origin + (this.low + level * this.range) * unit;
  }

  // What a length of 1 is in the coordinates of the file; infinite beyond all numbers.
  get units() {
    return this.half * this.unit;
  }

  // Light from the north-west, 45 degrees high. The terrain is raised until typical slopes are well seen.
  shadeTriangles() {
    const total = this.triangles;
    const slope = new Float32Array(2 * total);
    const sizes = [];
    for (let t = 0; t < total; ++t) {
      const [a, b, c] = this.corners.subarray(3 * t, 3 * t + 3);
      const bx = this.x[b] - this.x[a], by = this.y[b] - this.y[a], bz = this.level[b] - this.level[a];
      const cx = this.x[c] - this.x[a], cy = this.y[c] - this.y[a], cz = this.level[c] - this.level[a];
      const area = bx * cy - by * cx;
      const gx = area > 0 ? (bz * cy - cz * by) / area : 0;
      const gy = area > 0 ? (cz * bx - bz * cx) / area : 0;
      slope[2 * t] = gx;
      slope[2 * t + 1] = gy;
      if (t % Math.ceil(total / 4000) === 0) sizes.push(Math.hypot(gx, gy));
    }
    sizes.sort((p, q) => p - q);
    const typical = sizes[Math.floor(0.75 * sizes.length)] || 0;
    const raise = typical > 0 ? 0.55 / typical : 0;
    this.raise = raise;
    for (let t = 0; t < total; ++t) {
      const gx = slope[2 * t] * raise, gy = slope[2 * t + 1] * raise;
      const light = (0.5 * gx - 0.5 * gy + Math.SQRT1_2) / Math.sqrt(1 + gx * gx + gy * gy);
      this.shade[t] = Math.round(255 * Math.min(1, Math.max(0, light)));
    }
  }

  // Edges of one map alone: pairs of vertices, before those that have gone, after those that came.
  findChanges() {
    const edgesOf = (from, length) => {
      const edges = new Map();
      for (let t = from; t < from + length; ++t) {
        for (let i = 0; i < 3; ++i) {
          const u = this.corners[3 * t + i], v = this.corners[3 * t + ((i + 1) % 3)];
          const edge = u < v ? [u, v] : [v, u];
          edges.set(edge[0] * this.vertices + edge[1], edge);
        }
      }
      return edges;
    };
    const old = edgesOf(this.common, this.before);
    const now = edgesOf(this.common + this.before, this.after);
    const missing = (edges, others) =>
        Uint32Array.from([...edges].filter(([key]) => !others.has(key)).flatMap(([, edge]) => edge));
    this.oldEdges = missing(old, now);
    this.newEdges = missing(now, old);
  }

  // Triangles by the cells of a square grid that their boxes meet.
  get grid() {
    return (this.madeGrid ??= new TriangleGrid(this));
  }

  // The triangle of a map at a place; -1 if there is none.
  triangleAt(map, x, y) {
    return this.grid.find(x, y, (t) => this.shows(map, t) && this.contains(t, x, y));
  }

  contains(t, x, y) {
    const {left} = this.weights(t, x, y);
    return left;
  }

  // Barycentric weights of a place, and whether it is in the triangle.
  weights(t, x, y) {
    const a = this.corners[3 * t], b = this.corners[3 * t + 1], c = this.corners[3 * t + 2];
    const area = turn(this, a, b, this.x[c], this.y[c]);
    const wc = turn(this, a, b, x, y) / area;
    const wa = turn(this, b, c, x, y) / area;
    const wb = 1 - wa - wc;
    return {a, b, c, wa, wb, wc, left: wa >= -1e-9 && wb >= -1e-9 && wc >= -1e-9};
  }

  // The vertex of a map nearest to a place, at most so far away; -1 if there is none.
  vertexNear(map, x, y, reach) {
    let best = -1;
    let nearest = reach;
    this.grid.forEach({left: x - reach, right: x + reach, bottom: y - reach, top: y + reach}, (t) => {
      if (!this.shows(map, t)) return;
      for (const v of this.corners.subarray(3 * t, 3 * t + 3)) {
        const distance = Math.hypot(this.x[v] - x, this.y[v] - y);
        if (distance > nearest || (distance === nearest && best >= 0 && best <= v)) continue;
        nearest = distance;
        best = v;
      }
    });
    return best;
  }

  // The largest order of the triangles of a map that meet at a vertex.
  orderAround(map, vertex) {
    let most = 0;
    const place = {left: this.x[vertex], right: this.x[vertex], bottom: this.y[vertex], top: this.y[vertex]};
    this.grid.forEach(place, (t) => {
      if (this.shows(map, t) && this.corners.subarray(3 * t, 3 * t + 3).includes(vertex)) most = Math.max(most, this.order(t));
    });
    return most;
  }

  elevationAt(t, x, y) {
    const {a, b, c, wa, wb, wc} = this.weights(t, x, y);
    return this.realZ(wa * this.level[a] + wb * this.level[b] + wc * this.level[c]);
  }
}

function turn(terrain, u, v, x, y) {
  const {x: xs, y: ys} = terrain;
  return (xs[v] - xs[u]) * (y - ys[u]) - (ys[v] - ys[u]) * (x - xs[u]);
}

function extremes(values) {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    low = Math.min(low, values[i]);
    high = Math.max(high, values[i]);
  }
  return [low, high];
}

// How many vertices drain through each, itself included.
function accumulate(next) {
  const waiting = new Uint32Array(next.length);
  const amount = new Uint32Array(next.length).fill(1);
  for (const to of next) if (to !== kNoVertex) ++waiting[to];
  const ready = [];
  for (let v = 0; v < next.length; ++v) if (waiting[v] === 0) ready.push(v);
  for (let head = 0; head < ready.length; ++head) {
    const to = next[ready[head]];
    if (to === kNoVertex) continue;
    amount[to] += amount[ready[head]];
    if (--waiting[to] === 0) ready.push(to);
  }
  return amount;
}

// Where each path ends.
function findSinks(next) {
  const sink = new Uint32Array(next.length).fill(kNoVertex);
  const path = [];
  for (let start = 0; start < next.length; ++start) {
    let v = start;
    while (sink[v] === kNoVertex && next[v] !== kNoVertex) {
      path.push(v);
      v = next[v];
    }
    const end = sink[v] === kNoVertex ? v : sink[v];
    sink[v] = end;
    while (path.length > 0) sink[path.pop()] = end;
  }
  return sink;
}

class TriangleGrid {
  constructor(terrain) {
    this.side = Math.max(1, Math.min(1024, Math.ceil(Math.sqrt(terrain.triangles / 2))));
    const {side} = this;
    const {corners, x, y} = terrain;
    const starts = new Uint32Array(side * side + 1);
    const each = (visit) => {
      for (let t = 0; t < terrain.triangles; ++t) {
        const a = corners[3 * t], b = corners[3 * t + 1], c = corners[3 * t + 2];
        const left = this.cell(Math.min(x[a], x[b], x[c])), right = this.cell(Math.max(x[a], x[b], x[c]));
        const low = this.cell(Math.min(y[a], y[b], y[c])), high = this.cell(Math.max(y[a], y[b], y[c]));
        for (let j = low; j <= high; ++j) for (let i = left; i <= right; ++i) visit(j * side + i, t);
      }
    };
    each((cell) => ++starts[cell + 1]);
    for (let i = 1; i < starts.length; ++i) starts[i] += starts[i - 1];
    const next = starts.slice();
    this.items = new Uint32Array(starts[starts.length - 1]);
    each((cell, t) => { this.items[next[cell]++] = t; });
    this.starts = starts;
  }

  cell(value) {
    return Math.max(0, Math.min(this.side - 1, Math.floor(((value + 1) / 2) * this.side)));
  }

  find(x, y, accept) {
    if (Math.abs(x) > 1 || Math.abs(y) > 1) return -1;
    const cell = this.cell(y) * this.side + this.cell(x);
    for (let i = this.starts[cell]; i < this.starts[cell + 1]; ++i) {
      if (accept(this.items[i])) return this.items[i];
    }
    return -1;
  }

  // How many entries lie in a box, at most; each triangle may count several times.
  amount(box) {
    let sum = 0;
    for (let j = this.cell(box.bottom); j <= this.cell(box.top); ++j) {
      const row = j * this.side;
      sum += this.starts[row + this.cell(box.right) + 1] - this.starts[row + this.cell(box.left)];
    }
    return sum;
  }

  // Every triangle that may be in the box, once.
  forEach(box, visit) {
    const seen = new Set();
    for (let j = this.cell(box.bottom); j <= this.cell(box.top); ++j) {
      const row = j * this.side;
      for (let i = this.starts[row + this.cell(box.left)]; i < this.starts[row + this.cell(box.right) + 1]; ++i) {
        const t = this.items[i];
        if (seen.has(t)) continue;
        seen.add(t);
        visit(t);
      }
    }
  }
}

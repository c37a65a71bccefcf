// Colours of both themes. Elevation runs from dark to light, so that it reads in grey as well; blue, vermilion and
// black (white in the dark) are told apart by every kind of colour vision, and so is the purple of new edges.

const kThemes = {
  light: {
    ramp: ['#7ba39c', '#a3bfa6', '#cdd2b2', '#e8dcbc', '#f1e8d8', '#fbf9f5'],
    basins: ['#88b7c9', '#e2c48d', '#a7c29a', '#d9a99a', '#b3aed0', '#cfd39a', '#8fc2b4', '#d4b4c4', '#c7b79c',
             '#9fb3d6', '#e0d3b0', '#b8cfd2'],
    orders: ['#f3f1ec', '#fbd7a0', '#f0a860', '#d9713c', '#a8452f', '#6b2a2a'],
    shadow: 0.52, light: 1.12,
    paper: '#ffffff', edge: 'rgba(70, 62, 50, 0.32)', old: '#4a4a4a', fresh: '#9b2d86',
    removed: '#0072b2', remaining: '#d55e00', boundary: '#1d1d1d', halo: 'rgba(255, 255, 255, 0.9)',
    ring: 'rgba(255, 255, 255, 0.55)', water: '#2e86c1', text: '#26241f', marker: '#111111',
  },
  dark: {
    ramp: ['#1d3b40', '#2f5652', '#55725f', '#8b8863', '#b99f77', '#e6dac2'],
    basins: ['#3f7387', '#8f7742', '#587a4c', '#8a5a4e', '#66618c', '#7d8148', '#43786a', '#83606f', '#776a52',
             '#4f648c', '#8b8263', '#5f7e84'],
    orders: ['#2a2c2e', '#6b4a1c', '#a2671f', '#d18a3c', '#efb77a', '#fde6c8'],
    shadow: 0.42, light: 1.18,
    paper: '#15181a', edge: 'rgba(235, 228, 214, 0.2)', old: '#c9c4ba', fresh: '#f49ac8',
    removed: '#5fb4ee', remaining: '#ff8a3d', boundary: '#f2f2f2', halo: 'rgba(10, 12, 14, 0.85)',
    ring: 'rgba(10, 14, 18, 0.5)', water: '#58b7e8', text: '#e9e5dc', marker: '#ffffff',
  },
};

function rgb(hex) {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}

// Basins get numbers of colours such that neighbours differ; what is the same basin in both maps has one colour.
function colourBasins(terrain) {
  const colours = new Map();
  const neighbours = new Map();
  const meet = (u, v) => {
    if (u === v) return;
    if (!neighbours.has(u)) neighbours.set(u, new Set());
    if (!neighbours.has(v)) neighbours.set(v, new Set());
    neighbours.get(u).add(v);
    neighbours.get(v).add(u);
  };
  for (let t = 0; t < terrain.triangles; ++t) {
    for (let map = 0; map < 2; ++map) {
      if (!terrain.shows(map, t)) continue;
      const [a, b, c] = terrain.corners.subarray(3 * t, 3 * t + 3);
      const sink = terrain.sinks[map];
      if (sink[a] === sink[b] && sink[b] === sink[c]) continue;
      meet(sink[a], sink[b]);
      meet(sink[b], sink[c]);
      meet(sink[c], sink[a]);
    }
  }
  const palette = kThemes.light.basins.length;
  const choose = (v) => {
    if (colours.has(v)) return;
    const taken = new Set();
    for (const w of neighbours.get(v) ?? []) if (colours.has(w)) taken.add(colours.get(w));
    const wanted = (v * 7) % palette;
    for (let i = 0; i < palette; ++i) {
      const colour = (wanted + i * 5) % palette;
      if (taken.has(colour)) continue;
      colours.set(v, colour);
      return;
    }
    colours.set(v, wanted);
  };
  for (const map of [1, 0]) {
    for (let v = 0; v < terrain.vertices; ++v) if (terrain.sinks[map][v] === v) choose(v);
  }
  return colours;
}

// For each triangle the colour of the basin of its lowest corner, in one map.
function basinOfTriangles(terrain, map, colours) {
  const sink = terrain.sinks[map];
  const result = new Uint8Array(terrain.triangles);
  for (let t = 0; t < terrain.triangles; ++t) {
    let lowest = terrain.corners[3 * t];
    for (let i = 1; i < 3; ++i) {
      const v = terrain.corners[3 * t + i];
      if (terrain.level[v] < terrain.level[lowest]) lowest = v;
    }
    result[t] = colours.get(sink[lowest]) ?? 0;
  }
  return result;
}

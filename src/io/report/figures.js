// Headline figures, and the figures of the second tab.

function card(title, main, ...notes) {
  return element('div', {class: 'card'}, element('h2', {}, title), element('p', {class: 'card-main'}, ...main),
                 ...notes.filter((note) => note !== null).map((note) => element('p', {class: 'card-note'}, note)));
}

function fromTo(before, after) {
  return [element('span', {class: 'was'}, before), element('span', {class: 'arrow', 'aria-label': 'to'}, '\u2192'),
          element('span', {}, after)];
}

function hashCard(data) {
  const short = (hash) => `${hash.slice(0, 10)}\u2026`;
  const same = data.hash_in !== '' && data.hash_in === data.hash_out;
  if (data.hash_in === '') {
    return card('Elevations', [count(data.vertices)], `sites ${short(data.hash_out)}`,
                'made from a mesh: no points to compare with');
  }
  const main = same ? [element('span', {class: 'check'}, '\u2713'), ' unchanged'] : ['changed'];
  const merged = data.merged > 0 ? `${plural(data.merged, 'row', 'rows')} merged into others at the same place` : null;
  const made = card(same ? 'All elevations' : 'Elevations', main,
                    `sites in ${short(data.hash_in)}`, `sites out ${short(data.hash_out)}`, merged);
  made.title = `SHA-256 of the sites in: ${data.hash_in}, out: ${data.hash_out}`;
  return made;
}

function headline(data) {
  const {pits, water} = data;
  const [before, after] = pits.total;
  const proof = data.certified ? [element('span', {class: 'check'}, '\u2713'), ` ${count(data.lower_bound)}`] : [count(data.lower_bound)];
  return [
    card('Pits', fromTo(count(before), count(after)), `${count(before - after)} fewer (${percent(before - after, before)})`,
         `interior ${count(pits.interior[0])} \u2192 ${count(pits.interior[1])}, boundary ${count(pits.boundary[0])} \u2192 ${count(pits.boundary[1])}`),
    card('Lower bound', proof,
         data.certified ? `certified: no triangulation of order ${data.order} has fewer` : 'not proved to be reached',
         data.certified ? null : `${count(after - data.lower_bound)} above the bound`),
    hashCard(data),
    card('Edges changed', [count(data.edges_changed)], `${count(data.non_delaunay_edges)} not locally Delaunay`),
    card('Largest order', [count(data.order_histogram.length - 1)], `of a triangle; allowed: ${data.order}`),
    card('Basins', fromTo(count(water.basins[0]), count(water.basins[1])), 'one for each pit'),
    card('Longest flow path', fromTo(about(water.length[0]), about(water.length[1])),
         `${plural(water.edges[0], 'edge', 'edges')} \u2192 ${plural(water.edges[1], 'edge', 'edges')}`),
  ];
}

const kSvg = 'http://www.w3.org/2000/svg';

function svg(name, attributes, ...children) {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// A number not below value, for the top of an axis with four steps.
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(1, value)));
  return [1, 1.2, 1.6, 2, 2.4, 3.2, 4, 6, 8, 10].map((f) => f * power).find((limit) => limit >= value) ?? value;
}

// Groups of bars over labels; series: [{name, className, values}].
function barChart(labels, series, axis) {
  const width = 760, height = 300, left = 56, bottom = 40, top = 12;
  const most = roundUp(Math.max(1, ...series.flatMap((s) => s.values)));
  const group = (width - left) / labels.length;
  const bar = Math.min(26, (0.74 * group) / series.length);
  const y = (value) => height - bottom - (value / most) * (height - bottom - top);
  const chart = svg('svg', {viewBox: `0 0 ${width} ${height}`, class: 'chart', role: 'img', 'aria-label': axis.title});
  for (let i = 0; i <= 4; ++i) {
    const value = (most * i) / 4;
    chart.append(svg('line', {x1: left, x2: width, y1: y(value), y2: y(value), class: 'gridline'}),
                 svg('text', {x: left - 8, y: y(value) + 4, 'text-anchor': 'end'}, about(value, 3)));
  }
  labels.forEach((label, i) => {
    const start = left + i * group + (group - bar * series.length) / 2;
    series.forEach((s, j) => {
      const rect = svg('rect', {x: start + j * bar, y: y(s.values[i]), width: bar - 1.5, height: y(0) - y(s.values[i]), class: s.className, rx: 1});
      rect.append(svg('title', {}, `${axis.label} ${label}: ${s.name} ${count(s.values[i])}`));
      chart.append(rect);
    });
    chart.append(svg('text', {x: left + (i + 0.5) * group, y: height - bottom + 18, 'text-anchor': 'middle'}, String(label)));
  });
  chart.append(svg('text', {x: left + (width - left) / 2, y: height - 4, 'text-anchor': 'middle', class: 'axis'}, axis.label));
  return chart;
}

function key(series) {
  return element('p', {class: 'key'}, ...series.map((s) =>
    element('span', {}, element('i', {class: s.className}), s.name)));
}

function sweepFigure(sweep) {
  const series = ['flip', 'hull', 'best'].map((name) => ({name, className: `bar-${name}`, values: sweep[name]}));
  const proved = sweep.certified.every((c) => c) ? 'Every number of best is certified: no triangulation of that order has fewer.'
      : `Certified at orders ${sweep.order.filter((_, i) => sweep.certified[i]).join(', ') || 'none'}.`;
  const table = element('table', {class: 'small'},
    element('thead', {}, element('tr', {}, ...['order', 'flip', 'hull', 'best', 'bound'].map((h) => element('th', {scope: 'col'}, h)))),
    element('tbody', {}, ...sweep.order.map((k, i) => element('tr', {},
      ...[k, sweep.flip[i], sweep.hull[i], sweep.best[i], sweep.bound[i]].map((value) => element('td', {}, count(value)))))));
  return element('section', {class: 'figure', id: 'sweep'}, element('h2', {}, 'Pits left at each order'), key(series),
                 barChart(sweep.order, series, {title: 'Pits left at each order by each method', label: 'order'}),
                 element('p', {class: 'note'}, proved), table);
}

function ordersFigure(data) {
  const last = Math.min(data.order_histogram.length, 24);
  const series = [{name: 'triangles', className: 'bar-best', values: data.order_histogram.slice(1, last)}];
  if (series[0].values.length === 0) series[0].values.push(0);
  return element('section', {class: 'figure'}, element('h2', {}, 'Triangles above order 0'),
                 barChart(series[0].values.map((_, i) => i + 1), series, {title: 'Triangles of each order', label: 'order'}),
                 element('p', {class: 'note'}, `${count(data.order_histogram[0] ?? 0)} of ${count(data.triangles)} triangles have order 0.`));
}

function factsFigure(data) {
  const facts = [
    ['File', data.file],
    ['Coordinate system', data.crs || 'not stated'],
    ['Method', data.method || 'not known'],
    ['Order', String(data.order)],
    ['Vertices', count(data.vertices)],
    ['Triangles', count(data.triangles)],
    ['Smallest angle', data.min_angle_deg.map((angle) => (angle === null ? '' : `${angle.toFixed(3)}\u00b0`)).filter((t) => t).join(' \u2192 ')],
    ['Sites in, SHA-256', data.hash_in || 'not known'],
    ['Sites out, SHA-256', data.hash_out],
    ['thalweg', data.version],
  ];
  return element('section', {class: 'figure'}, element('h2', {}, 'Facts'),
                 element('dl', {class: 'facts'}, ...facts.flatMap(([name, value]) =>
                   [element('dt', {}, name), element('dd', {}, value)])),
                 element('p', {class: 'note'}, 'The hashes are of all sites sorted by x, y, z, each as three little-endian doubles.'));
}

function showFigures(data) {
  byId('figures').replaceChildren(
    ...(data.sweep.order.length > 0 ? [sweepFigure(data.sweep)] : []),
    element('div', {class: 'stack'}, ordersFigure(data), factsFigure(data)));
}

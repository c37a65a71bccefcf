// What a person does with a report, done in a real browser.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {after, before, test} from 'node:test';

import {close, kData, open, painted, picture, placeOfPit, rows, settle, start, stop, thalweg, tipText, work, write} from './support.mjs';

const kHostile = 'x<img src=x onerror=alert(1)>".xyz';
const kHostileTable = 'y"><svg onload=alert(2)><!--&amp;\'.csv';
let summary;
let sweep;
let orders;  // of each triangle, by its corners

// Numbers as the page groups them.
const digits = (text) => text.replace(/[\u202f\s]/g, '');

// The largest order of the triangles at a vertex.
function ordersAround(triangles, vertex) {
  return Math.max(...[...triangles].filter(([corners]) => corners.split(',').includes(String(vertex))).map(([, order]) => order));
}

// In the page: all coordinates as its tips tell them, by the vertices of mesh files.
function tellAll() {
  const {axes, names} = window.thalwegReport.terrain;
  const rows = [];
  names.forEach((name, v) => { rows[name] = axes.map((axis) => axis.at(v)); });
  return rows;
}

before(async () => {
  await start();
  const terrain = `${kData}jacksboro_1.xyz`;
  summary = JSON.parse(thalweg('build', terrain, '--report', 'terrain.html', '--sweep', '--pits', 'pits.csv', '-o', 'mesh.ply',
                               '--json', '-'));
  write('summary.json', JSON.stringify(summary));
  thalweg('build', terrain, '-o', 'mesh.txt', '--to', 'ply-ascii');
  const lines = readFileSync(work('mesh.txt'), 'utf8').split('\n');
  orders = new Map(lines.filter((line) => /^3 \d+ \d+ \d+ \d+$/.test(line)).map((line) => {
    const [, a, b, c, order] = line.split(' ').map(Number);
    return [[a, b, c].sort((p, q) => p - q).join(), order];
  }));
  sweep = JSON.parse(thalweg('sweep', terrain, '--json', '-'))[0].rows;
  thalweg('report', 'mesh.ply', '-o', 'mesh.html');
  thalweg('report', 'summary.json', '-o', 'summary.html');
});

after(stop);

test('opens from disk without an error or a request, and tells the figures of the summary', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const cards = digits(await page.locator('#headline').innerText());
  const {delaunay, result} = summary.pits;
  assert.ok(cards.includes(`${delaunay.total}\u2192${result.total}`));
  assert.ok(cards.includes(`interior${delaunay.interior}\u2192${result.interior},boundary${delaunay.boundary}\u2192${result.boundary}`));
  assert.ok(cards.includes(`\u2713${summary.pits.lower_bound}certified`));
  assert.ok(cards.includes(`${summary.mesh.edges_changed}${summary.mesh.non_delaunay_edges}notlocallyDelaunay`));
  assert.ok(cards.includes('unchanged'));
  assert.equal(await page.title(), `${kData}jacksboro_1.xyz - thalweg`);
  await page.screenshot({path: work('light.png')});
  await close(report);
});

test('draws the changed edges and the basins that the summary counts', async () => {
  const report = await open('terrain.html');
  const found = await report.page.evaluate(() => {
    const {terrain} = window.thalwegReport;
    return {edges: [terrain.oldEdges.length / 2, terrain.newEdges.length / 2],
            basins: terrain.sinks.map((sink) => new Set(sink).size)};
  });
  assert.deepEqual(found.edges, [summary.mesh.edges_changed, summary.mesh.edges_changed]);
  assert.deepEqual(found.basins, [summary.pits.delaunay.total, summary.pits.result.total]);
  await close(report);
});

test('hovering over pits tells their figures, in full', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const pits = rows('pits.csv');
  const remaining = pits.find((pit) => pit.removed === 'false' && pit.boundary === 'false' && pit.order_needed !== '');
  const removed = pits.find((pit) => pit.removed === 'true');
  for (const [map, pit] of [['after', remaining], ['before', removed]]) {
    const place = await placeOfPit(page, map, Number(pit.vertex));
    await page.mouse.move(place.x, place.y);
    await settle(page);
    const tip = await tipText(page, map);
    for (const word of [pit.x, pit.y, pit.z, pit.vertex]) assert.ok(tip.includes(word), `${word} in ${tip}`);
    assert.ok(tip.includes(map === 'after' ? `it would need order ${pit.order_needed}` : 'drains over a new edge'), tip);
    const order = map === 'after' ? ordersAround(orders, Number(pit.vertex)) : 0;
    assert.match(tip, new RegExp(`its triangles\\s+order ${order} at most`));
  }
  await close(report);
});

test('hovering over vertices tells their coordinates, in full', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const sites = readFileSync(`${kData}jacksboro_1.xyz`, 'utf8').trim().split('\n').map((line) => line.trim().split(/\s+/).map(Number));
  assert.deepEqual(await page.evaluate(tellAll), sites);
  const targets = await page.evaluate(() => {
    const {terrain, view, pits, style} = window.thalwegReport;
    const box = document.querySelector('#map-after canvas').getBoundingClientRect();
    const found = [];
    for (let v = 0; v < terrain.vertices && found.length < 5; v += 100) {
      const [x, y] = view.toScreen(terrain.x[v], terrain.y[v]);
      const place = [box.left + Math.round(x), box.top + Math.round(y)];
      const inside = [place[0] - box.left, place[1] - box.top];
      if (pits.near(view, ...inside, style) || terrain.vertexNear(1, ...view.fromScreen(...inside), 3 / view.scale) !== v) continue;
      found.push([...place, terrain.names[v]]);
    }
    return found;
  });
  assert.ok(targets.length > 0);
  for (const [x, y, name] of targets) {
    await page.mouse.move(x, y);
    await settle(page);
    const tip = await tipText(page, 'after');
    for (const word of [`Vertex ${name}`, ...sites[name].map(String)]) assert.ok(tip.includes(word), `${word} in ${tip}`);
    assert.match(tip, new RegExp(`its triangles\\s+order ${ordersAround(orders, name)} at most`));
  }
  await page.screenshot({path: work('vertex.png')});
  await close(report);
});

test('hovering elsewhere tells the order of the triangle and the elevation there', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const targets = await page.evaluate(() => {
    const {terrain, view, pits, style} = window.thalwegReport;
    const found = [];
    const box = document.querySelector('#map-after canvas').getBoundingClientRect();
    for (let t = terrain.common + terrain.before; t < terrain.triangles && found.length < 5; ++t) {
      const corners = [...terrain.corners.subarray(3 * t, 3 * t + 3)];
      const mean = (values) => corners.reduce((sum, v) => sum + values[v], 0) / 3;
      const place = view.toScreen(mean(terrain.x), mean(terrain.y));
      const x = Math.round(box.left + place[0]), y = Math.round(box.top + place[1]);
      const inside = [x - box.left, y - box.top];
      if (pits.near(view, ...inside, style) || terrain.triangleAt(1, ...view.fromScreen(...inside)) !== t) continue;
      if (terrain.vertexNear(1, ...view.fromScreen(...inside), 6 / view.scale) >= 0) continue;
      const names = corners.map((v) => terrain.names[v]).sort((a, b) => a - b);
      found.push({x, y, names, order: terrain.order(t)});
    }
    return found;
  });
  assert.ok(targets.length > 0);
  for (const target of targets) {
    await page.mouse.move(target.x, target.y);
    await settle(page);
    const tip = await tipText(page, 'after');
    assert.equal(target.order, orders.get(target.names.join()));
    assert.ok(tip.includes(`Triangle of order ${target.order}`), tip);
    assert.match(tip, /elevation\s+\d/);
  }
  await close(report);
});

test('both maps stay in step', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const left = await page.locator('#map-before canvas').boundingBox();
  const right = await page.locator('#map-after canvas').boundingBox();
  await page.mouse.move(left.x + 200, left.y + 150);
  await page.mouse.wheel(0, -700);
  await page.mouse.down();
  await page.mouse.move(left.x + 260, left.y + 190, {steps: 4});
  await page.mouse.up();
  await settle(page);
  const views = await page.evaluate(() => window.thalwegReport.maps.map((map) => map.painted));
  assert.deepEqual(views[0], views[1]);
  assert.ok(views[0].scale > 2 * await page.evaluate(() => window.thalwegReport.view.fittingScale()));
  const places = [];
  for (const [map, box] of [['before', left], ['after', right]]) {
    await page.mouse.move(box.x + 320, box.y + 240);
    await settle(page);
    places.push((await tipText(page, map)).match(/x\s+([\d.\u202f]+)\s+y\s+([\d.\u202f]+)/)?.slice(1));
  }
  assert.ok(places[0]);
  assert.deepEqual(places[0], places[1]);
  await close(report);
});

test('a row of the table flies to its pit', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  await page.locator('#table-filter button[data-kind=removed]').click();
  assert.equal(await page.locator('#pits tbody tr').count(), 50);
  const row = page.locator('#pits tbody tr').nth(2);
  const cells = await row.locator('td').allInnerTexts();
  await row.click();
  await settle(page);
  const at = await page.evaluate(() => {
    const {view, state} = window.thalwegReport;
    return {near: Math.hypot(view.x - state.chosen.x, view.y - state.chosen.y), name: state.chosen.name, x: state.chosen.realX};
  });
  assert.equal(String(at.name), cells[1]);
  assert.equal(String(at.x), cells[2]);
  assert.ok(at.near < 1e-6);
  for (const map of ['before', 'after']) assert.ok((await tipText(page, map)).includes(cells[4]));
  assert.equal(await row.getAttribute('aria-current'), 'true');
  await page.screenshot({path: work('flown.png')});
  await close(report);
});

test('layers can be switched', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  let last = await picture(page, '#map-after canvas');
  for (const layer of ['shading', 'edges', 'changes', 'flow', 'removed', 'remaining', 'boundary']) {
    await page.locator(`#layer-${layer}`).click();
    await settle(page);
    const now = await picture(page, '#map-after canvas');
    assert.notEqual(now, last, layer);
    last = now;
  }
  for (const fill of ['basins', 'orders', 'none', 'elevation']) {
    await page.locator('#fill').selectOption(fill);
    await settle(page);
    const now = await picture(page, '#map-after canvas');
    assert.notEqual(now, last, fill);
    last = now;
  }
  await close(report);
});

test('the keyboard moves, zooms, visits pits, changes tabs and walks the table', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  const view = () => page.evaluate(() => ({x: window.thalwegReport.view.x, y: window.thalwegReport.view.y, scale: window.thalwegReport.view.scale}));
  await page.locator('#map-before canvas').focus();
  const fitted = await view();
  await page.keyboard.press('+');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  const moved = await view();
  assert.ok(moved.scale > fitted.scale && moved.x > fitted.x && moved.y > fitted.y);
  await page.keyboard.press('n');
  await settle(page);
  assert.match(await page.locator('#announce').innerText(), /Pit|pit/);
  assert.notEqual(await tipText(page, 'after'), '');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal(await tipText(page, 'after'), '');
  await page.keyboard.press('0');
  assert.deepEqual(await view(), fitted);
  const asked = [];
  for (const key of ['Enter', 'ArrowRight', 'ArrowRight']) {
    await page.keyboard.press(key);
    await settle(page);
    asked.push(await tipText(page, 'before'));
    assert.match(asked.at(-1), /Triangle|Vertex|Pit|pit/);
    assert.equal(digits(await page.locator('#announce').textContent()).replaceAll(',', ''), digits(asked.at(-1)).replaceAll(',', ''));
  }
  assert.notEqual(asked[0], asked[2]);
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal(await tipText(page, 'before'), '');
  await page.locator('#pits tbody tr').first().focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await page.locator('#pits tbody tr').nth(1).getAttribute('aria-current'), 'true');
  await page.locator('#tab-maps').focus();
  await page.keyboard.press('ArrowRight');
  assert.ok(await page.locator('#panel-figures').isVisible());
  await close(report);
});

test('the bar chart shows the sweep', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  await page.locator('#tab-figures').click();
  const bars = await page.locator('#sweep rect title').allTextContents();
  assert.equal(bars.length, 33);
  for (const row of sweep) {
    for (const method of ['flip', 'hull', 'best']) assert.ok(bars.includes(`order ${row.order}: ${method} ${row[method]}`));
  }
  await page.screenshot({path: work('figures.png')});
  await close(report);
  const without = await open('mesh.html');
  assert.equal(await without.page.locator('#sweep').count(), 0);
  await close(without);
});

test('the terrain stands in 3D and grows with the slider', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  await page.locator('#tab-scene').click();
  await page.waitForFunction(() => window.thalwegReport.scene.renderer && document.getElementById('scene-message').textContent === '');
  await page.waitForTimeout(300);
  const first = await picture(page, '#scene');
  await page.locator('#exaggeration').fill('3');
  assert.notEqual(await picture(page, '#scene'), first);
  const high = await picture(page, '#scene');
  await page.locator('#scene').focus();
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await picture(page, '#scene'), high);
  await page.screenshot({path: work('scene.png')});
  await close(report);
});

test('light and dark, by the system and by hand', async () => {
  const background = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await open('terrain.html', {scheme: 'dark'});
  assert.equal(await background(dark.page), 'rgb(21, 24, 26)');
  await dark.page.locator('#theme').click();
  assert.equal(await background(dark.page), 'rgb(255, 255, 255)');
  await dark.page.locator('#theme').click();
  await settle(dark.page);
  assert.equal(await background(dark.page), 'rgb(21, 24, 26)');
  await dark.page.screenshot({path: work('dark.png')});
  await close(dark);
});

test('prints maps, table and figures without the controls', async () => {
  const report = await open('terrain.html');
  const {page} = report;
  await page.emulateMedia({media: 'print'});
  assert.ok(await page.locator('#panel-figures').isVisible());
  assert.ok(await page.locator('#map-after canvas').isVisible());
  assert.ok(!await page.locator('#layers').isVisible());
  const pdf = await page.pdf({path: work('print.pdf'), format: 'A4', landscape: true});
  assert.ok(pdf.length > 50000);
  await close(report);
});

test('reports of a mesh and of a summary tell the same', async () => {
  const told = [];
  for (const name of ['terrain.html', 'mesh.html', 'summary.html']) {
    const report = await open(name);
    told.push(await report.page.evaluate(() => {
      const {data} = window.thalwegReport;
      return [data.pits, data.edges_changed, data.non_delaunay_edges, data.lower_bound, data.hash_out, data.water.basins,
              data.water.length, data.removed.x, data.remaining.x, data.remaining.spill];
    }));
    await close(report);
  }
  assert.deepEqual(told[0], told[1]);
  assert.deepEqual(told[0], told[2]);
});

test('names and headers cannot inject anything', async () => {
  const points = readFileSync(`${kData}jacksboro_2.xyz`, 'utf8').split('\n').slice(0, 200).join('\n');
  const markup = '</script><script>alert(1)</script><!--';
  write(kHostile, `# ${markup}\n${points}`);
  write('hostile.ply', `ply\nformat ascii 1.0\ncomment crs: ${markup}<b id="planted">\nelement vertex 3\nproperty double x\n` +
        'property double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n' +
        '0 0 1\n1 0 2\n0 1 3\n3 0 1 2\n');
  write(kHostileTable, `"${markup}",x,y,z,"</title><img src=x onerror=alert(3)>"\n` +
        points.split('\n').map((line) => `"<b id=planted>",${line.trim().split(/\s+/).join()},"</script>"\n`).join(''));
  thalweg('build', kHostileTable, '--report', 'hostile_table.html', '-o', 'hostile_table.svg');
  thalweg('build', kHostile, '--report', 'hostile.html', '-o', 'hostile.svg', '--json', 'hostile.json');
  thalweg('report', 'hostile.ply', '-o', 'hostile_mesh.html');
  const shown = {'hostile.html': kHostile, 'hostile_table.html': kHostileTable, 'hostile_mesh.html': markup};
  for (const [name, text] of Object.entries(shown)) {
    const report = await open(name);
    assert.equal(await report.page.locator('img, svg[onload], #planted').count(), 0);
    await report.page.locator('#tab-figures').click();
    assert.ok((await report.page.locator('#figures').innerText()).includes(text), name);
    await close(report);
  }
  for (const name of ['hostile.svg', 'hostile_table.svg']) assert.ok(!/<img|<svg onload/.test(readFileSync(work(name), 'utf8')));
});

test('draws level, huge, tiny and three-point terrains', async () => {
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const places = Array.from({length: 300}, () => [random(), random(), random()]);
  const terrains = {
    level: places.map(([x, y]) => [x, y, 42]),
    high: places.map(([x, y, z]) => [x, y, (z - 0.5) * 2 * 1.7e308]),
    far: places.map(([x, y, z]) => [(x - 0.5) * 2 * 1.7e308, (y - 0.5) * 2 * 1.7e308, z * 1e-310]),
    small: places.map(([x, y, z]) => [x * 1e-300, y * 1e-300, z]),
    three: [[0, 0, 1], [1, 0, 2], [0, 1, 3]],
  };
  for (const [name, points] of Object.entries(terrains)) {
    write(`${name}.xyz`, points.map((p) => p.join(' ')).join('\n') + '\n');
    thalweg('build', `${name}.xyz`, '--report', `${name}.html`, '-o', `${name}.svg`, '--layers', 'shading,cells,flow,edges,changes,pits');
    assert.ok(!/nan|inf/i.test(readFileSync(work(`${name}.svg`), 'utf8').replace(/<text.*?<\/text>/g, '')), name);
    const report = await open(`${name}.html`, {scheme: 'dark'});
    const {page} = report;
    const part = await painted(page, '#map-after canvas');
    assert.ok(part > 0.2, `${name}: ${part}`);
    assert.deepEqual(await page.evaluate(tellAll), points, name);
    await page.locator('#map-before canvas').focus();
    await page.keyboard.press('n');
    await page.locator('#tab-scene').click();
    await page.waitForFunction(() => window.thalwegReport.scene.renderer);
    await page.locator('#tab-maps').click();
    await settle(page);
    await page.screenshot({path: work(`${name}.png`)});
    await close(report);
  }
});

test('without WebGL the maps are drawn all the same, and the third tab says why it is empty', async () => {
  const {page} = await open('terrain.html', {webgl: false});
  assert.ok(await painted(page, '#map-before canvas') > 0.4);
  await page.locator('#fill').selectOption('basins');
  await settle(page);
  assert.ok(await painted(page, '#map-after canvas') > 0.4);
  await page.screenshot({path: work('without_webgl.png')});
  await page.locator('#tab-scene').click();
  await page.waitForFunction(() => document.getElementById('scene-message').textContent.includes('cannot be shown'));
  await page.close();
});

// Milliseconds that a frame takes while the maps are dragged, the median.
function frameTime(page) {
  return page.evaluate(() => new Promise((done) => {
    const {view} = window.thalwegReport;
    const times = [];
    let last = performance.now();
    const step = (now) => {
      times.push(now - last);
      last = now;
      if (times.length > 40) return done(times.sort((a, b) => a - b)[20]);
      view.move(times.length % 2 === 0 ? 3 : -2, 1);
      return requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }));
}

test('a million triangles open within 5 s and move fluidly', {skip: !process.env.LARGE}, async () => {
  thalweg('generate', 'fractal', '-n', '500000', '--seed', '1', '-o', 'million.xyz');
  thalweg('build', 'million.xyz', '--report', 'million.html');
  const report = await open('million.html');
  const opened = await report.page.evaluate(() => performance.now());
  await report.page.waitForTimeout(2000);
  const frame = await frameTime(report.page);
  console.log(`opened in ${Math.round(opened)} ms, a frame takes ${Math.round(frame)} ms`);
  await settle(report.page);
  await report.page.screenshot({path: work('million.png')});
  assert.ok(opened < 5000 && frame < 50);
  await close(report);
});

test('beyond a million triangles the maps are thinned out, and say so', {skip: !process.env.LARGE}, async () => {
  thalweg('generate', 'fractal', '-n', '1000000', '--seed', '1', '-o', 'more.xyz');
  const {mesh} = JSON.parse(thalweg('build', 'more.xyz', '--report', 'more.html', '--json', '-'));
  const report = await open('more.html');
  assert.match(await report.page.locator('#thinned').innerText(), /thinned out elsewhere/);
  const drawn = await report.page.evaluate(() => {
    const {terrain} = window.thalwegReport;
    return {triangles: terrain.common + terrain.after, changed: terrain.newEdges.length / 2, pits: window.thalwegReport.pits.list.length};
  });
  assert.ok(drawn.triangles <= 1000000);
  assert.equal(drawn.changed, mesh.edges_changed);
  await close(report);
});

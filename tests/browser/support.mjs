// Reports made by the command, and pages that show them.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const {CHROMIUM, THALWEG, WORK} = process.env;
const {chromium} = createRequire(join(WORK, 'here.js'))('playwright-core');

export const kData = fileURLToPath(new URL('../data/', import.meta.url));

export function work(name) {
  return join(WORK, name);
}

export function write(name, text) {
  writeFileSync(work(name), text);
}

export function thalweg(...args) {
  return execFileSync(THALWEG, [...args, '--overwrite', '-q'], {cwd: WORK, encoding: 'utf8', maxBuffer: 1 << 28});
}

// Rows of a csv file without quotes, as objects.
export function rows(name) {
  const [head, ...lines] = readFileSync(work(name), 'utf8').trim().split('\n').map((line) => line.split(','));
  return lines.map((line) => Object.fromEntries(head.map((key, i) => [key, line[i]])));
}

let browser;

// Without a GPU everything is drawn by the processor: the same picture on every machine.
export async function start() {
  mkdirSync(WORK, {recursive: true});
  browser = await chromium.launch({executablePath: CHROMIUM, args: ['--no-sandbox', '--disable-gpu']});
}

export async function stop() {
  await browser.close();
}

// A page with the report, ready; `faults` gathers errors and requests that must not be.
export async function open(name, {scheme = 'light', width = 1400, height = 1000, webgl = true} = {}) {
  const page = await browser.newPage({viewport: {width, height}, colorScheme: scheme, reducedMotion: 'reduce'});
  const faults = [];
  if (!webgl) {
    await page.addInitScript(() => {
      const {getContext} = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind === '2d' ? getContext.call(this, kind, ...more) : null;
      };
    });
  }
  const address = pathToFileURL(work(name)).href;
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('request', (request) => request.url() !== address && !request.url().startsWith('blob:') && faults.push(request.url()));
  page.on('dialog', (dialog) => faults.push(dialog.message()));
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, {timeout: 60000});
  return {page, faults};
}

export async function close({page, faults}) {
  assert.deepEqual(faults, []);
  await page.close();
}

// Waits until what was asked for is on the screen.
export async function settle(page) {
  await page.evaluate(() => new Promise((done) => {
    const look = () => {
      const {frames, view} = window.thalwegReport;
      if (frames.waiting || frames.stale || view.flight) requestAnimationFrame(look);
      else requestAnimationFrame(() => requestAnimationFrame(done));
    };
    setTimeout(look, 130);
  }));
}

// Where a pit is on the page, in the map 'before' or 'after'; the pit is named by its vertex in mesh files.
export async function placeOfPit(page, map, name) {
  return page.evaluate(([which, wanted]) => {
    const {pits, view} = window.thalwegReport;
    const pit = pits.list.find((p) => p.name === wanted);
    const box = document.querySelector(`#map-${which} canvas`).getBoundingClientRect();
    const [x, y] = view.toScreen(pit.x, pit.y);
    return {x: box.left + x, y: box.top + y};
  }, [map, name]);
}

export async function tipText(page, map) {
  const tip = page.locator(`#map-${map} .tip`);
  return (await tip.isVisible()) ? tip.innerText() : '';
}

export function picture(page, selector) {
  return page.locator(selector).evaluate((canvas) => canvas.toDataURL());
}

// The part of a canvas that is painted.
export function painted(page, selector) {
  return page.locator(selector).evaluate((canvas) => {
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const {data} = context.getImageData(0, 0, copy.width, copy.height);
    let some = 0;
    for (let i = 3; i < data.length; i += 4) some += data[i] > 0 ? 1 : 0;
    return some / (data.length / 4);
  });
}

// What both maps show: one centre and one scale, shared by them.

class View {
  constructor(terrain) {
    this.terrain = terrain;
    this.x = 0;
    this.y = 0;
    this.scale = 1;  // pixels a unit
    this.width = 1;
    this.height = 1;
    this.ratio = 1;  // device pixels a pixel
    this.listeners = [];
    this.fitted = true;
    this.flight = 0;
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  changed() {
    for (const listener of this.listeners) listener();
  }

  fittingScale() {
    const {box} = this.terrain;
    const margin = 18;
    const wide = Math.max(box.right - box.left, 1e-6), high = Math.max(box.top - box.bottom, 1e-6);
    return Math.max(1, Math.min((this.width - 2 * margin) / wide, (this.height - 2 * margin) / high));
  }

  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    if (this.fitted) this.fit();
    else this.changed();
  }

  fit() {
    const {box} = this.terrain;
    this.land();
    this.x = (box.left + box.right) / 2;
    this.y = (box.bottom + box.top) / 2;
    this.scale = this.fittingScale();
    this.fitted = true;
    this.changed();
  }

  toScreen(x, y) {
    return [(x - this.x) * this.scale + this.width / 2, (this.y - y) * this.scale + this.height / 2];
  }

  fromScreen(px, py) {
    return [(px - this.width / 2) / this.scale + this.x, this.y - (py - this.height / 2) / this.scale];
  }

  box() {
    const [left, top] = this.fromScreen(0, 0);
    const [right, bottom] = this.fromScreen(this.width, this.height);
    return {left, right, top, bottom};
  }

  move(dx, dy) {
    this.land();
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.keepInSight();
    this.fitted = false;
    this.changed();
  }

  // Zooms by a factor about a place of the screen.
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    this.land();
    const [x, y] = this.fromScreen(px, py);
    const least = this.fittingScale() / 2;
    this.scale = Math.min(least * 2e5, Math.max(least, this.scale * factor));
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
    this.keepInSight();
    this.fitted = false;
    this.changed();
  }

  keepInSight() {
    const {box} = this.terrain;
    this.x = Math.min(box.right, Math.max(box.left, this.x));
    this.y = Math.min(box.top, Math.max(box.bottom, this.y));
  }

  // Moves smoothly, unless the reader wants less motion.
  flyTo(x, y, scale) {
    this.land();
    this.fitted = false;
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const from = {x: this.x, y: this.y, scale: this.scale};
    const start = performance.now();
    const step = (now) => {
      const part = still ? 1 : Math.min(1, (now - start) / 650);
      const ease = part < 0.5 ? 4 * part ** 3 : 1 - (-2 * part + 2) ** 3 / 2;
      this.scale = from.scale * (scale / from.scale) ** ease;
      // The centre moves as the scale does, so that the target does not run away on the way in.
      const moved = from.scale === scale ? ease : (1 - from.scale / this.scale) / (1 - from.scale / scale);
      this.x = from.x + (x - from.x) * moved;
      this.y = from.y + (y - from.y) * moved;
      if (part === 1) {
        this.x = x;
        this.y = y;
        this.scale = scale;
        this.flight = 0;
      } else {
        this.flight = requestAnimationFrame(step);
      }
      this.changed();
    };
    if (still) step(start);
    else this.flight = requestAnimationFrame(step);
  }

  land() {
    if (this.flight) cancelAnimationFrame(this.flight);
    this.flight = 0;
  }
}

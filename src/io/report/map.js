// One of the two maps: a canvas, what moves it, and its tip.

class MapView {
  constructor(figure, which, shared) {
    Object.assign(this, shared);  // terrain, pits, view, shader, style, state
    this.which = which;
    this.canvas = figure.querySelector('canvas');
    this.tip = figure.querySelector('.tip');
    this.context = this.canvas.getContext('2d');
    this.picture = document.createElement('canvas');
    this.pictureContext = this.picture.getContext('2d');
    this.overlay = new Overlay(this.terrain, this.pits, which);
    this.canvas.setAttribute('aria-label', `${which === 0 ? 'Delaunay triangulation' : 'Result'}: map`);
    this.pointers = new Map();
    this.listen();
  }

  resize(canvas) {
    const {view} = this;
    const width = Math.round(view.width * view.ratio), height = Math.round(view.height * view.ratio);
    if (canvas.width === width && canvas.height === height) return;
    canvas.width = width;
    canvas.height = height;
  }

  // Makes the picture of the present view: all but what moves with the pointer.
  paint() {
    const {picture, pictureContext: context, view, style} = this;
    const theme = currentTheme();
    this.resize(picture);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, picture.width, picture.height);
    this.shader.paint(context, this.which, view, picture.width, picture.height, style, theme);
    this.overlay.draw(context, view, style, theme);
    this.painted = {x: view.x, y: view.y, scale: view.scale};
  }

  // Shows the picture where it now belongs: moved and scaled if the view has changed since it was painted.
  show() {
    const {context, canvas, view, painted, picture} = this;
    this.resize(canvas);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const factor = view.scale / painted.scale;
    const left = (painted.x - view.x) * view.scale * view.ratio + (canvas.width / 2) * (1 - factor);
    const top = (view.y - painted.y) * view.scale * view.ratio + (canvas.height / 2) * (1 - factor);
    context.setTransform(factor, 0, 0, factor, left, top);
    context.drawImage(picture, 0, 0);
    context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
    this.overlay.drawScaleBar(context, view, currentTheme());
    this.drawMarker(currentTheme());
  }

  // The chosen pit, and a cross where the pointer is in the other map, or where the keyboard asks.
  drawMarker(theme) {
    const {context, view, state} = this;
    context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
    const circle = (x, y, radius) => {
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
    };
    if (state.chosen) {
      const [x, y] = view.toScreen(state.chosen.x, state.chosen.y);
      circle(x, y, this.pits.radius(view, state.chosen.part) + 7);
      context.lineWidth = 4.5;
      context.strokeStyle = theme.halo;
      context.stroke();
      context.lineWidth = 2;
      context.strokeStyle = theme.marker;
      context.stroke();
    }
    if (state.pointer && (state.pointer.map !== this.which || state.pointer.middle)) {
      const {px, py} = state.pointer;
      context.beginPath();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        context.moveTo(px + 4 * dx, py + 4 * dy);
        context.lineTo(px + 11 * dx, py + 11 * dy);
      }
      context.lineWidth = 3.5;
      context.strokeStyle = theme.halo;
      context.stroke();
      context.lineWidth = 1.5;
      context.strokeStyle = theme.marker;
      context.stroke();
    }
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  listen() {
    const {canvas, view} = this;
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 18 : 1;
      view.zoom(Math.exp(-event.deltaY * lines * 0.0016), ...this.place(event));
    }, {passive: false});
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, this.place(event));
      this.moved = 0;
    });
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    canvas.addEventListener('pointerup', (event) => this.onUp(event));
    canvas.addEventListener('pointercancel', (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('pointerleave', () => this.state.setPointer(null));
    canvas.addEventListener('dblclick', (event) => view.zoom(2, ...this.place(event)));
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  onMove(event) {
    const place = this.place(event);
    const last = this.pointers.get(event.pointerId);
    if (!last) {
      this.state.setPointer({map: this.which, px: place[0], py: place[1]});
      return;
    }
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId);
    if (others.length === 1) {
      const [[, other]] = others;
      const before = Math.hypot(last[0] - other[0], last[1] - other[1]);
      const now = Math.hypot(place[0] - other[0], place[1] - other[1]);
      if (before > 0) this.view.zoom(now / before, (place[0] + other[0]) / 2, (place[1] + other[1]) / 2);
    } else {
      this.moved += Math.hypot(place[0] - last[0], place[1] - last[1]);
      this.view.move(place[0] - last[0], place[1] - last[1]);
    }
    this.pointers.set(event.pointerId, place);
    this.state.setPointer(null);
  }

  onUp(event) {
    this.pointers.delete(event.pointerId);
    if (this.moved > 4) return;
    const place = this.place(event);
    this.state.choose(this.pits.near(this.view, ...place, this.style) ?? null, {fly: false});
    this.state.setPointer({map: this.which, px: place[0], py: place[1]});
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const {view, state} = this;
    const step = event.shiftKey ? 240 : 60;
    const keys = {
      ArrowLeft: () => view.move(step, 0),
      ArrowRight: () => view.move(-step, 0),
      ArrowUp: () => view.move(0, step),
      ArrowDown: () => view.move(0, -step),
      '+': () => view.zoom(1.5),
      '=': () => view.zoom(1.5),
      '-': () => view.zoom(1 / 1.5),
      0: () => view.fit(),
      Home: () => view.fit(),
      n: () => state.chooseNext(1),
      p: () => state.chooseNext(-1),
      Enter: () => state.setPointer({map: this.which, px: view.width / 2, py: view.height / 2, middle: true}),
      Escape: () => state.choose(null),
    };
    const action = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

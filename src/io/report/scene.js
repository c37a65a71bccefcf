// The third tab: the terrain in three dimensions, by three.js, which is unpacked when the tab is first opened.

class SceneView {
  constructor(terrain, pits, shader) {
    this.terrain = terrain;
    this.pits = pits;
    this.shader = shader;
    this.canvas = byId('scene');
    this.which = 1;
    this.exaggeration = 1;
    this.makeControls();
  }

  makeControls() {
    const value = element('output', {id: 'exaggeration-value'}, '1.0\u00d7');
    const slider = element('input', {type: 'range', id: 'exaggeration', min: 0, max: 4, step: 0.05, value: 1,
      oninput: () => {
        this.exaggeration = Number(slider.value);
        value.textContent = `${this.exaggeration.toFixed(2)}\u00d7`;
        this.update();
      }});
    const buttons = ['Delaunay', 'Result'].map((label, which) =>
      element('button', {type: 'button', 'aria-pressed': String(which === 1), onclick: () => this.choose(which)}, label));
    this.buttons = buttons;
    byId('scene-controls').append(
      element('div', {class: 'segmented', role: 'group', 'aria-label': 'Terrain'}, ...buttons),
      element('label', {for: 'exaggeration'}, 'Height'), slider, value,
      element('span', {class: 'hint'}, 'drag or arrow keys to turn, wheel or + - to zoom'));
  }

  choose(which) {
    this.which = which;
    this.buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === which)));
    this.update();
  }

  async open() {
    if (this.opened) return this.resize();
    this.opened = true;
    const message = byId('scene-message');
    try {
      message.textContent = 'Preparing\u2026';
      await this.load();
      message.textContent = '';
    } catch (error) {
      message.textContent = `The terrain cannot be shown in 3D here: ${error.message}`;
    }
    return undefined;
  }

  async load() {
    const code = new TextDecoder().decode(await inflate(byId('report-three').textContent.trim()));
    const script = document.createElement('script');
    script.textContent = `${code}\nglobalThis.THREE = THREE;`;
    document.head.append(script);
    const {THREE} = globalThis;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.01, 50);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(-0.35, -2.35, 1.75);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.minDistance = 0.05;
    this.controls.maxDistance = 12;
    this.controls.addEventListener('change', () => this.draw());
    this.canvas.addEventListener('keydown', (event) => this.onKey(event));
    this.group = new THREE.Group();
    const {box} = this.terrain;
    this.group.position.set(-(box.left + box.right) / 2, -(box.bottom + box.top) / 2, 0);
    this.scene.add(this.group);
    const sun = new THREE.DirectionalLight(0xffffff, 2.3);
    sun.position.set(-1, 1, 1.3);
    this.scene.add(sun, new THREE.AmbientLight(0xffffff, 1.0));
    this.makeMeshes(THREE);
    this.makePits(THREE);
    this.colour();
    this.resize();
  }

  // One buffer of places for all triangles of common, before, after; each map draws its part.
  makeMeshes(THREE) {
    const {terrain} = this;
    const places = new Float32Array(3 * terrain.vertices);
    for (let v = 0; v < terrain.vertices; ++v) {
      places[3 * v] = terrain.x[v];
      places[3 * v + 1] = terrain.y[v];
      places[3 * v + 2] = terrain.level[v] - 0.5;
    }
    this.colours = new THREE.BufferAttribute(new Uint8Array(3 * terrain.vertices), 3, true);
    const position = new THREE.BufferAttribute(places, 3);
    const material = new THREE.MeshLambertMaterial({vertexColors: true, flatShading: true, side: 2,
                                                    polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 60});
    const part = (first, number) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', position);
      geometry.setAttribute('color', this.colours);
      geometry.setIndex(new THREE.BufferAttribute(terrain.corners.subarray(3 * first, 3 * (first + number)), 1));
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      return mesh;
    };
    this.parts = [part(terrain.common, terrain.before), part(terrain.common + terrain.before, terrain.after)];
    this.group.add(part(0, terrain.common), ...this.parts);
  }

  // A white disc, which the colour of the material tints.
  makeDisc(THREE) {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 64;
    const context = canvas.getContext('2d');
    context.arc(32, 32, 30, 0, 2 * Math.PI);
    context.fillStyle = '#fff';
    context.fill();
    return new THREE.CanvasTexture(canvas);
  }

  makePits(THREE) {
    const map = this.makeDisc(THREE);
    this.clouds = ['removed', 'remaining', 'boundary'].map((kind) => {
      const shown = this.pits.list.filter((pit) => pit.shownAs === kind);
      const places = new Float32Array(shown.flatMap((pit) => [pit.x, pit.y, this.terrain.level[pit.vertex] - 0.5 + 0.02]));
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
      const size = Math.min(11, Math.max(3, 400 / Math.sqrt(this.pits.list.length + 1)));
      const points = new THREE.Points(geometry, new THREE.PointsMaterial({size, map, alphaTest: 0.5, sizeAttenuation: false}));
      points.frustumCulled = false;
      points.kind = kind;
      this.group.add(points);
      return points;
    });
  }

  colour() {
    if (!this.renderer) return;
    const theme = currentTheme();
    const ramp = theme.ramp.map(rgb);
    const {array} = this.colours;
    const linear = (value) => 255 * value ** 2.2;
    for (let v = 0; v < this.terrain.vertices; ++v) {
      const at = this.terrain.level[v] * 5;
      const i = Math.min(4, Math.floor(at));
      for (let k = 0; k < 3; ++k) array[3 * v + k] = linear(ramp[i][k] + (at - i) * (ramp[i + 1][k] - ramp[i][k]));
    }
    this.colours.needsUpdate = true;
    for (const cloud of this.clouds) cloud.material.color.set(theme[cloud.kind]);
    this.renderer.setClearColor(theme.paper, 1);
    this.update();
  }

  update() {
    if (!this.renderer) return;
    // At 1 typical slopes are as steep as the maps shade them, but the whole is never a tower.
    const height = Math.min(0.5, this.terrain.raise || 0.15);
    this.group.scale.set(1, 1, Math.max(1e-4, this.exaggeration * height));
    this.parts.forEach((part, which) => { part.visible = which === this.which; });
    this.draw();
  }

  resize() {
    if (!this.renderer) return;
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (box.width === 0) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(box.width, box.height, false);
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    this.update();
  }

  draw() {
    if (this.renderer) this.renderer.render(this.scene, this.camera);
  }

  onKey(event) {
    const {camera, controls} = this;
    const turnBy = (angle) => {
      const {x, y} = camera.position;
      camera.position.x = x * Math.cos(angle) - y * Math.sin(angle);
      camera.position.y = x * Math.sin(angle) + y * Math.cos(angle);
    };
    const keys = {
      ArrowLeft: () => turnBy(-0.1),
      ArrowRight: () => turnBy(0.1),
      ArrowUp: () => { camera.position.z += 0.1; },
      ArrowDown: () => { camera.position.z = Math.max(0.05, camera.position.z - 0.1); },
      '+': () => camera.position.multiplyScalar(1 / 1.15),
      '=': () => camera.position.multiplyScalar(1 / 1.15),
      '-': () => camera.position.multiplyScalar(1.15),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
    controls.update();
    this.draw();
  }
}

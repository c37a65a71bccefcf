// Paints hill-shaded triangles: one WebGL context for both maps, whose picture is copied into their canvases. What
// both have in common is painted once. Where there is no WebGL, a canvas does it, more slowly.

const kVertexShader = `#version 300 es
in vec2 place;
in float level;
in vec2 facts;   // shade, order
in vec2 basins;  // before, after
uniform vec4 view;  // scale x, scale y, centre x, centre y
uniform int which;
out float height;
out vec3 fact;
void main() {
  gl_Position = vec4((place - view.zw) * view.xy, 0.0, 1.0);
  height = level;
  fact = vec3(facts.x / 255.0, facts.y, which == 0 ? basins.x : basins.y);
}`;

const kFragmentShader = `#version 300 es
precision highp float;
in float height;
in vec3 fact;
uniform vec3 ramp[6];
uniform vec3 basinColours[12];
uniform vec3 orders[6];
uniform int fill;  // 0 elevation, 1 basins, 2 orders, 3 none
uniform vec2 light;  // in full shadow, in full light
uniform float shaded;
uniform vec3 paper;
out vec4 colour;
vec3 tint() {
  float at = clamp(height, 0.0, 1.0) * 5.0;
  int i = min(int(at), 4);
  return mix(ramp[i], ramp[i + 1], at - float(i));
}
void main() {
  vec3 base = paper;
  if (fill == 0) base = tint();
  if (fill == 1) base = basinColours[int(fact.z + 0.5)];
  if (fill == 2) base = orders[min(int(fact.y + 0.5), 5)];
  float strength = mix(1.0, mix(light.x, light.y, smoothstep(0.0, 1.0, fact.x)), shaded);
  colour = vec4(min(base * strength, 1.0), 1.0);
}`;

class Shader {
  constructor(terrain) {
    this.terrain = terrain;
    this.canvas = document.createElement('canvas');
    // Triangles smaller than a pixel need no smooth borders.
    const antialias = terrain.triangles < kSmoothTriangles;
    this.gl = this.canvas.getContext('webgl2', {antialias, preserveDrawingBuffer: true, alpha: true});
    if (this.gl) this.prepare();
  }

  // The colour of each triangle's basin in both maps; worked out when it is first asked for.
  get basins() {
    if (!this.madeBasins) {
      const colours = colourBasins(this.terrain);
      this.madeBasins = [0, 1].map((map) => basinOfTriangles(this.terrain, map, colours));
    }
    return this.madeBasins;
  }

  prepare() {
    const {gl} = this;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, kVertexShader], [gl.FRAGMENT_SHADER, kFragmentShader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      this.gl = null;
      return;
    }
    gl.useProgram(program);
    this.program = program;
    this.uniforms = new Map();
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, this.corners(), gl.STATIC_DRAW);
    this.attribute('place', 2, gl.FLOAT, false, 12, 0);
    this.attribute('level', 1, gl.UNSIGNED_SHORT, true, 12, 8);
    this.attribute('facts', 2, gl.UNSIGNED_BYTE, false, 12, 10);
    this.chunks = chunksOf(this.terrain);
    this.canvas.addEventListener('webglcontextlost', () => { this.gl = null; });
  }

  attribute(name, size, type, normalized, stride, offset) {
    const {gl} = this;
    const at = gl.getAttribLocation(this.program, name);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, type, normalized, stride, offset);
  }

  sendBasins() {
    if (this.sentBasins) return;
    this.sentBasins = true;
    const {gl} = this;
    const [before, after] = this.basins;
    const bytes = new Uint8Array(6 * before.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = (i % 2 === 0 ? before : after)[Math.floor(i / 6)];
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW);
    this.attribute('basins', 2, gl.UNSIGNED_BYTE, false, 2, 0);
  }

  // Each triangle has corners of its own: what is one colour all over it is the same in all three.
  corners() {
    const {terrain} = this;
    const buffer = new ArrayBuffer(12 * terrain.corners.length);
    const floats = new Float32Array(buffer);
    const shorts = new Uint16Array(buffer);
    const bytes = new Uint8Array(buffer);
    for (let i = 0; i < terrain.corners.length; ++i) {
      const v = terrain.corners[i];
      const t = (i - (i % 3)) / 3;
      floats[3 * i] = terrain.x[v];
      floats[3 * i + 1] = terrain.y[v];
      shorts[6 * i + 4] = 65535 * terrain.level[v];
      bytes[12 * i + 10] = terrain.shade[t];
      bytes[12 * i + 11] = Math.min(255, terrain.order(t));
    }
    return buffer;
  }

  // Calls back once all that was asked for is painted, without waiting for it.
  whenPainted(callback) {
    const {gl} = this;
    if (!gl) return callback();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (fence && this.gl && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return setTimeout(look, 4);
      gl.deleteSync(fence);
      return callback();
    };
    return setTimeout(look, 0);
  }

  uniform(name) {
    if (!this.uniforms.has(name)) this.uniforms.set(name, this.gl.getUniformLocation(this.program, name));
    return this.uniforms.get(name);
  }

  // Paints map 0 or 1 into a 2D context of width x height device pixels.
  paint(context, map, view, width, height, style, theme) {
    if (!this.gl) return this.paintByHand(context, map, view, width, height, style, theme);
    const {gl, canvas, terrain} = this;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const shared = JSON.stringify([view.x, view.y, view.scale, width, height, style.fill, style.shading, theme.paper]);
    const commonDone = map === 1 && this.holds === shared && style.fill !== 'basins';
    this.holds = map === 0 ? shared : '';
    if (style.fill === 'basins') this.sendBasins();
    gl.viewport(0, 0, width, height);
    if (!commonDone) {
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
    }
    const scale = view.scale * view.ratio;
    gl.uniform4f(this.uniform('view'), (2 * scale) / width, (2 * scale) / height, view.x, view.y);
    gl.uniform1i(this.uniform('which'), map);
    gl.uniform3fv(this.uniform('ramp'), theme.ramp.flatMap(rgb));
    gl.uniform3fv(this.uniform('basinColours'), theme.basins.flatMap(rgb));
    gl.uniform3fv(this.uniform('orders'), theme.orders.flatMap(rgb));
    gl.uniform3fv(this.uniform('paper'), rgb(theme.orders[0]));
    gl.uniform1i(this.uniform('fill'), kFills.indexOf(style.fill));
    gl.uniform2f(this.uniform('light'), theme.shadow, theme.light);
    gl.uniform1f(this.uniform('shaded'), style.shading ? 1 : 0);
    if (!commonDone) this.drawCommon(view.box());
    const [first, number] = map === 0 ? [terrain.common, terrain.before]
                                      : [terrain.common + terrain.before, terrain.after];
    gl.drawArrays(gl.TRIANGLES, 3 * first, 3 * number);
    context.drawImage(canvas, 0, 0);
    return undefined;
  }

  // Chunks in sight; those next to each other in one go.
  drawCommon(box) {
    const {gl} = this;
    let first = -1;
    const draw = (end) => {
      if (first >= 0) gl.drawArrays(gl.TRIANGLES, 3 * first, 3 * (end - first));
      first = -1;
    };
    for (const chunk of this.chunks) {
      const seen = chunk.left <= box.right && chunk.right >= box.left && chunk.bottom <= box.top && chunk.top >= box.bottom;
      if (seen && first < 0) first = chunk.first;
      if (!seen) draw(chunk.first);
    }
    draw(this.terrain.common);
  }

  paintByHand(context, map, view, width, height, style, theme) {
    const {terrain} = this;
    const ramp = theme.ramp.map(rgb), basins = theme.basins.map(rgb), orders = theme.orders.map(rgb);
    context.lineWidth = 0.7;
    terrain.grid.forEach(view.box(), (t) => {
      if (!terrain.shows(map, t)) return;
      const [a, b, c] = terrain.corners.subarray(3 * t, 3 * t + 3);
      const at = ((terrain.level[a] + terrain.level[b] + terrain.level[c]) / 3) * 5;
      const i = Math.min(4, Math.floor(at));
      const base = style.fill === 'elevation' ? ramp[i].map((low, k) => low + (at - i) * (ramp[i + 1][k] - low))
          : style.fill === 'basins' ? basins[this.basins[map][t]]
          : style.fill === 'orders' ? orders[Math.min(5, terrain.order(t))] : orders[0];
      const light = style.shading ? theme.shadow + (theme.light - theme.shadow) * (terrain.shade[t] / 255) : 1;
      context.fillStyle = `rgb(${base.map((value) => Math.min(255, Math.round(255 * value * light))).join(' ')})`;
      context.strokeStyle = context.fillStyle;
      context.beginPath();
      for (const v of [a, b, c]) {
        const [px, py] = view.toScreen(terrain.x[v], terrain.y[v]);
        context.lineTo(px * view.ratio, py * view.ratio);
      }
      context.closePath();
      context.fill();
      context.stroke();
    });
  }
}

// Triangles of both maps come along a space-filling curve: runs of them lie close together.
function chunksOf(terrain) {
  const length = 4096;
  const chunks = [];
  for (let first = 0; first < terrain.common; first += length) {
    const chunk = {first, left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
    for (let i = 3 * first; i < 3 * Math.min(first + length, terrain.common); ++i) {
      const v = terrain.corners[i];
      chunk.left = Math.min(chunk.left, terrain.x[v]);
      chunk.right = Math.max(chunk.right, terrain.x[v]);
      chunk.bottom = Math.min(chunk.bottom, terrain.y[v]);
      chunk.top = Math.max(chunk.top, terrain.y[v]);
    }
    chunks.push(chunk);
  }
  return chunks;
}

const kSmoothTriangles = 200000;
const kFills = ['elevation', 'basins', 'orders', 'none'];

// Decodes the geometry; src/io/report_payload.hpp says how it was packed.

// Base64 of a zlib stream -> Uint8Array.
async function inflate(text) {
  const binary = atob(text);
  const packed = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) packed[i] = binary.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class PayloadReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  floats(length) {
    const {bytes, at} = this;
    const words = new Uint32Array(length);
    for (let plane = 0; plane < 4; ++plane) {
      const from = at + plane * length;
      for (let i = 0; i < length; ++i) words[i] |= bytes[from + i] << (8 * plane);
    }
    this.at += 4 * length;
    return new Float32Array(words.buffer);
  }

  unsigned() {
    let value = 0;
    let factor = 1;
    for (;;) {
      const byte = this.bytes[this.at++];
      value += (byte & 0x7f) * factor;
      if (byte < 0x80) return value;
      factor *= 128;
    }
  }

  signed() {
    const value = this.unsigned();
    return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }

  triangles(length) {
    const corners = new Uint32Array(3 * length);
    let last = 0;
    for (let i = 0; i < 3 * length; i += 3) {
      last += this.unsigned();
      corners[i] = last;
      corners[i + 1] = last + this.unsigned();
      corners[i + 2] = last + this.unsigned();
    }
    return corners;
  }
}

const kNoVertex = 0xffffffff;

async function decodePayload(text, drawn) {
  const reader = new PayloadReader(await inflate(text));
  const n = drawn.vertices;
  const result = {x: reader.floats(n), y: reader.floats(n), z: reader.floats(n)};
  result.names = new Uint32Array(n);
  for (let i = 0, last = 0; i < n; ++i) result.names[i] = last += reader.signed();
  result.common = reader.triangles(drawn.common);
  result.before = reader.triangles(drawn.before);
  result.after = reader.triangles(drawn.after);
  result.afterOrder = new Uint32Array(drawn.after);
  for (let i = 0; i < drawn.after; ++i) result.afterOrder[i] = reader.unsigned();
  const before = new Uint32Array(n);
  const step = (v) => {
    const move = reader.signed();
    return move === 0 ? kNoVertex : v + move;
  };
  for (let v = 0; v < n; ++v) before[v] = step(v);
  const after = before.slice();
  for (let i = 0, v = 0; i < drawn.changed_flows; ++i) {
    v += reader.unsigned();
    after[v] = step(v);
  }
  result.downstream = [before, after];
  return result;
}

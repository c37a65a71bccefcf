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

  // A copy: the rest of the bytes need not stay.
  piece(length) {
    const from = this.at;
    this.at += length;
    return this.bytes.slice(from, this.at);
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
  result.axes = ['x', 'y', 'z'].map((axis) =>
    new ExactAxis(drawn[axis], result[axis], reader.piece(n * (drawn[axis].bytes ?? 0))));
  return result;
}

// Coordinates bit for bit, from floats and what they left out; src/io/report_residual.hpp says how.
class ExactAxis {
  constructor(frame, floats, residuals) {
    Object.assign(this, {frame, floats, residuals});
  }

  get known() {
    return this.frame.bytes !== null;
  }

  // Of a vertex; rounded to a float if the rest is not known.
  at(vertex) {
    const {origin, unit, steps} = this.frame;
    const near = origin + this.floats[vertex] * unit;
    if (!this.known) return near;
    const folded = this.residual(vertex);
    const residual = folded % 2n === 1n ? -(folded + 1n) / 2n : folded / 2n;
    if (steps > 0) return (Math.floor(near * steps + 0.5) + Number(residual)) / steps;
    return fromRank(BigInt.asUintN(64, toRank(near) + residual));
  }

  residual(vertex) {
    let value = 0n;
    for (let plane = this.frame.bytes - 1; plane >= 0; --plane) {
      value = value * 256n + BigInt(this.residuals[plane * this.floats.length + vertex]);
    }
    return value;
  }
}

// Doubles numbered upwards, one after the other.
const kWord = new DataView(new ArrayBuffer(8));
const kSignBit = 1n << 63n;

function toRank(value) {
  kWord.setFloat64(0, value);
  const bits = kWord.getBigUint64(0);
  return bits >= kSignBit ? BigInt.asUintN(64, ~bits) : bits + kSignBit;
}

function fromRank(rank) {
  kWord.setBigUint64(0, rank >= kSignBit ? rank - kSignBit : BigInt.asUintN(64, ~rank));
  return kWord.getFloat64(0);
}

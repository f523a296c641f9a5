/** Small glTF files made in place, good ones and hostile ones. */

const kFloat = 5126;
const kUnsignedShort = 5123;

/** A tetrahedron. */
const kPositions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
const kCorners = Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);

const inUri = (bytes) => `data:application/octet-stream;base64,${Buffer.from(bytes).toString('base64')}`;

/** The bytes of typed arrays, one after the other. */
const bytesOf = (...arrays) => Buffer.concat(arrays.map(({ buffer }) => Buffer.from(buffer)));

export function encode(json) {
  return new TextEncoder().encode(JSON.stringify(json));
}

/** A tetrahedron; `change` may spoil the file before it is written. */
export function rock(change = () => {}) {
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'rock', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: kFloat, type: 'VEC3', count: 4 },
      { bufferView: 1, componentType: kUnsignedShort, type: 'SCALAR', count: 12 },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    buffers: [{ byteLength: 72, uri: inUri(bytesOf(kPositions, kCorners)) }],
  };
  change(gltf);
  return encode(gltf);
}

/** A rock whose vertices follow a joint at `translation` with this weight. */
export function skinnedRock({ weight = 1, translation = [0, 0, 0] } = {}) {
  const weights = Float32Array.from({ length: 16 }, (_, i) => (i % 4 === 0 ? weight : 0));
  return rock((gltf) => {
    gltf.scenes[0].nodes.push(1);
    gltf.nodes[0].skin = 0;
    gltf.nodes.push({ name: 'joint', translation });
    gltf.skins = [{ joints: [1] }];
    gltf.buffers.push({ byteLength: 64, uri: inUri(weights.buffer) });
    gltf.bufferViews.push({ buffer: 1, byteLength: 64 });
    gltf.accessors.push(
      { componentType: kUnsignedShort, type: 'VEC4', count: 4 },
      { bufferView: 2, componentType: kFloat, type: 'VEC4', count: 4 },
    );
    Object.assign(gltf.meshes[0].primitives[0].attributes, { JOINTS_0: 2, WEIGHTS_0: 3 });
  });
}

/**
 * Stones that are attached to nodes of their own: a tetrahedron for each name, a step apart along x. In
 * the clip "roll", all but the first come half a step nearer within a second.
 */
export function rocks(names, step = 0.4) {
  const floats = Float32Array.from([
    ...kPositions,
    0, 1, // seconds
    ...names.flatMap((_, i) => [i * step, 0, 0, i * step - (i > 0 ? step / 2 : 0), 0, 0]),
  ]);
  const bytes = bytesOf(floats, kCorners);
  const accessors = [
    { bufferView: 0, componentType: kFloat, type: 'VEC3', count: 4 },
    { bufferView: 1, componentType: kUnsignedShort, type: 'SCALAR', count: 12 },
    { bufferView: 0, byteOffset: 48, componentType: kFloat, type: 'SCALAR', count: 2, min: [0], max: [1] },
    ...names.map((_, i) => ({
      bufferView: 0, byteOffset: 56 + 24 * i, componentType: kFloat, type: 'VEC3', count: 2,
    })),
  ];
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: names.map((_, i) => i) }],
    nodes: names.map((name, i) => ({ name, mesh: 0, translation: [i * step, 0, 0] })),
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    animations: [{
      name: 'roll',
      samplers: names.map((_, i) => ({ input: 2, output: 3 + i })),
      channels: names.map((_, node) => ({ sampler: node, target: { node, path: 'translation' } })),
    }],
    accessors,
    bufferViews: [
      { buffer: 0, byteLength: floats.byteLength },
      { buffer: 0, byteOffset: floats.byteLength, byteLength: 24 },
    ],
    buffers: [{ byteLength: bytes.length, uri: inUri(bytes) }],
  };
  return encode(gltf);
}

/** A file of `bytes` bytes that declares these numbers of vertices and triangles, all zero. */
export function zeros({ bytes, vertices, triangles }) {
  return encode({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { componentType: kFloat, type: 'VEC3', count: vertices },
      { componentType: 5125, type: 'SCALAR', count: 3 * triangles },
    ],
    extras: 'x'.repeat(bytes),
  });
}

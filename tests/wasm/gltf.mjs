/** Small glTF files made in place, good ones and hostile ones. */

const kFloat = 5126;
const kUnsignedShort = 5123;

export function encode(json) {
  return new TextEncoder().encode(JSON.stringify(json));
}

/** A tetrahedron; `change` may spoil the file before it is written. */
export function rock(change = () => {}) {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const corners = Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
  const bytes = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(corners.buffer)]);
  const uri = `data:application/octet-stream;base64,${bytes.toString('base64')}`;
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
    buffers: [{ byteLength: 72, uri }],
  };
  change(gltf);
  return encode(gltf);
}

/** A rock whose vertices follow a joint at `translation` with this weight. */
export function skinnedRock({ weight = 1, translation = [0, 0, 0] } = {}) {
  const weights = Float32Array.from({ length: 16 }, (_, i) => (i % 4 === 0 ? weight : 0));
  const uri = `data:application/octet-stream;base64,${Buffer.from(weights.buffer).toString('base64')}`;
  return rock((gltf) => {
    gltf.scenes[0].nodes.push(1);
    gltf.nodes[0].skin = 0;
    gltf.nodes.push({ name: 'joint', translation });
    gltf.skins = [{ joints: [1] }];
    gltf.buffers.push({ byteLength: 64, uri });
    gltf.bufferViews.push({ buffer: 1, byteLength: 64 });
    gltf.accessors.push(
      { componentType: kUnsignedShort, type: 'VEC4', count: 4 },
      { bufferView: 2, componentType: kFloat, type: 'VEC4', count: 4 },
    );
    Object.assign(gltf.meshes[0].primitives[0].attributes, { JOINTS_0: 2, WEIGHTS_0: 3 });
  });
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

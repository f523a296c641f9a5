/** A handmade character: stones that are attached to nodes of their own and roll. */

const kCorners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const kTriangles = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

/** The .gltf file: a tetrahedron for each name, a step apart along x; in the clip "roll" all but the
 * first come half a step nearer within a second. */
export function rocks(names, step = 0.4) {
  const floats = Float32Array.from([
    ...kCorners,
    0, 1, // seconds
    ...names.flatMap((_, i) => [i * step, 0, 0, i * step - (i > 0 ? step / 2 : 0), 0, 0]),
  ]);
  const bytes = Buffer.concat([Buffer.from(floats.buffer), Buffer.from(Uint16Array.from(kTriangles).buffer)]);
  const accessors = [
    { bufferView: 0, componentType: 5126, type: 'VEC3', count: 4 },
    { bufferView: 1, componentType: 5123, type: 'SCALAR', count: 12 },
    { bufferView: 0, byteOffset: 48, componentType: 5126, type: 'SCALAR', count: 2, min: [0], max: [1] },
    ...names.map((_, i) => ({
      bufferView: 0, byteOffset: 56 + 24 * i, componentType: 5126, type: 'VEC3', count: 2,
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
    buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}` }],
  };
  return Buffer.from(JSON.stringify(gltf));
}

// Skinned and animated characters as files, in the forms that artists use.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { MeshoptEncoder } from 'meshoptimizer/encoder';

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const COMPRESSION = 'EXT_meshopt_compression';

/** A .glb with the clips "walk" and "idle", one part and 45 joints; 'body' or 'coat'. */
export function character(name) {
  return readFileSync(path.join(process.env.PELT_MODELS, `${name}.glb`));
}

/** The same character, whose upper and lower triangles have different materials. */
export function inTwoParts(glb) {
  const { json, bin } = split(glb);
  const [mesh] = json.meshes;
  const [whole] = mesh.primitives;
  const { count, ...indices } = json.accessors[whole.indices];
  const half = 3 * Math.floor(count / 6);
  mesh.primitives = [
    { first: 0, count: half, name: 'cloth' },
    { first: half, count: count - half, name: 'skin' },
  ].map(({ first, count, name }) => {
    json.accessors.push({ ...indices, count, byteOffset: 4 * first });
    json.materials.push({ name });
    return { ...whole, indices: json.accessors.length - 1, material: json.materials.length - 1 };
  });
  return joined(json, bin);
}

/** The same character, whose weights sum to 0.9. */
export function withLightWeights(glb) {
  const { json, bin } = split(glb);
  const [{ attributes }] = json.meshes[0].primitives;
  const { bufferView, count } = json.accessors[attributes.WEIGHTS_0];
  const begin = json.bufferViews[bufferView].byteOffset ?? 0;
  for (let i = 0; i < 4 * count; ++i) {
    const place = begin + 4 * i;
    bin.writeFloatLE(0.9 * bin.readFloatLE(place), place);
  }
  return joined(json, bin);
}

/** NAME.gltf and NAME.bin beside it. */
export function inTwoFiles(glb, name) {
  const { json, bin } = split(glb);
  json.buffers[0].uri = `${name}.bin`;
  return [
    { name: `${name}.gltf`, bytes: Buffer.from(JSON.stringify(json)) },
    { name: `${name}.bin`, bytes: bin },
  ];
}

/** The same character, compressed like the output of `gltfpack -c`. */
export async function compressed(glb) {
  await MeshoptEncoder.ready;
  const { json, bin } = split(glb);
  const pieces = [];
  let length = 0;
  json.bufferViews.forEach((view, index) => {
    const { count, stride, mode } = layoutOf(json, view, index);
    const begin = view.byteOffset ?? 0;
    const source = bin.subarray(begin, begin + count * stride);
    const piece = MeshoptEncoder.encodeGltfBuffer(source, count, stride, mode);
    const place = { buffer: 0, byteOffset: length, byteLength: piece.length };
    view.extensions = { [COMPRESSION]: { ...place, byteStride: stride, count, mode } };
    view.buffer = 1;
    pieces.push(piece, Buffer.alloc(padding(piece.length)));
    length += piece.length + padding(piece.length);
  });
  json.extensionsUsed = json.extensionsRequired = [COMPRESSION];
  const fallback = { byteLength: bin.length, extensions: { [COMPRESSION]: { fallback: true } } };
  json.buffers = [{ byteLength: length }, fallback];
  return joined(json, Buffer.concat(pieces));
}

const SIZES = { 5123: 2, 5125: 4, 5126: 4 };
const WIDTHS = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 };

/** Layout of a view: of one accessor, or of triangles. */
function layoutOf(json, view, index) {
  const { componentType, type } = json.accessors.find(({ bufferView }) => bufferView === index);
  const stride = SIZES[componentType] * WIDTHS[type];
  const isTriangles = componentType === 5125;
  return {
    count: view.byteLength / stride,
    stride,
    mode: isTriangles ? 'TRIANGLES' : 'ATTRIBUTES',
  };
}

function split(glb) {
  const length = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + length).toString());
  return { json, bin: glb.subarray(20 + length + 8) };
}

function joined(json, bin) {
  const text = Buffer.from(JSON.stringify(json));
  const chunks = Buffer.concat([chunk(JSON_CHUNK, text, ' '), chunk(BIN_CHUNK, bin, '\0')]);
  const header = Buffer.alloc(12);
  [MAGIC, 2, 12 + chunks.length].forEach((word, i) => header.writeUInt32LE(word, 4 * i));
  return Buffer.concat([header, chunks]);
}

function chunk(type, data, filler) {
  const header = Buffer.alloc(8);
  header.writeUInt32LE(data.length + padding(data.length), 0);
  header.writeUInt32LE(type, 4);
  return Buffer.concat([header, data, Buffer.alloc(padding(data.length), filler)]);
}

function padding(length) {
  return (4 - (length % 4)) % 4;
}

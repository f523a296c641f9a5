/** Reads the work of the last query. */
export function readStats(memory) {
  return {
    nodePairs: memory.field('nodePairs'),
    refits: memory.field('refits'),
    posedVertices: memory.field('posedVertices'),
    trianglePairs: memory.field('trianglePairs'),
    displacements: memory.field('displacements'),
    clampedOffsets: memory.field('clampedOffsets'),
    cutShort: memory.field('cutShort') !== 0,
  };
}

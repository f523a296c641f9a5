/** Reads the work of the last query. */
export function readStats(memory) {
  const [nodePairs, refits, posedVertices, trianglePairs, displacements, cutShort] =
    memory.numbers(0, 6);
  return {
    nodePairs,
    refits,
    posedVertices,
    trianglePairs,
    displacements,
    cutShort: cutShort !== 0,
  };
}

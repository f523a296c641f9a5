/** Numbers in words, as the command writes them. */

export function withCommas(count: number): string {
  return count.toLocaleString('en');
}

/** "1 frame", "1,279 frames" */
export function counted(count: number, noun: string): string {
  return `${withCommas(count)} ${noun}${count === 1 ? '' : 's'}`;
}

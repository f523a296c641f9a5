/** Colours of the picture. Colours of the panels are in style/tokens.css. */

export const ACCENT = 0xff6a2b;
/** For contacts of characters with themselves. */
export const SELF_ACCENT = 0xc23bf0;

/** For the segments between closest points. */
export const CLOSEST = 0x35e0d0;

/** Colours of the handles. */
export const AXES = { x: 0xd64550, y: 0x4fa35f, z: 0x4a7fd6 };

const BODIES = [
  0x6b93a8, 0xd9bd95, 0x8a9a74, 0xa58498, 0x7f86b5, 0xb98f72, 0x5f9c95, 0xc9a3ad, 0xa9a45f,
  0x8c8f97,
];

export function bodyColour(instance: number): number {
  return BODIES[instance % BODIES.length];
}

export function cssColour(colour: number): string {
  return `#${colour.toString(16).padStart(6, '0')}`;
}

/** Text colour for a background colour. */
export function inkOn(colour: number): string {
  const [r, g, b] = [16, 8, 0].map((shift) => (colour >> shift) & 255);
  return 0.3 * r + 0.59 * g + 0.11 * b > 130 ? '#14181d' : '#ffffff';
}

/** Kavan & Zara's figure 5: what was refitted, and what did not have to be. */
export const UNTOUCHED = 0xe0483e;
export const REFITTED = 0x7fb2ff;
export const OPENED = 0x2f6fed;

export interface Ambience {
  sky: number;
  earth: number;
  ambient: number;
  surroundings: number;
  key: number;
  rim: number;
  shadow: number;
  lines: number;
  lineOpacity: number;
}

export const DARK: Ambience = {
  sky: 0xbfd0e6,
  earth: 0x2b2622,
  ambient: 0.5,
  surroundings: 0.45,
  key: 2.2,
  rim: 1.8,
  shadow: 0.42,
  lines: 0x8fa3b8,
  lineOpacity: 0.3,
};

export const LIGHT: Ambience = {
  sky: 0xffffff,
  earth: 0xb9aea0,
  ambient: 0.8,
  surroundings: 0.6,
  key: 2.2,
  rim: 0.6,
  shadow: 0.2,
  lines: 0x52606e,
  lineOpacity: 0.28,
};

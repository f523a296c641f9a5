import { checkedFrames, rangeInWords } from '../state/frames';
import { counted } from '../words';
import type { PanelProps } from './panel_props';

/** Says in one sentence what is looked at. */
export function Lead({ state }: PanelProps) {
  const { scene, by, firstContact } = state;
  if (!scene) return null;
  const range = checkedFrames(state);
  const frames = range ? `frames ${rangeInWords(range)}` : counted(scene.frameCount, 'frame');
  const thing = by === 'part' ? 'part' : 'character';
  const what = firstContact
    ? `the first pair of triangles in which two ${thing}s intersect`
    : `every triangle of one ${thing} that intersects another ${thing}`;
  return (
    <p class="lead">
      Orange marks {what}, in {frames} of <b>{scene.name}</b>.
    </p>
  );
}

import { isOneBody } from '../scene/self';
import { checkedFrames, rangeInWords } from '../state/frames';
import { asksPairs, asksSelf } from '../state/shots';
import { asksBetween } from '../state/steps';
import { counted } from '../words';
import type { PanelProps } from './panel_props';

/** Says in a sentence or two what is looked at. */
export function Lead({ state }: PanelProps) {
  const { scene, by, characters, maxContacts, clearance, budget } = state;
  if (!scene) return null;
  const range = checkedFrames(state);
  const frames = range ? `frames ${rangeInWords(range)}` : counted(scene.frameCount, 'frame');
  const thing = by === 'part' ? 'part' : 'character';
  const marks = [
    ...(asksPairs(state) && !isOneBody({ scene, by, characters })
      ? [ofPairs(thing, maxContacts, clearance)]
      : []),
    ...(asksSelf(state) ? [ofSelf(thing, maxContacts)] : []),
  ];
  return (
    <p class="lead">
      {budget !== null && 'As far as the budget suffices, '}
      {(budget === null ? capital : String)(marks.join('; ') || `No ${thing} is tested`)}, in{' '}
      {frames} of <b>{scene.name}</b>
      {asksBetween(state) && ', and in the steps between them'}.
    </p>
  );
}

function ofPairs(thing: string, maxContacts: number | null, clearance: number | null): string {
  if (clearance !== null) return ofNearPairs(thing, maxContacts, clearance);
  return maxContacts !== null
    ? `orange marks at most ${counted(maxContacts, 'contact')} of each pair of ${thing}s`
    : `orange marks every triangle of one ${thing} that intersects another ${thing}`;
}

function ofNearPairs(thing: string, maxContacts: number | null, clearance: number): string {
  return maxContacts !== null
    ? `orange marks at most ${counted(maxContacts, 'pair')} of triangles at most ${clearance} apart, of each pair of ${thing}s`
    : `orange marks every triangle of one ${thing} that is at most ${clearance} from another ${thing}`;
}

function ofSelf(thing: string, maxContacts: number | null): string {
  return maxContacts !== null
    ? `violet marks at most ${counted(maxContacts, 'contact')} of each ${thing} with itself`
    : `violet marks every triangle that intersects its own ${thing}`;
}

function capital(words: string): string {
  return words[0].toUpperCase() + words.slice(1);
}

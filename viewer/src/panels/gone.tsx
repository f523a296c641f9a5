import type { GoneTouch, KnownName } from '../report/report';
import { matches } from '../state/listing';
import { counted } from '../words';
import { useFew } from './few';

/** Number of rows, unless all are shown. */
const FEW = 40;

/** Contacts of the baseline that the check did not find. */
export function Gone({ gone, words }: { gone: readonly GoneTouch[]; words: string }) {
  const listed = gone.filter(({ a, b }) => matches(words, `${nameOf(a)} ${nameOf(b)}`));
  const { shown, more } = useFew(listed, FEW);
  if (listed.length === 0) return <p class="nothing quiet">No contact is gone.</p>;
  return (
    <ol class="touches gone">
      {shown.map(({ a, b, known }) => (
        <li title={`${counted(known, 'contact')} in the worst frame of the baseline`}>
          <span>{nameOf(a)}</span>
          <span>{nameOf(b)}</span>
          <span class="count">was {known}</span>
        </li>
      ))}
      {more && <li>{more}</li>}
    </ol>
  );
}

function nameOf({ model, copy, part = '', joint }: KnownName): string {
  return [model, copy > 0 ? `(${copy})` : '', part, joint].filter((word) => word !== '').join(' ');
}

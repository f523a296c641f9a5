import { comparedAnswer, comparisonOf } from '../report/baseline';
import { filterBy } from '../state/changes';
import type { Filter } from '../state/state';
import { withCommas } from '../words';
import { Badge } from './badge';
import type { PanelProps } from './panel_props';

/** Restricts the list of contacts. */
export function Filters({ state, update }: PanelProps) {
  const { words, pair } = state.filter;
  return (
    <div class="filters">
      <input
        type="search"
        placeholder="Search joints, parts, characters"
        aria-label="Search contacts"
        value={words}
        onInput={({ currentTarget }) => update(filterBy({ words: currentTarget.value }))}
      />
      {pair && (
        <button
          class="chip"
          title="List all pairs"
          onClick={() => update(filterBy({ pair: null }))}
        >
          only <Badge instance={pair[0]} /> and <Badge instance={pair[1]} /> ×
        </button>
      )}
      <Standings state={state} update={update} />
    </div>
  );
}

/** Shown beside a baseline. */
function Standings({ state, update }: PanelProps) {
  const answer = comparedAnswer(state);
  const comparison = answer && comparisonOf(answer);
  if (!comparison) return null;
  const { fresh, grown, known, gone } = comparison;
  const choices: [Filter['standing'], number][] = [
    ['new', fresh],
    ['grown', grown],
    ['known', known],
    ['gone', gone],
  ];
  return (
    <div class="choice" role="group" aria-label="Beside the baseline">
      {choices.map(([standing, count]) => (
        <button
          aria-pressed={state.filter.standing === standing}
          onClick={() =>
            update(filterBy({ standing: state.filter.standing === standing ? null : standing }))
          }
        >
          {`${withCommas(count)} ${standing}`}
        </button>
      ))}
    </div>
  );
}

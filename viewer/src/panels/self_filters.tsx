import type { LeftOut } from 'pelt';
import { keepOrDrop, MOST_RINGS, selfRules, USUAL_SHARE } from '../scene/self';
import { chooseSelf, toggleSelfFilters } from '../state/changes';
import type { State } from '../state/state';
import { withCommas } from '../words';
import { NumberField } from './number_field';
import type { PanelProps } from './panel_props';

/** Filters of contacts of characters with themselves, named as in the command; folded at first. */
export function SelfFilters({ state, update }: PanelProps) {
  const { scene, self, areSelfFiltersOpen } = state;
  const leftOut = listedLeftOut(state);
  return (
    <div class="self-filters">
      <button
        class="link"
        aria-expanded={areSelfFiltersOpen}
        title="Contacts of a character with itself that do not count"
        onClick={() => update(toggleSelfFilters)}
      >
        Filters
      </button>
      <span class="quiet">
        {leftOut && (
          <>
            : <span data-fact="dropped">{withCommas(totalOf(leftOut))}</span> dropped
          </>
        )}
      </span>
      {areSelfFiltersOpen && scene && (
        <Fields rules={selfRules({ scene, self })} leftOut={leftOut} update={update} />
      )}
    </div>
  );
}

/** Of the frame or of the whole clip, like the list; null if not known yet. */
function listedLeftOut({ listing, sweep, answer }: State): LeftOut | null {
  if (listing === 'clip') return sweep.total && sweep.total.leftOut;
  return answer && !answer.isPreliminary ? answer.leftOut : null;
}

function totalOf(leftOut: LeftOut): number {
  return Object.values(leftOut).reduce((sum: number, count: number) => sum + count, 0);
}

interface FieldsProps {
  rules: ReturnType<typeof selfRules>;
  leftOut: LeftOut | null;
  update: PanelProps['update'];
}

function Fields({ rules, leftOut, update }: FieldsProps) {
  const { rings, dropsAtRest, always, dropsNearJoints } = rules;
  const onEnd = () => {};
  return (
    <div class="fields">
      <NumberField
        label="rings"
        title={
          '1: triangles that share a corner do not count; K: nor do triangles that a chain of at ' +
          'most K − 1 others connects; 0: all count'
        }
        step={1}
        least={0}
        most={MOST_RINGS}
        value={rings}
        onEnd={onEnd}
        onChange={(value) => update(chooseSelf({ rings: Math.round(value) }))}
      />
      <KeepOrDrop
        label="at rest"
        title="Triangles that touch in the rest pose or in the default pose"
        drops={dropsAtRest}
        onChange={(drops) => update(chooseSelf({ dropsAtRest: drops }))}
      />
      <KeepOrDrop
        label="near joints"
        title="Triangles that follow the same joint, or neighbouring joints near the joint"
        drops={dropsNearJoints}
        onChange={(drops) => update(chooseSelf({ dropsNearJoints: drops }))}
      />
      <KeepOrDrop
        label="always"
        title="Triangles that touch in nearly all frames"
        drops={always !== null}
        onChange={(drops) => update(chooseSelf({ always: drops ? USUAL_SHARE : null }))}
      />
      {[leftOut?.rings, leftOut?.atRest, leftOut?.joints, leftOut?.always].map((count, i) => (
        <small data-fact={`dropped-${FILTERS[i]}`}>
          {count === undefined ? '–' : withCommas(count)}
        </small>
      ))}
      {always !== null && (
        <NumberField
          label="share of frames"
          title="From this share of the frames on, triangles that touch do not count"
          step={0.01}
          least={0.001}
          most={1}
          value={always}
          onEnd={onEnd}
          onChange={(share) => update(chooseSelf({ always: share }))}
        />
      )}
    </div>
  );
}

/** Order of the numbers. */
const FILTERS = ['rings', 'rest', 'joints', 'always'];

interface KeepOrDropProps {
  label: string;
  title: string;
  drops: boolean;
  onChange: (drops: boolean) => void;
}

function KeepOrDrop({ label, title, drops, onChange }: KeepOrDropProps) {
  return (
    <label title={title}>
      {label}
      <select
        aria-label={label}
        value={keepOrDrop(drops)}
        onChange={({ currentTarget }) => onChange(currentTarget.value === 'drop')}
      >
        <option>drop</option>
        <option>keep</option>
      </select>
    </label>
  );
}

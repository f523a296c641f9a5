import type { ComponentChildren } from 'preact';
import { comparisonOf } from '../report/baseline';
import {
  baselineOf,
  type ClipReport,
  type HeldBody,
  type Report,
  type ReportAnswer,
  type ReportedSelf,
  stepsOf,
} from '../report/report';
import { headlineOf, isAsItCame, worstFrame } from '../report/verdict';
import { canChooseClip, chooseClip, pauseAt } from '../state/changes';
import type { State } from '../state/state';
import { counted, withCommas } from '../words';
import { betweenInWords } from './between';
import { useFew } from './few';
import type { PanelProps } from './panel_props';

/** The result of the command, and whether the page agrees. */
export function ReportPanel({ state, update }: PanelProps) {
  const { report } = state;
  if (!report?.answer) return null;
  const { command, answer } = report;
  return (
    <section class={answer.verdict.failed ? 'report failed' : 'report'} aria-labelledby="report">
      <h2>
        <span id="report">{verdictInWords(answer)}</span>
        <small role="status">{findingInWords(state)}</small>
      </h2>
      <p class="headline">{headlineOf(answer)}</p>
      <Comparison report={report} answer={answer} />
      <BetweenFrames answer={answer} />
      <Held answer={answer} update={update} />
      <Found answer={answer} update={update} />
      <code>{command}</code>
      <Origin report={report} answer={answer} />
    </section>
  );
}

function verdictInWords({ verdict: { failed, fail_on } }: ReportAnswer): string {
  if (failed) return 'Check failed';
  return fail_on === 'never' ? 'Report' : 'Check passed';
}

function findingInWords(state: State): string {
  const { finding, scene } = state;
  if (!scene) return ''; // still reading
  if (isAsItCame(state)) return finding ? `the page ${finding}` : 'counting …';
  return finding ? `the page ${finding}; changed since` : 'changed by you';
}

/** Shown if there is a baseline. */
function Comparison({ report, answer }: { report: Report; answer: ReportAnswer }) {
  const comparison = comparisonOf(answer);
  if (!comparison) return null;
  const { fresh, grown, known, gone, newlyHeld } = comparison;
  return (
    <p class="comparison" title="Comparison with the baseline, by the worst frame of each contact">
      <b>
        {withCommas(fresh)} new, {withCommas(grown)} grown
      </b>
      , {withCommas(known)} as known
      {gone > 0 && `, ${withCommas(gone)} gone`}
      {newlyHeld > 0 && `, ${withCommas(newlyHeld)} newly contained`}
      <small> compared with {baselineOf(report)}</small>
    </p>
  );
}

/** With --between. The steps are in the panel of contacts. */
function BetweenFrames({ answer }: { answer: ReportAnswer }) {
  const steps = stepsOf(answer);
  if (!steps) return null;
  const worse = answer.verdict.between?.worse.length ?? 0;
  return (
    <p class="between-frames">
      {betweenInWords(steps)}
      {worse > 0 && <b>, {withCommas(worse)} new or grown</b>}
    </p>
  );
}

/** Bodies that are wholly inside others, with --inside. */
function Held({
  answer: { held },
  update,
}: {
  answer: ReportAnswer;
  update: PanelProps['update'];
}) {
  if (!held) return null;
  if (held.length === 0) return <p class="held quiet">No body is wholly inside another.</p>;
  return (
    <ul class="held">
      {held.map(({ inner, outer, frames, first_frame: first }) => (
        <li>
          {bodyInWords(inner)} is wholly inside {bodyInWords(outer)} in {counted(frames, 'frame')}
          {', first in '}
          <button class="link" onClick={() => update(pauseAt(first))}>
            frame {first}
          </button>
        </li>
      ))}
    </ul>
  );
}

function bodyInWords({ instance, model, part = '' }: HeldBody['inner']): string {
  return [instance, model, part].filter((word) => word !== '').join(' ');
}

function Found({ answer, update }: { answer: ReportAnswer; update: PanelProps['update'] }) {
  const { totals, hash } = answer;
  const worst = totals.frames > 1 ? worstFrame(answer) : null;
  const dropped = Object.values(totals.left_out ?? {}).reduce((sum, count) => sum + count, 0);
  return (
    <p class="quiet">
      {counted(totals.contacts, 'contact')}
      {worst && (
        <>
          {', most in '}
          <button class="link" onClick={() => update(pauseAt(worst.frame))}>
            frame {worst.frame}: {withCommas(worst.contacts)}
          </button>
        </>
      )}
      {totals.ignored > 0 && `, ${withCommas(totals.ignored)} ignored`}
      {dropped > 0 && `, ${counted(dropped, 'self-contact')} dropped`}
      {hash && (
        <>
          {' · '}
          <code>{hash}</code>
        </>
      )}
    </p>
  );
}

function Origin({ report, answer }: { report: Report; answer: ReportAnswer }) {
  return (
    <details class="origin">
      <summary>Inputs and options</summary>
      <dl>
        {report.inputs.map(({ path, bytes, hash }) => (
          <Row name={path}>
            {bytes !== null && `${counted(bytes, 'byte')} · `}
            <code>{hash}</code>
          </Row>
        ))}
        {optionsOf(report, answer).map(([name, value]) => (
          <Row name={name}>{value}</Row>
        ))}
      </dl>
    </details>
  );
}

function Row({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

/** Options under the names of the command, without default values. */
function optionsOf({ reading, made, pelt }: Report, { options, verdict }: ReportAnswer) {
  const [first, end, step] = options.frames;
  const rows: [string, string][] = [
    ['frames', `${first} to ${end - 1}${step > 1 ? `, step ${step}` : ''}`],
    ['by', options.by],
    ['method', options.method],
    ['fails on', verdict.fail_on],
    ['made', `${made.replace('T', ' ').replace('Z', ' UTC')}, by Pelt ${pelt}`],
  ];
  if (options.max_contacts !== null)
    rows.push(['max-contacts', `${withCommas(options.max_contacts)} per pair and frame`]);
  if (options.clearance !== null) rows.push(['clearance', String(options.clearance)]);
  if (options.budget !== undefined)
    rows.push(['budget', `${counted(options.budget, 'unit')} of work per pair and frame`]);
  if (options.self) rows.push(...selfRows(options.self));
  for (const pair of options.ignore) rows.push(['ignore', pair.join(', ')]);
  for (const note of verdict.notes ?? []) rows.push(['baseline', note]);
  if (reading.renormalise) rows.push(['renormalise', 'weights divided by their sum']);
  if (reading.skinning) rows.push(['skinning', reading.skinning]);
  if (reading.noUnskinned) rows.push(['no-unskinned', 'meshes without a skin left out']);
  for (const node of reading.exclude ?? []) rows.push(['exclude', node]);
  return rows;
}

function selfRows({ only, rings, at_rest, always, near_joints }: ReportedSelf): [string, string][] {
  return [
    ['self', only ? 'only' : 'yes'],
    ['self-rings', String(rings)],
    ['self-at-rest', at_rest],
    ['self-always', String(always)],
    ['self-near-joints', near_joints],
  ];
}

/** Number of rows, unless all are shown. */
const FEW = 8;

/** The clips of a report of all clips, the worst first. A click shows another clip. */
export function ClipsPanel({ state, update }: PanelProps) {
  const { reel, report } = state;
  const clips = [...(reel?.clips ?? [])].sort((a, b) => (b.worst ?? 0) - (a.worst ?? 0));
  const { shown, more } = useFew(clips, FEW);
  if (!canChooseClip(state)) return null;
  return (
    <section aria-labelledby="clips">
      <h2>
        <span id="clips">Clips</span>
        <small>{summaryOf(clips)}</small>
      </h2>
      <ol class="pairs clips">
        {shown.map((clip) => (
          <li>
            <button
              class="touch"
              aria-pressed={clip.report === report}
              title={`Show this clip${clip.worst ? ' at its worst frame' : ''}`}
              onClick={() => update(chooseClip(clip))}
            >
              <span>{clip.clip || 'unnamed'}</span>
              <small>{framesOf(clip)}</small>
              <span class="count">{clip.worst !== null && withCommas(clip.worst)}</span>
            </button>
          </li>
        ))}
        {more && <li>{more}</li>}
      </ol>
    </section>
  );
}

function summaryOf(clips: readonly ClipReport[]): string {
  if (clips.every(({ worst }) => worst === null)) return counted(clips.length, 'clip');
  const inContact = clips.filter(({ worst }) => worst).length;
  return `${inContact} of ${counted(clips.length, 'clip')} in contact`;
}

function framesOf({ framesInContact, report, frameCount }: ClipReport): string {
  const { answer } = report;
  if (!answer) return counted(frameCount, 'frame');
  return `${withCommas(framesInContact ?? 0)} of ${counted(answer.totals.frames, 'frame')}`;
}

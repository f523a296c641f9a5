import type { ComponentChildren } from 'preact';
import type { Report, ReportAnswer } from '../report/report';
import { isAsItCame } from '../report/verdict';
import type { State } from '../state/state';
import type { PanelProps } from './panel_props';

/** What the command found, and whether the page finds the same. */
export function ReportPanel({ state }: PanelProps) {
  const { report } = state;
  if (!report?.answer) return null;
  const { command, answer } = report;
  return (
    <section aria-labelledby="report">
      <h2 id="report">
        Report
        <small role="status">{findingInWords(state)}</small>
      </h2>
      <Verdict answer={answer} />
      <code>{command}</code>
      <Found answer={answer} />
      <Origin report={report} answer={answer} />
    </section>
  );
}

function findingInWords(state: State): string {
  const { finding } = state;
  if (isAsItCame(state)) return finding ? `the page ${finding}` : 'counting …';
  return finding ? `the page ${finding}; changed since` : 'changed by you';
}

/** What makes the check fail, or not. */
function Verdict({ answer: { verdict, touches } }: { answer: ReportAnswer }) {
  const { failed, fail_on, worse, newly_held } = verdict;
  const fresh = worse?.filter(({ known }) => known === 0).length ?? 0;
  return (
    <p class={failed ? 'verdict failed' : 'verdict'}>
      <b>{failed ? 'failed' : 'passed'}</b>
      {worse
        ? ` ${fresh} new, ${worse.length - fresh} grown, ${touches.length - worse.length} known`
        : fail_on === 'never' && ' never fails'}
      {newly_held && newly_held.length > 0 && `, ${newly_held.length} newly held whole`}
    </p>
  );
}

function Found({ answer: { totals, hash } }: { answer: ReportAnswer }) {
  return (
    <p class="quiet">
      {totals.contacts.toLocaleString('en')} contacts in {totals.frames_in_contact} of{' '}
      {totals.frames} frames
      {totals.ignored > 0 && `, ${totals.ignored.toLocaleString('en')} ignored`}
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
            {bytes !== null && `${bytes.toLocaleString('en')} bytes · `}
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

/** By the names of the command; what is as usual is left out. */
function optionsOf({ reading, made, pelt }: Report, { options, verdict }: ReportAnswer) {
  const [first, end, step] = options.frames;
  const rows: [string, string][] = [
    ['frames', `${first} to ${end - 1}${step > 1 ? `, each ${step}.` : ''}`],
    ['by', options.by],
    ['method', options.method],
    ['fails on', verdict.fail_on],
    ['made', `${made.replace('T', ' ').replace('Z', ' UTC')}, by Pelt ${pelt}`],
  ];
  if (options.max_contacts === 1) rows.push(['first', 'one contact of each pair']);
  for (const pair of options.ignore) rows.push(['ignore', pair.join(', ')]);
  for (const note of verdict.notes ?? []) rows.push(['baseline', note]);
  if (reading.renormalise) rows.push(['renormalise', 'weights divided by their sum']);
  if (reading.noUnskinned) rows.push(['no-unskinned', 'meshes without a skin left out']);
  for (const node of reading.exclude ?? []) rows.push(['exclude', node]);
  return rows;
}

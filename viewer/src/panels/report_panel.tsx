import { agrees } from '../report/report';
import type { PanelProps } from './app';

const VERDICTS = { true: 'the page agrees', false: 'the page differs', null: 'counting …' };

/** What the command found, beside what the page finds. */
export function ReportPanel({ state: { report, sweep } }: PanelProps) {
  if (!report?.answer) return null;
  const { command, answer, files } = report;
  const contacts = answer.counts.reduce((sum, count) => sum + count, 0);
  const touched = answer.counts.filter((count) => count > 0).length;
  return (
    <section aria-labelledby="report">
      <h2 id="report">
        Report
        <small class="number" role="status">
          {VERDICTS[`${agrees(answer, sweep.counts)}`]}
        </small>
      </h2>
      <code>{command}</code>
      <p class="quiet">
        {contacts.toLocaleString('en')} contacts in {touched} of {answer.counts.length} frames, from{' '}
        {Object.keys(files).join(', ')}
      </p>
    </section>
  );
}

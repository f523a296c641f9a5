import { agrees } from '../report/report';
import type { PanelProps } from './app';

/** What the command found, beside what the page finds. */
export function ReportPanel({ state: { report, sweep } }: PanelProps) {
  if (!report) return null;
  const { command, answer } = report;
  const verdict = { true: 'the page agrees', false: 'the page differs', null: 'counting …' };
  return (
    <section aria-labelledby="report">
      <h2 id="report">Report</h2>
      <code>{command}</code>
      <p>
        {answer.counts.reduce((sum, count) => sum + count, 0).toLocaleString('en')} contacts in{' '}
        {answer.counts.filter((count) => count > 0).length} of {answer.counts.length} frames:{' '}
        <strong>{verdict[`${agrees(report, sweep.counts)}`]}</strong>
      </p>
    </section>
  );
}

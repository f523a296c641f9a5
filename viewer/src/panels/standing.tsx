import type { Report } from '../report/report';
import { standingOf } from '../report/verdict';
import type { Touch } from '../worker/protocol';

/** What a baseline says of a touch, where the report has one. */
export function Standing({ report, touch }: { report: Report | null; touch: Touch }) {
  const found = report?.answer && standingOf(report.answer, touch);
  if (!found || found.standing === 'known') return null;
  const { standing, then } = found;
  const title = standing === 'new' ? 'Not in the baseline' : `At worst ${then} in the baseline`;
  return (
    <small class={`standing ${standing}`} title={title}>
      {standing}
    </small>
  );
}

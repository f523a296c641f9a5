/** The moment at which the panels are on the screen. */

/** Name of the element that is waited for: the value of its `elementtiming`. */
export const HEAD = 'head';

/** Browsers do not tell of every paint, for example in a hidden tab. */
const LONGEST_MILLISECONDS = 5000;

/** Resolves once the head of the page has been painted. */
export function painted(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, LONGEST_MILLISECONDS);
    if (PerformanceObserver.supportedEntryTypes.includes('element')) {
      new PerformanceObserver(() => resolve()).observe({ type: 'element', buffered: true });
    } else {
      requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve)));
    }
  });
}

import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';

/** The first items of a list, or all of them, and a button that changes this. */
export function useFew<Item>(
  items: readonly Item[],
  few: number,
): { shown: readonly Item[]; more: ComponentChildren } {
  const [areAllShown, showAll] = useState(false);
  const hidden = items.length - few;
  const more = hidden > 0 && (
    <button class="quiet more" onClick={() => showAll(!areAllShown)}>
      {areAllShown ? 'fewer' : `${hidden.toLocaleString('en')} more`}
    </button>
  );
  return { shown: areAllShown ? items : items.slice(0, few), more };
}

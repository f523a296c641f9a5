import type { PanelProps } from './app';
import { Place } from './contacts_panel';

/** Names what is under the pointer. */
export function Hover({ state: { hovered } }: PanelProps) {
  if (!hovered) return null;
  return (
    <div class="hover" role="status">
      <Place surface={hovered} withPart />
    </div>
  );
}

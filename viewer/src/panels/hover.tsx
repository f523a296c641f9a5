import type { PanelProps } from './panel_props';
import { Place } from './place';

/** Names what is under the pointer. */
export function Hover({ state: { hovered } }: PanelProps) {
  if (!hovered) return null;
  return (
    <div class="hover">
      <Place surface={hovered} withPart />
    </div>
  );
}

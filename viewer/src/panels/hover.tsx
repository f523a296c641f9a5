import type { PanelProps } from './app';
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

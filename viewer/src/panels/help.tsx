import { useEffect, useRef } from 'preact/hooks';
import { KEYS } from '../keys';
import type { PanelProps } from './panel_props';

export function Help({ state: { isHelpOpen }, update }: PanelProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (isHelpOpen) dialog.current?.showModal();
    else dialog.current?.close();
  }, [isHelpOpen]);
  return (
    <dialog
      ref={dialog}
      aria-labelledby="keys"
      onClose={() => update(() => ({ isHelpOpen: false }))}
    >
      <h2 id="keys">Keys</h2>
      <dl>
        {KEYS.map(({ shown, meaning }) => (
          <div>
            <dt>
              <kbd>{shown}</kbd>
            </dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
      <form method="dialog">
        <button>Close</button>
      </form>
    </dialog>
  );
}

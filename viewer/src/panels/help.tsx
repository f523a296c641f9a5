import type { ComponentChildren, JSX } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { ACCENT, cssColour, OPENED, REFITTED, SELF_ACCENT, UNTOUCHED } from '../draw/colours';
import { KEYS } from '../keys';
import type { PanelProps } from './panel_props';

export function Help({ state: { isHelpOpen }, update }: PanelProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const close = () => update(() => ({ isHelpOpen: false }));
  useLayoutEffect(() => {
    if (isHelpOpen) dialog.current?.showModal();
    else dialog.current?.close();
  }, [isHelpOpen]);
  return (
    <dialog
      ref={dialog}
      aria-label="Help"
      onCancel={close}
      onClose={({ currentTarget }) => currentTarget.open || close()} // it may be open again
      onClick={(event) => isBeside(event) && close()}
    >
      <h2>What is shown</h2>
      <Shown />
      <h2>Keys</h2>
      <Keys />
      <form method="dialog">
        <button>Close</button>
      </form>
    </dialog>
  );
}

/** Whether a click is on the backdrop. */
function isBeside({ currentTarget, clientX: x, clientY: y }: JSX.TargetedMouseEvent<Element>) {
  const { left, right, top, bottom } = currentTarget.getBoundingClientRect();
  return x < left || x > right || y < top || y > bottom;
}

function Shown() {
  return (
    <ul class="shown">
      <Thing colour={ACCENT} name="Contacts">
        intersecting triangles of two characters, decided exactly; a faint glow if something hides
        them. The bars are the contacts of each frame. The hash beside the total equals the hash of{' '}
        <code>pelt check</code> if and only if all contacts are the same. In a report with{' '}
        <code>--clearance</code>, contacts are the triangles within that distance. In one with{' '}
        <code>--budget</code>, hatched frames may have more contacts.
      </Thing>
      <Thing colour={SELF_ACCENT} name="Self-contacts">
        intersecting triangles of one character. The filters leave out creases, and what touches at
        rest.
      </Thing>
      <Thing name="Between frames">
        with “between frames” on: contacts of a step from one frame to the next that are in neither
        of them. Marks along the upper edge of the timeline show the steps, and the list leads to
        the first time of contact.
      </Thing>
      <Thing colour={OPENED} name="Opened">
        with bounds on: boxes that the query opened. Vertices were skinned only there.
      </Thing>
      <Thing colour={REFITTED} name="Refitted">
        boxes that were computed for this pose but not opened.
      </Thing>
      <Thing colour={UNTOUCHED} name="Untouched">
        boxes that the query never needed.
      </Thing>
      <Thing name="Work">
        the work of the query of this frame, compared with refitting all boxes first.
      </Thing>
    </ul>
  );
}

interface ThingProps {
  name: string;
  colour?: number;
  children: ComponentChildren;
}

function Thing({ name, colour, children }: ThingProps) {
  return (
    <li>
      <i class="dot" style={colour === undefined ? {} : { background: cssColour(colour) }} />
      <p>
        <b>{name}:</b> {children}
      </p>
    </li>
  );
}

function Keys() {
  return (
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
  );
}

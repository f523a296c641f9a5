/** The page around the picture. */

import { HEAD } from '../flow/painted';
import { isOneBody } from '../scene/self';
import { dismiss, toggleHelp, toggleTheme } from '../state/changes';
import { checkedFrames, rangeInWords } from '../state/frames';
import { undo } from '../state/history';
import { asksPairs, asksSelf } from '../state/shots';
import { asksBetween } from '../state/steps';
import { counted } from '../words';
import { CharactersPanel } from './characters_panel';
import { ContactsPanel } from './contacts_panel';
import { Help } from './help';
import type { PanelProps } from './panel_props';
import { PictureBar } from './picture_bar';
import { Place } from './place';
import { ClipsPanel, ReportPanel } from './report_panel';
import { saveScene } from './same_numbers';
import { Timeline } from './timeline';
import { watch } from './watch';
import { WorkPanel } from './work_panel';

/** Each panel rerenders by itself; see `watch`. */
const panels = {
  Header: watch(Header),
  Lead: watch(Lead),
  Report: watch(ReportPanel),
  Clips: watch(ClipsPanel),
  Characters: watch(CharactersPanel),
  Contacts: watch(ContactsPanel),
  Work: watch(WorkPanel),
  PictureBar: watch(PictureBar),
  Timeline: watch(Timeline),
  Hover: watch(Hover),
  Problems: watch(Problems),
  Help: watch(Help),
};

interface AppProps extends PanelProps {
  /** Open a file dialog, to replace the characters or to add some. */
  openFiles: () => void;
  addFiles: () => void;
}

export function App({ state, update, openFiles, addFiles }: AppProps) {
  const contacts = <panels.Contacts key="contacts" state={state} update={update} />;
  const characters = (
    <panels.Characters key="characters" state={state} update={update} addFiles={addFiles} />
  );
  const work = <panels.Work key="work" state={state} update={update} />;
  return (
    <>
      <panels.Header state={state} update={update} openFiles={openFiles} />
      <aside class="side" aria-label="Scene and answers">
        <panels.Lead state={state} update={update} />
        <panels.Report state={state} update={update} />
        <panels.Clips state={state} update={update} />
        {state.report?.answer ? [contacts, characters, work] : [characters, work, contacts]}
      </aside>
      <panels.PictureBar state={state} update={update} />
      <panels.Timeline state={state} update={update} />
      <panels.Hover state={state} update={update} />
      <panels.Problems state={state} update={update} />
      {state.isDropping && <Drop />}
      <panels.Help state={state} update={update} />
    </>
  );
}

function Drop() {
  return (
    <div class="drop">
      Drop .glb files, or a folder with a scene
      <small>hold Shift to add characters to the scene</small>
    </div>
  );
}

/** Names what is under the pointer. */
function Hover({ state: { hovered } }: PanelProps) {
  if (!hovered) return null;
  return (
    <div class="hover">
      <Place surface={hovered} withPart />
    </div>
  );
}

function Problems({ state: { problems }, update }: PanelProps) {
  return (
    <div class="problems" role="alert">
      {problems.map((problem) => (
        <div class="problem">
          <strong>{problem.title}</strong>
          <p>{inWordsOfPage(problem.message)}</p>
          {problem.remedy && (
            <button
              class="remedy"
              onClick={() => (update(dismiss(problem)), problem.remedy!.act())}
            >
              {problem.remedy.label}
            </button>
          )}
          <button class="dismiss" aria-label="Dismiss" onClick={() => update(dismiss(problem))}>
            ×
          </button>
        </div>
      ))}
    </div>
  );
}

/** Without the option of the engine, which the page offers as a button. */
function inWordsOfPage(message: string): string {
  return message.replace(/ \(renormalise: true [^)]*\)/, '');
}

function Header({ state, update, openFiles }: PanelProps & { openFiles: () => void }) {
  const { scene, reading, past } = state;
  return (
    <header class="head">
      <h1 {...{ elementtiming: HEAD }}>Pelt</h1>
      <p class="subject" aria-live="polite" title={scene?.name}>
        {reading ? `reading ${reading} …` : scene?.name}
      </p>
      <nav>
        <button onClick={openFiles} title="Open .glb files, or drop them anywhere">
          Open files
        </button>
        <button
          disabled={!scene}
          onClick={() => saveScene(state)}
          title="Save the scene; `pelt check` gives the same numbers for it"
        >
          Save scene
        </button>
        <button
          disabled={past.length === 0}
          onClick={() => update(undo)}
          title="Undo the last change of the scene (Ctrl+Z)"
        >
          Undo
        </button>
        <button
          onClick={() => update(toggleTheme)}
          title="Dark or light (T)"
          aria-label="Dark or light"
        >
          ◐
        </button>
        <button onClick={() => update(toggleHelp)} title="Help (?)" aria-label="Help">
          ?
        </button>
      </nav>
    </header>
  );
}

/** Says in a sentence or two what is looked at. */
function Lead({ state }: PanelProps) {
  const { scene, by, characters, maxContacts, clearance, budget } = state;
  if (!scene) return null;
  const range = checkedFrames(state);
  const frames = range ? `frames ${rangeInWords(range)}` : counted(scene.frameCount, 'frame');
  const thing = by === 'part' ? 'part' : 'character';
  const marks = [
    ...(asksPairs(state) && !isOneBody({ scene, by, characters })
      ? [ofPairs(thing, maxContacts, clearance)]
      : []),
    ...(asksSelf(state) ? [ofSelf(thing, maxContacts)] : []),
  ];
  return (
    <p class="lead">
      {budget !== null && 'As far as the budget suffices, '}
      {(budget === null ? capital : String)(marks.join('; ') || `No ${thing} is tested`)}, in{' '}
      {frames} of <b>{scene.name}</b>
      {asksBetween(state) && ', and in the steps between them'}.
    </p>
  );
}

function ofPairs(thing: string, maxContacts: number | null, clearance: number | null): string {
  if (clearance !== null) return ofNearPairs(thing, maxContacts, clearance);
  return maxContacts !== null
    ? `orange marks at most ${counted(maxContacts, 'contact')} of each pair of ${thing}s`
    : `orange marks every triangle of one ${thing} that intersects another ${thing}`;
}

function ofNearPairs(thing: string, maxContacts: number | null, clearance: number): string {
  return maxContacts !== null
    ? `orange marks at most ${counted(maxContacts, 'pair')} of triangles at most ${clearance} apart, of each pair of ${thing}s`
    : `orange marks every triangle of one ${thing} that is at most ${clearance} from another ${thing}`;
}

function ofSelf(thing: string, maxContacts: number | null): string {
  return maxContacts !== null
    ? `violet marks at most ${counted(maxContacts, 'contact')} of each ${thing} with itself`
    : `violet marks every triangle that intersects its own ${thing}`;
}

function capital(words: string): string {
  return words[0].toUpperCase() + words.slice(1);
}

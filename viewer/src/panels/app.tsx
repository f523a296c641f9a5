/** The page around the picture. */

import { CharactersPanel } from './characters_panel';
import { ClipsPanel } from './clips_panel';
import { ContactsPanel } from './contacts_panel';
import { Header } from './header';
import { Help } from './help';
import { Hover } from './hover';
import type { PanelProps } from './panel_props';
import { Lead } from './lead';
import { PictureBar } from './picture_bar';
import { Problems } from './problems';
import { ReportPanel } from './report_panel';
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

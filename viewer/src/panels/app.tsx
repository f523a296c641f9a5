/** The page around the picture. */

import { CharactersPanel } from './characters_panel';
import { ContactsPanel } from './contacts_panel';
import { Header } from './header';
import { Help } from './help';
import { Hover } from './hover';
import type { PanelProps } from './panel_props';
import { PictureBar } from './picture_bar';
import { Problems } from './problems';
import { ReportPanel } from './report_panel';
import { Timeline } from './timeline';
import { watch } from './watch';
import { WorkPanel } from './work_panel';

/** Each looks after itself: see `watch`. */
const panels = {
  Header: watch(Header),
  Report: watch(ReportPanel),
  Characters: watch(CharactersPanel),
  Contacts: watch(ContactsPanel),
  Work: watch(WorkPanel),
  PictureBar: watch(PictureBar),
  Timeline: watch(Timeline),
  Hover: watch(Hover),
  Problems: watch(Problems),
  Help: watch(Help),
};

export function App({ state, update, openFiles }: PanelProps & { openFiles: () => void }) {
  return (
    <>
      <panels.Header state={state} update={update} openFiles={openFiles} />
      <aside class="side" aria-label="Scene and answers">
        <panels.Report state={state} update={update} />
        <panels.Characters state={state} update={update} />
        <panels.Contacts state={state} update={update} />
        <panels.Work state={state} update={update} />
      </aside>
      <panels.PictureBar state={state} update={update} />
      <panels.Timeline state={state} update={update} />
      <panels.Hover state={state} update={update} />
      <panels.Problems state={state} update={update} />
      {state.isDropping && <div class="drop">Drop .glb files, or a folder with a scene</div>}
      <panels.Help state={state} update={update} />
    </>
  );
}

/** The page around the picture. */

import type { State, Update } from '../state/state';
import { BoxesPanel } from './boxes_panel';
import { CharactersPanel } from './characters_panel';
import { ContactsPanel } from './contacts_panel';
import { Header } from './header';
import { Help } from './help';
import { Hover } from './hover';
import { Problems } from './problems';
import { ReportPanel } from './report_panel';
import { Timeline } from './timeline';
import { WorkPanel } from './work_panel';

export interface PanelProps {
  state: State;
  update: Update;
}

export function App({ state, update, openFiles }: PanelProps & { openFiles: () => void }) {
  return (
    <>
      <Header state={state} update={update} openFiles={openFiles} />
      <aside class="side" aria-label="Scene and answers">
        <ReportPanel state={state} update={update} />
        <CharactersPanel state={state} update={update} />
        <ContactsPanel state={state} update={update} />
        <WorkPanel state={state} update={update} />
        <BoxesPanel state={state} update={update} />
      </aside>
      <Timeline state={state} update={update} />
      <Hover state={state} update={update} />
      <Problems state={state} update={update} />
      {state.isDropping && <div class="drop">Drop .glb files here</div>}
      <Help state={state} update={update} />
    </>
  );
}

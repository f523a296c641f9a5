/** Wires state, worker, picture and panels. */

import { render } from 'preact';
import { View } from './draw/view';
import { Asker } from './flow/asker';
import { Client } from './flow/client';
import { startClock } from './flow/clock';
import { Director } from './flow/director';
import { chooseFiles, watchDrops } from './flow/drops';
import { Meter } from './flow/meter';
import { Opener } from './flow/open';
import { Photographer } from './flow/photographer';
import { Pointing } from './flow/pointing';
import { watchKeys } from './keys';
import { App } from './panels/app';
import { findReport } from './report/report';
import * as changes from './state/changes';
import { initialState, type State } from './state/state';
import { Store } from './state/store';
import './style.css';
import { isDark, onSystemTheme } from './theme';

const store = new Store<State>(initialState);
const { update } = store;
const client = new Client(
  (progress) => update(changes.sweepOn(progress)),
  (message) => update(changes.refuse('The engine has failed: load the page again', message)),
);
const opener = new Opener(store, client);
const asker = new Asker(store, client);
const pointing = new Pointing(store, asker);
const openFiles = (files: File[]) => opener.openFiles(files);
const chooseAndOpen = () => chooseFiles(openFiles);

const panels = document.getElementById('panels')!;
const view = new View(document.getElementById('view')!, {
  onPlace: (instance, change) => update(changes.changeInstance(instance, change)),
  onPoint: (ray, x, y) => {
    panels.style.setProperty('--x', `${x}px`);
    panels.style.setProperty('--y', `${y}px`);
    void pointing.point(ray);
  },
  onClick: () => update(({ hovered }) => ({ selected: hovered?.instance ?? null })),
});

/** Written only when it changes: the whole page is styled anew by it. */
function wear(theme: 'dark' | 'light'): void {
  const { dataset } = document.documentElement;
  if (dataset.theme !== theme) dataset.theme = theme;
}

function show(state: State): void {
  const dark = isDark(state.theme);
  wear(dark ? 'dark' : 'light');
  document.title = state.scene ? `${state.scene.name} · Pelt` : 'Pelt';
  view.light(dark);
  view.show(state);
  render(<App state={state} update={update} openFiles={chooseAndOpen} />, panels);
}

store.listen(show);
onSystemTheme(() => show(store.state));
new Director(store, asker);
new Meter(store, asker);
new Photographer(store, asker, (answer) => view.photograph(answer));
startClock(store);
watchKeys(update);
watchDrops(update, openFiles);

const report = findReport(document);
if (report) opener.openReport(report);
else opener.openDemo();

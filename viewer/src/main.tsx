/** Wires state, worker, picture and panels. */

import { render } from 'preact';
import { View } from './draw/view';
import { Asker } from './flow/asker';
import { Client } from './flow/client';
import { startClock } from './flow/clock';
import { Director } from './flow/director';
import { chooseFiles, watchDrops, type DroppedFile } from './flow/drops';
import { Meter } from './flow/meter';
import { Opener } from './flow/open';
import { Photographer } from './flow/photographer';
import { Pointing } from './flow/pointing';
import { watchKeys } from './keys';
import { App } from './panels/app';
import { findReport, type Report } from './report/report';
import * as changes from './state/changes';
import { initialState, type State } from './state/state';
import { Store } from './state/store';
import './style/index.css';
import { isDark, keepTheme, keptTheme, onSystemTheme } from './theme';

const store = new Store<State>({ ...initialState, theme: keptTheme() });
const { update } = store;
const client = new Client(
  (progress) => update(changes.sweepOn(progress)),
  (message) => update(changes.refuse('The engine has failed: reload the page', message)),
);
const opener = new Opener(store, client);
const asker = new Asker(store, client);
const pointing = new Pointing(store, asker);
const openFiles = (files: DroppedFile[]) => opener.openFiles(files);
const addFiles = (files: DroppedFile[]) => opener.addFiles(files);
const chooseAndOpen = () => chooseFiles(openFiles);
const chooseAndAdd = () => chooseFiles(addFiles);

const panels = document.getElementById('panels')!;
const view = makeView(document.getElementById('view')!);

/** Returns null without WebGL. Contacts are still counted then. */
function makeView(place: HTMLElement): View | null {
  try {
    return new View(place, {
      onPlace: (instance, change) => update(changes.changeInstance(instance, change)),
      onPoint: (ray, x, y) => {
        panels.style.setProperty('--x', `${x}px`);
        panels.style.setProperty('--y', `${y}px`);
        void pointing.point(ray);
      },
      onClick: (ray) => void pointing.select(ray),
    });
  } catch {
    place.classList.add('without-picture');
    place.textContent =
      'No picture: WebGL is not available in this browser. Contacts are still counted.';
    return null;
  }
}

/** Written only when it changes, because it restyles the whole page. */
function wear(theme: 'dark' | 'light'): void {
  const { dataset } = document.documentElement;
  if (dataset.theme !== theme) dataset.theme = theme;
}

function show(state: State): void {
  const dark = isDark(state.theme);
  wear(dark ? 'dark' : 'light');
  view?.light(dark);
  view?.show(state);
  const choosing = { openFiles: chooseAndOpen, addFiles: chooseAndAdd };
  render(<App state={state} update={update} {...choosing} />, panels);
}

store.listen(show);
store.listen((state, before) => {
  if (state.theme !== before.theme) keepTheme(state.theme);
  if (state.scene?.name !== before.scene?.name) document.title = `${state.scene?.name} · Pelt`;
});
onSystemTheme(() => show(store.state));
new Director(store, asker);
new Meter(store, asker);
if (view) new Photographer(store, asker, (answer, side) => view.photograph(answer, side));
startClock(store);
watchKeys(update);
watchDrops(update, openFiles, addFiles);

try {
  open(findReport(document));
} catch (error) {
  update(() => ({ reading: null }));
  update(changes.refuse('The report in this page cannot be read', (error as Error).message));
}

function open(report: Report | null): void {
  if (report) opener.openReport(report);
  else opener.openDemo();
}

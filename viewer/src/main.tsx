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
import { painted } from './flow/painted';
import { Photographer } from './flow/photographer';
import { Pointing } from './flow/pointing';
import { watchKeys } from './keys';
import { App } from './panels/app';
import { findReport, type Report } from './report/report';
import * as changes from './state/changes';
import { changeInstance } from './state/edits';
import { endEdit } from './state/history';
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
let view: View | null = null;

/** Returns null without WebGL. Contacts are still counted then. */
function makeView(place: HTMLElement): View | null {
  try {
    return new View(place, {
      onPlace: (instance, change) => update(changeInstance(instance, change)),
      onPlaced: () => update(endEdit),
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

/** The style sheets follow the system, unless the user has chosen. */
function wear(theme: State['theme']): void {
  const { dataset } = document.documentElement;
  if (theme === 'system') delete dataset.theme;
  else if (dataset.theme !== theme) dataset.theme = theme; // each change restyles the whole page
}

function show(state: State): void {
  wear(state.theme);
  view?.light(isDark(state.theme));
  view?.show(state);
  const choosing = { openFiles: chooseAndOpen, addFiles: chooseAndAdd };
  render(<App state={state} update={update} {...choosing} />, panels);
}

/** Adds the picture once the panels have been painted, because WebGL may take seconds to start. */
function addView(): void {
  view = makeView(document.getElementById('view')!);
  if (!view) return;
  show(store.state);
  new Photographer(store, asker, view.photograph.bind(view));
}

panels.replaceChildren();
store.listen(show);
store.listen((state, before) => {
  if (state.theme !== before.theme) keepTheme(state.theme);
  if (state.scene?.name !== before.scene?.name) document.title = `${state.scene?.name} · Pelt`;
});
onSystemTheme(() => show(store.state));
new Director(store, asker);
new Meter(store, asker);
startClock(store);
watchKeys(update);
watchDrops(update, openFiles, addFiles);

try {
  open(findReport(document));
} catch (error) {
  update(() => ({ reading: null }));
  update(changes.refuse('The report in this page cannot be read', (error as Error).message));
}

void painted().then(addView);

function open(report: Report | null): void {
  if (report) opener.openReport(report);
  else opener.openDemo();
}

/** Searches for contacts that can be stopped, read and resumed. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readOptions } from './options.mjs';
import { different } from './queries.mjs';
import { readStats } from './stats.mjs';

/** Numbered as in search.hpp. */
const kOrders = ['firstContact', 'resolution', 'contacts'];
const kVerdicts = ['apart', 'touching', 'unknown'];

const kRules = {
  order: (order, name) => check.oneOf(order, kOrders, name),
  maxOpen: (maxOpen, name) => check.count(maxOpen, name, 1, 2 ** 20),
};

export class CollisionSearch {
  #memory;
  #a;
  #b;

  constructor(memory, a, b, options) {
    const { order = kOrders[0], maxOpen = 4096 } = readOptions(memory, options, kRules);
    const poses = different(memory, a, b);
    const made = memory.module._pelt_make_search(...poses, kOrders.indexOf(order), maxOpen);
    this.#memory = memory;
    this.#a = a;
    this.#b = b;
    memory.handles.own(this, made, '_pelt_delete_search', 'search');
  }

  run(budget) {
    const work = budget === Infinity ? budget : check.count(budget, 'budget', 0, 2 ** 53);
    if (this.isStale) {
      throw invalid('a pose has changed since the search was started: call restart()');
    }
    this.#memory.module._pelt_run_search(this.#handle, work);
    return readStats(this.#memory);
  }

  restart() {
    this.#memory.module._pelt_restart_search(this.#handle);
  }

  get isComplete() {
    return this.#memory.module._pelt_search_is_complete(this.#handle) !== 0;
  }

  get isStale() {
    return this.#memory.module._pelt_search_is_stale(this.#handle) !== 0;
  }

  get verdict() {
    return kVerdicts[this.#memory.module._pelt_search_verdict(this.#handle)];
  }

  get undecidedPairs() {
    return this.#memory.module._pelt_search_undecided_pairs(this.#handle);
  }

  get resolution() {
    return this.#memory.module._pelt_search_resolution(this.#handle);
  }

  get distanceBound() {
    return this.#memory.module._pelt_search_distance_bound(this.#handle);
  }

  get workDone() {
    return this.#memory.module._pelt_search_work_done(this.#handle);
  }

  get longestStep() {
    return this.#memory.module._pelt_search_longest_step(this.#handle);
  }

  pairs() {
    this.#memory.module._pelt_search_contacts(this.#handle);
    return this.#memory.data(Uint32Array, 2);
  }

  openRegions() {
    this.#memory.module._pelt_search_regions(this.#handle);
    const rows = this.#memory.data(Float64Array, 1);
    const count = rows.length / 8;
    const column = (begin, width, type) =>
      type.from({ length: count * width }, (_, i) => {
        const row = 8 * Math.floor(i / width);
        return rows[row + begin + (i % width)];
      });
    return {
      count,
      boxes: column(0, 6, Float32Array),
      depths: column(6, 1, Float32Array),
      pairCounts: column(7, 1, Float64Array),
    };
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  /** Throws if a pose has been deleted, which the engine would still read. */
  get #handle() {
    const [handle] = [this, this.#a, this.#b].map((owner) => this.#memory.handles.of(owner));
    return handle;
  }
}

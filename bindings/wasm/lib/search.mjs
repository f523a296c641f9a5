/** Searches for contacts that can be stopped, read and resumed. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readOptions } from './options.mjs';
import { different } from './queries.mjs';

/** Numbered as in search.hpp. */
const kOrders = ['firstContact', 'resolution', 'contacts'];
const kVerdicts = ['apart', 'touching', 'unknown'];

/** Same order as in collide.cpp. */
const kRegionColumns = [
  ['boxes', Float32Array],
  ['depths', Float32Array],
  ['pairCounts', Float64Array],
];

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
    const made = memory.call('make_search', ...poses, kOrders.indexOf(order), maxOpen);
    this.#memory = memory;
    this.#a = a;
    this.#b = b;
    memory.handles.own(this, made, 'delete_search', 'search');
  }

  run(budget) {
    const work = budget === Infinity ? budget : check.count(budget, 'budget', 0, 2 ** 53);
    if (this.isStale) {
      throw invalid('a pose has changed since the search was started: call restart()');
    }
    this.#call('run_search', work);
    return this.#memory.stats();
  }

  restart() {
    this.#call('restart_search');
  }

  get isComplete() {
    return this.#call('search_is_complete') !== 0;
  }

  get isStale() {
    return this.#call('search_is_stale') !== 0;
  }

  get verdict() {
    return kVerdicts[this.#call('search_verdict')];
  }

  get undecidedPairs() {
    return this.#call('search_undecided_pairs');
  }

  get resolution() {
    return this.#call('search_resolution');
  }

  get distanceBound() {
    return this.#call('search_distance_bound');
  }

  get workDone() {
    return this.#call('search_work_done');
  }

  get longestStep() {
    return this.#call('search_longest_step');
  }

  pairs() {
    this.#call('search_contacts');
    return this.#memory.array(Uint32Array);
  }

  openRegions() {
    this.#call('search_regions');
    const columns = this.#memory.arrays(kRegionColumns);
    return { count: columns.depths.length, ...columns };
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  /** Throws if a pose has been deleted, which the engine would still read. */
  #call(name, ...values) {
    for (const owner of [this, this.#a, this.#b]) this.#memory.handles.of(owner);
    return this.#memory.call(name, this, ...values);
  }
}

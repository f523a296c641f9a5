/// `pelt bench`: the cost of each method on a scene, or on a character against itself. Prints no
/// time unless all methods give the same answer.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_run.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <sstream>

namespace pelt::tools::verbs {
namespace {

constexpr const char* kFooter = R"(
Examples:
  pelt bench scene.json
  pelt bench scene.json --methods on_demand,eager --queries first
  pelt bench scene.json --frames 0:60:20 --repeat 15 --json figures.json
  pelt bench scene.json --methods eager,on_demand --threads 1,2
  pelt bench knight.glb --clip Walk
  pelt bench scene.json --self

Each repetition of a frame first runs the previous frame untimed (for the first frame, the last one),
then times setting the palettes and querying all pairs. The time of a frame is the median of its
repetitions; fewer than 9 give a rough measurement. The columns show the mean over all frames, the
mean over the frames in contact, and the 95th percentile. "update" is the time before the queries:
setting the palettes and, for methods that skin all vertices, skinning and refitting. Computing joint
matrices from clips is not timed. "vs paper" and "vs eager" are speed-ups over these methods. The
methods take turns at every frame.

Pairs are queried one by one on one thread, in thread time, which excludes pauses in which the system
runs other programs. With --threads, on_demand runs as a crowd instead, once for each of these numbers
of threads. The threads share the work of querying pairs. Setting the palettes uses one thread for
every 64 palettes. All times of that run are wall times. "vs 1 thread" is the speed-up over a crowd on
one thread.

A model is queried against itself; with --self, so is each instance of a scene. self finds all contacts
that pelt check finds without filters (--self-rings 0, and keep for the others). brute tests all pairs
of triangles. boxes skins all vertices and computes all boxes, and finds nothing. "of boxes" is the cost
of a method over that of boxes. "vs all" is the speed-up of the query first over the query all. The line
"frames in order" compares self with a SelfTracker, while the frames are played in order.

--json writes {"format": "pelt-bench", "version": 1, "machine": {...}, "scenes": [...]}:
  machine    cpu, cores, instruction_set, compiler, build, flags, pelt (version)
  scenes     scene (file), frames, frames_in_contact, repetitions, time (thread or wall)
    models   triangles, bytes, build_seconds: totals, counting each model once; with --self also
             self_filter_bytes, self_filter_build_seconds
    skinning vertices (of all instances), mean_us, ns_per_vertex
    sequence self_us, tracked_us: frames played in order, without and with a SelfTracker; with --self
    methods  method, query, cache (hot), asked (pairs, crowd, self or none), threads, frames
             (timed frames), mean_us, mean_contact_us (null without contact), p95_us, mean_update_us, hash
    counters of a method over all frames: node_pairs, refits, posed_vertices, triangle_pairs, displacements
Names that end in _us are microseconds per frame. pelt(1) describes each field, with an example.

The program pelt-lab, which is not installed, also measures cold caches, steps between frames, searches
that are stopped and methods from other papers, and compares figures with those of an earlier run.)";

Result<std::optional<bench::SceneReport>> measure_scene(const scenes::Scene& scene,
                                                        const bench::BenchSettings& settings,
                                                        std::ostream& errors) {
  const auto figures = bench::bench_scene(scene, settings, errors);
  if (!figures) return figures.error();
  if (!*figures) return std::optional<bench::SceneReport>();
  std::ostringstream text;
  bench::print_figures(**figures, bench::kYardsticks, text);
  return std::optional(bench::SceneReport{bench::scene_json(**figures), text.str()});
}

Result<arguments::ExitCode> run_bench(bench::BenchArguments arguments) {
  if (const auto prepared = bench::prepare_inputs(arguments); !prepared) return prepared.error();
  const auto settings = bench::choose_settings(arguments);
  if (!settings) return settings.error();
  const output::NamedOutput outputs[] = {{"--json", arguments.json}};
  if (const auto checked = bench::check_outputs(arguments, outputs); !checked)
    return checked.error();
  output::OutputFile json;
  if (const auto opened = json.open(arguments.json); !opened) return opened.error();
  std::vector<bench::Row> scenes;
  return bench::measure_inputs(
      arguments, "pelt-bench",
      [&](const scenes::Scene& scene, std::ostream& errors) {
        return measure_scene(scene, *settings, errors);
      },
      json, scenes, output::words_beside({arguments.json}));
}

}  // namespace

void add_bench(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "bench", "Measure the speed of methods on scenes and characters",
                       kFooter);
  const auto arguments = std::make_shared<bench::BenchArguments>();
  arguments->program = verb.program();
  arguments->known = {{methods::kCommandMethods, "paper,eager,on_demand"},
                      {methods::kSelfMethods, "boxes,self"}};
  bench::add_bench_options(verb, *arguments);
  verb.runs([arguments] { return run_bench(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs

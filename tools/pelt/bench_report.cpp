#include "tools/pelt/bench_report.hpp"

#include <pelt/version.hpp>

#include "tools/pelt/jsonl.hpp"
#include "tools/pelt/machine.hpp"
#include "tools/pelt/text.hpp"

#include <iomanip>

namespace pelt::tools {
namespace {

using nlohmann::ordered_json;

constexpr int kColumn = 12;

void print_head(std::ostream& out) {
  out << std::left << std::setw(14) << "method" << std::right;
  for (const char* head : {"mean us", "in contact", "95 %", "update", "query", "x slower"}) {
    out << std::setw(kColumn) << head;
  }
  out << '\n';
}

void print_row(const EngineFigures& figures, double fastest_us, std::ostream& out) {
  const Measurement& m = figures.measurement;
  out << std::left << std::setw(14) << figures.engine << std::right;
  out << std::setw(kColumn) << fixed(m.mean_us, 1) << std::setw(kColumn)
      << (m.frames_in_contact > 0 ? fixed(m.mean_contact_us, 1) : "-");
  for (const double us : {m.p95_us, m.mean_update_us, m.mean_us - m.mean_update_us}) {
    out << std::setw(kColumn) << fixed(us, 1);
  }
  out << std::setw(kColumn) << fixed(m.mean_us / fastest_us, 2) << '\n';
}

void print_work(const EngineFigures& figures, std::ostream& out) {
  const QueryStats& work = figures.measurement.work;
  out << std::left << std::setw(14) << figures.engine << std::right;
  for (const std::uint64_t count :
       {work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs}) {
    const double frames = static_cast<double>(figures.measurement.frames);
    out << std::setw(16) << fixed(static_cast<double>(count) / frames, 1);
  }
  out << '\n';
}

ordered_json engine_json(const EngineFigures& figures, const BenchSettings& settings) {
  const Measurement& m = figures.measurement;
  const ordered_json in_contact =
      m.frames_in_contact > 0 ? ordered_json(m.mean_contact_us) : ordered_json();
  return {{"engine", figures.engine},
          {"query", name_of(settings.question)},
          {"cache", name_of(settings.cache)},
          {"threads", 1},
          {"mean_us", m.mean_us},
          {"mean_contact_us", in_contact},
          {"p95_us", m.p95_us},
          {"mean_update_us", m.mean_update_us},
          {"hash", hex16(m.hash)},
          {"counters", counters_json(m.work)}};
}

ordered_json machine_json() {
  const Machine machine = this_machine();
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"compiler", machine.compiler},
          {"build", machine.build},
          {"pelt", PELT_VERSION}};
}

}  // namespace

const char* name_of(Question question) { return question == Question::all ? "all" : "first"; }

const char* name_of(Cache cache) { return cache == Cache::hot ? "hot" : "cold"; }

void print_figures(const SceneFigures& figures, const BenchSettings& settings, std::ostream& out) {
  const Measurement& any = figures.engines[0].measurement;
  double fastest_us = any.mean_us;
  for (const EngineFigures& engine : figures.engines) {
    fastest_us = std::min(fastest_us, engine.measurement.mean_us);
  }
  out << figures.scene << ": " << with_commas(figures.triangles) << " triangles, "
      << counted(any.frames, "frame") << " of which " << with_commas(any.frames_in_contact)
      << " in contact, built in " << fixed(figures.build_seconds, 3) << " s\n"
      << "query " << name_of(settings.question) << ", cache " << name_of(settings.cache)
      << ", 1 thread, median of " << settings.repetitions << "; hash " << hex16(any.hash)
      << " by every method\n\n";
  print_head(out);
  for (const EngineFigures& engine : figures.engines) print_row(engine, fastest_us, out);
  out << "\nwork a frame" << std::right << std::setw(18) << "node pairs" << std::setw(16)
      << "refits" << std::setw(16) << "posed vertices" << std::setw(16) << "triangle pairs" << '\n';
  for (const EngineFigures& engine : figures.engines) print_work(engine, out);
  out << '\n';
}

ordered_json figures_json(const std::vector<SceneFigures>& scenes, const BenchSettings& settings) {
  ordered_json all = ordered_json::array();
  for (const SceneFigures& figures : scenes) {
    ordered_json engines = ordered_json::array();
    for (const EngineFigures& engine : figures.engines) {
      engines.push_back(engine_json(engine, settings));
    }
    const Measurement& any = figures.engines[0].measurement;
    all.push_back({{"scene", figures.scene},
                   {"frames", any.frames},
                   {"frames_in_contact", any.frames_in_contact},
                   {"build_seconds", figures.build_seconds},
                   {"engines", std::move(engines)}});
  }
  return {{"format", "pelt-bench"},
          {"version", 1},
          {"machine", machine_json()},
          {"repetitions", settings.repetitions},
          {"scenes", std::move(all)}};
}

}  // namespace pelt::tools

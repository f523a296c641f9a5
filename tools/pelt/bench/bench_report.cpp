#include "tools/pelt/bench/bench_report.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <set>

namespace pelt::tools::bench {
namespace {

constexpr int kName = 12, kColumn = 12, kWorkColumn = 16;

void print_name(const std::string& name, std::ostream& out) {
  out << std::left << std::setw(kName) << name << std::right;
}

/// Prints a line of a table without empty cells.
void print_cells(const std::string& name, const std::vector<std::string>& cells,
                 std::ostream& out) {
  print_name(name, out);
  for (const std::string& cell : cells)
    if (!cell.empty()) out << std::setw(kColumn) << cell;
  out << '\n';
}

/// The cell of a column that is shown only if another method was measured.
std::string if_measured(const SceneFigures& scene, const char* method, const std::string& cell) {
  return has_method(scene, method) ? cell : "";
}

/// The cell of a column that is empty for self-collision.
std::string of_pairs(const SceneFigures& scene, const std::string& cell) {
  return scene.self_filters ? "" : cell;
}

std::string of_eager(const SceneFigures& scene, const std::string& cell) {
  return scene.self_filters ? if_measured(scene, "eager", cell) : cell;
}

/// The cell of a column of tables of the first contact.
std::string of_first(const SceneFigures& scene, const Figures& figures, const std::string& cell) {
  return scene.self_filters && figures.variant.question == Question::first ? cell : "";
}

/// The speed-up of a query over that for all contacts.
std::optional<double> speed_up_over_all(const SceneFigures& scene, const Figures& figures) {
  return ratio(mean_of(scene, figures.method, {Question::all, figures.variant.cache}),
               &figures.times.mean_us);
}

void print_scene(const SceneFigures& scene, std::ostream& out) {
  const double bytes = static_cast<double>(scene.models.bytes);
  const double triangles = static_cast<double>(scene.models.triangles);
  out << asset::printable(scene.scene) << ": " << output::with_commas(scene.triangles)
      << " triangles, " << output::counted(scene.frames, "frame") << " of which "
      << output::with_commas(scene.figures[0].answer.frames_in_contact) << " in contact\n"
      << "models: " << output::with_commas(scene.models.triangles) << " triangles, built in "
      << output::fixed(scene.models.build_seconds, 3) << " s, "
      << output::fixed(bytes / triangles, 1) << " bytes per triangle\n";
  if (!scene.self_filters) return;
  out << "self filters: built in " << output::fixed(scene.self_filters->build_seconds, 3) << " s, "
      << output::fixed(static_cast<double>(scene.self_filters->bytes) / triangles, 1)
      << " bytes per triangle\n";
}

void print_repetitions(const SceneFigures& scene, std::ostream& out) {
  if (scene.repetitions >= kEnoughRepetitions) return;
  out << "rough measurement: " << output::counted(scene.repetitions, "repetition")
      << " per frame; use " << kEnoughRepetitions << " or more to reduce noise\n";
}

/// Prints the cost of skinning, which is the unit of comparison, and the methods close to it.
void print_skinning(const SceneFigures& scene, std::ostream& out) {
  const Skinning& skinning = scene.skinning;
  out << "all " << output::with_commas(skinning.vertices)
      << " vertices skinned: " << output::fixed(skinning.mean_us, 1) << " us per frame, "
      << output::fixed(skinning.ns_per_vertex(), 2) << " ns per vertex";
  for (const char* method : {"paper", "eager"}) {
    const double* mean = mean_of(scene, method, scene.figures[0].variant);
    if (mean)
      out << "; " << method << " " << output::fixed(*mean / skinning.mean_us, 2) << " times that";
  }
  out << "\n\n";
}

void print_head(const SceneFigures& scene, const Figures& figures, std::ostream& out) {
  const Variant& variant = figures.variant;
  out << "query " << name_of(variant.question) << ", cache " << name_of(variant.cache) << ", "
      << name_of(scene.time) << " time, median of " << scene.repetitions;
  if (figures.times.frames < scene.frames)
    out << ", " << output::counted(figures.times.frames, "frame") << " of "
        << output::with_commas(scene.frames);
  out << "; hash " << output::hex16(figures.answer.hash) << " by every method\n";
  print_cells("method",
              {"threads", "mean us", "in contact", "95 %", "update", "query",
               of_pairs(scene, "vs paper"), of_eager(scene, "vs eager"),
               if_measured(scene, "rigid", "of rigid"), if_measured(scene, "boxes", "of boxes"),
               of_first(scene, figures, "vs all"), of_pairs(scene, "vs 1 thread")},
              out);
}

void print_row(const SceneFigures& scene, const Figures& figures, std::ostream& out) {
  const Times& times = figures.times;
  const Ratios ratios = ratios_of(scene, figures);
  const double* one_thread =
      figures.asked == Asked::crowd ? mean_of(scene, figures.method, figures.variant) : nullptr;
  print_cells(
      figures.method,
      {std::to_string(figures.threads), output::fixed(times.mean_us, 1),
       times.frames_in_contact > 0 ? output::fixed(times.mean_contact_us, 1) : "-",
       output::fixed(times.p95_us, 1), output::fixed(times.mean_update_us, 1),
       output::fixed(times.mean_us - times.mean_update_us, 1),
       of_pairs(scene, in_words(ratios.vs_paper)), of_eager(scene, in_words(ratios.vs_eager)),
       if_measured(scene, "rigid", in_words(ratios.of_rigid)),
       if_measured(scene, "boxes", in_words(ratios.of_boxes)),
       of_first(scene, figures, in_words(speed_up_over_all(scene, figures))),
       of_pairs(scene, in_words(ratio(one_thread, &times.mean_us)))},
      out);
}

void print_tables(const SceneFigures& scene, std::ostream& out) {
  const Figures* before = nullptr;
  for (const Figures& figures : scene.figures) {
    if (before == nullptr || !is_same(before->variant, figures.variant)) {
      if (before != nullptr) out << '\n';
      print_head(scene, figures, out);
    }
    print_row(scene, figures, out);
    before = &figures;
  }
  out << '\n';
}

void print_sequence(const SceneFigures& scene, std::ostream& out) {
  if (!scene.sequence) return;
  const auto& [self_us, tracked_us] = *scene.sequence;
  out << "frames in order, all contacts: self " << output::fixed(self_us, 1)
      << " us per frame, with SelfTracker " << output::fixed(tracked_us, 1)
      << " us: " << output::fixed(self_us / tracked_us, 2) << " times as fast\n\n";
}

void print_work(const SceneFigures& scene, const Figures& figures, std::ostream& out) {
  const QueryStats& work = figures.answer.work;
  print_name(figures.method, out);
  out << std::setw(8) << name_of(figures.variant.question);
  for (const std::uint64_t count :
       {work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs}) {
    const double mean = static_cast<double>(count) / static_cast<double>(scene.frames);
    out << std::setw(kWorkColumn) << output::fixed(mean, 1);
  }
  out << '\n';
}

/// Work does not depend on caches and threads, so each method is shown once per query.
void print_all_work(const SceneFigures& scene, std::ostream& out) {
  print_name("work per frame", out);
  out << std::setw(8) << "query";
  for (const char* head : {"node pairs", "refits", "posed vertices", "triangle pairs"})
    out << std::setw(kWorkColumn) << head;
  out << '\n';
  std::set<std::pair<Question, std::string>> shown;
  for (const Figures& figures : scene.figures)
    if (shown.emplace(figures.variant.question, figures.method).second)
      print_work(scene, figures, out);
  out << '\n';
}

}  // namespace

const char* name_of(Question question) { return question == Question::all ? "all" : "first"; }

const char* name_of(Cache cache) { return cache == Cache::hot ? "hot" : "cold"; }

const char* name_of(Asked asked) {
  constexpr std::array kNames = {"pairs", "crowd", "self", "none"};
  return kNames[static_cast<std::size_t>(asked)];
}

const char* name_of(Time time) { return time == Time::thread ? "thread" : "wall"; }

void print_machine(std::ostream& out) { out << in_words(this_machine()) << "\n\n"; }

void print_figures(const SceneFigures& scene, std::ostream& out) {
  print_scene(scene, out);
  print_repetitions(scene, out);
  print_skinning(scene, out);
  print_tables(scene, out);
  print_sequence(scene, out);
  print_all_work(scene, out);
}

}  // namespace pelt::tools::bench

#include "tools/pelt/list/list.hpp"

#include <pelt/version.hpp>

#include "base/hash.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/check.hpp"
#include "tools/pelt/check/summary.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

namespace pelt::tools::list {
namespace {

using nlohmann::ordered_json;

bool is_in_contact(const SceneEntry& entry) { return entry.contacts > 0; }
bool is_failed(const SceneEntry& entry) { return entry.is_failed; }

std::string first_line(std::size_t scenes) {
  return text::json_text(ordered_json{
      {"format", "pelt-check-list"}, {"version", 1}, {"pelt", PELT_VERSION}, {"scenes", scenes}});
}

/// Names the scene, if the message does not begin with it.
void print_error(const SceneEntry& entry) {
  const std::string place = entry.error->starts_with(entry.scene) ? "" : entry.scene + ": ";
  std::cerr << "pelt: error: " << text::printable(place + *entry.error) << '\n';
}

void print_row(const SceneEntry& entry, std::ostream& out) {
  out << std::right << std::setw(12) << text::with_commas(entry.worst) << "  "
      << text::printable(entry.scene);
  if (entry.worst > 0)
    out << ", frame " << entry.worst_frame << ", in contact in "
        << text::with_commas(entry.frames_in_contact) << " of "
        << text::counted(entry.frames, "frame");
  out << (entry.is_failed ? ", failed\n" : "\n");
}

/// The scenes that failed come first, then those with the most contacts in one frame.
std::vector<SceneEntry> rows_of(std::vector<SceneEntry> entries) {
  std::erase_if(entries, [](const SceneEntry& e) { return !is_failed(e) && !is_in_contact(e); });
  std::stable_sort(entries.begin(), entries.end(), [](const SceneEntry& a, const SceneEntry& b) {
    return a.is_failed != b.is_failed ? a.is_failed : a.worst > b.worst;
  });
  return entries;
}

/// Checks an opened scene and writes its lines.
Result<check::CheckReport> check_opened(const check::CheckOptions& options, scenes::Scene& scene,
                                        std::ostream& lines) {
  const Result<check::CheckSettings> settings = check::choose_settings(options, scene);
  if (!settings) return settings.error();
  auto answer = check::answer_scene(scene, *settings, nullptr, &lines);
  if (!answer) return answer.error();
  if (const auto compared = check::require_comparison(answer->report, *settings); !compared)
    return compared.error();
  return std::move(answer->report);
}

/// Returns an error only if an output would replace a file of the scene.
Result<void> ask_scene(const ListPlan& plan, const std::string& name, std::uint32_t threads,
                       SceneAnswer& answer) {
  check::CheckOptions options = plan.options;
  options.scene.inputs = {name};
  options.threads = threads;
  if (plan.baseline) options.baseline_text = plan.baseline->text_of(name);
  Result<scenes::Scene> scene = arguments::open_scene(options.scene);
  if (!scene) {
    answer = unchecked(name, scene.error());
    return {};
  }
  const auto inputs = arguments::files_of_scene(options.scene, *scene);
  if (const auto checked = output::check_outputs(plan.outputs, inputs); !checked) return checked;
  std::ostringstream lines;
  const auto report = check_opened(options, *scene, lines);
  answer = report ? answer_of(name, *report, lines.str()) : unchecked(name, report.error());
  return {};
}

}  // namespace

Result<ListPlan> ListPlan::make(const check::CheckOptions& options) {
  ListPlan plan;
  plan.options = options;
  plan.outputs = {{"--jsonl", options.jsonl}, {"-o", options.shard_file}};
  auto scenes = read_scene_list(options.scenes);
  if (!scenes) return scenes.error();
  plan.scenes = std::move(*scenes);
  std::vector<output::InputFile> inputs = {
      {options.scenes, "the list of scenes " + options.scenes}};
  if (!options.baseline.empty())
    inputs.push_back({options.baseline, "the baseline " + options.baseline});
  for (const std::string& scene : plan.scenes) inputs.push_back({scene, "the scene " + scene});
  if (const auto checked = output::check_outputs(plan.outputs, inputs); !checked)
    return checked.error();
  if (options.baseline.empty()) return plan;
  auto baseline = ListBaseline::read(options.baseline);
  if (!baseline) return baseline.error();
  plan.baseline = std::move(*baseline);
  return plan;
}

void warn_of_missing_scenes(const ListPlan& plan) {
  if (!plan.baseline) return;
  const std::vector<std::string> missing = plan.baseline->scenes_missing_in(plan.scenes);
  if (missing.empty()) return;
  std::cerr << "pelt: warning: --baseline: " << text::printable(plan.options.baseline) << ": has "
            << text::counted(missing.size(), "scene") << " that "
            << text::printable(plan.options.scenes) << " lacks, first " << text::quoted(missing[0])
            << ": add scenes that were lost or renamed, or write a new baseline\n";
}

Result<void> ask_scenes(const ListPlan& plan, const check::Indices& indices, const UseScene& use) {
  const auto ask = [&](const check::ItemWorker& worker, std::size_t index, SceneAnswer& answer) {
    return ask_scene(plan, plan.scenes[index], worker.threads, answer);
  };
  return check::compute_in_order<SceneAnswer>(indices, plan.options.threads.value_or(0), ask, use);
}

void ListTally::add(const SceneEntry& entry) {
  if (entry.error) print_error(entry);
  unchecked_ += entry.error.has_value();
  frames_ += entry.frames;
  frames_in_contact_ += entry.frames_in_contact;
  contacts_ += entry.contacts;
  entries_.push_back(entry);
}

std::size_t ListTally::count(bool (*is_counted)(const SceneEntry& entry)) const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), is_counted));
}

/// Nullopt if the contacts of any scene are not known or were limited.
std::optional<std::uint64_t> ListTally::hash() const {
  detail::Fnv1a64 hash;
  for (const SceneEntry& entry : entries_) {
    if (!entry.hash) return std::nullopt;
    hash.add_u32(static_cast<std::uint32_t>(*entry.hash));
    hash.add_u32(static_cast<std::uint32_t>(*entry.hash >> 32));
  }
  return hash.value();
}

std::string ListTally::totals() const {
  ordered_json last = {{"totals",
                        {{"scenes", scenes()},
                         {"unchecked", unchecked_},
                         {"failed", count(is_failed)},
                         {"in_contact", count(is_in_contact)},
                         {"frames", frames_},
                         {"frames_in_contact", frames_in_contact_},
                         {"contacts", contacts_}}},
                       {"hash", nullptr}};
  if (const auto value = hash()) last["hash"] = text::hex16(*value);
  return text::json_text(last);
}

void ListTally::print_summary(std::uint32_t rows, std::ostream& out) const {
  const std::size_t in_contact = count(is_in_contact);
  scene::label(out, "scenes") << text::with_commas(scenes()) << ": "
                              << text::with_commas(count(is_failed)) << " failed, "
                              << text::with_commas(unchecked_) << " could not be checked\n";
  scene::label(out, "contact");
  if (in_contact == 0)
    out << "none in " << text::counted(frames_, "frame") << '\n';
  else
    out << "in " << text::counted(in_contact, "scene") << ", in "
        << text::with_commas(frames_in_contact_) << " of " << text::counted(frames_, "frame")
        << '\n';
  const std::vector<SceneEntry> listed = rows_of(entries_);
  if (!listed.empty()) out << "\nscenes, by the contacts of their worst frames\n";
  const check::ListLength length(rows);
  for (const SceneEntry& entry : length.shown(listed)) print_row(entry, out);
  length.print_rest(listed.size(), out);
  if (!listed.empty()) out << '\n';
  if (const auto value = hash()) scene::label(out, "hash") << text::hex16(*value) << '\n';
}

arguments::ExitCode ListTally::exit_code() const {
  if (unchecked_ > 0) return arguments::ExitCode::bad_input;
  return count(is_failed) > 0 ? arguments::ExitCode::contact : arguments::ExitCode::success;
}

Result<arguments::ExitCode> write_list(const check::CheckOptions& options, std::size_t scenes,
                                       const SceneSource& source) {
  output::OutputFile file;
  if (const auto opened = file.open(options.jsonl); !opened) return opened.error();
  std::ostream* const lines = file.stream();
  if (lines != nullptr) *lines << first_line(scenes) << '\n';
  ListTally tally;
  const auto added = source([&](const SceneAnswer& answer) -> Result<void> {
    tally.add(answer.entry);
    if (lines != nullptr) *lines << answer.text;
    return {};
  });
  if (!added) return added.error();
  if (lines != nullptr) *lines << tally.totals() << '\n';
  if (const auto closed = file.close(); !closed) return closed.error();
  std::ostream& words = output::words_beside({options.jsonl});
  tally.print_summary(options.list, words);
  output::print_written(options.jsonl, words);
  return tally.exit_code();
}

Result<arguments::ExitCode> run_list(const check::CheckOptions& options) {
  if (const auto chosen = arguments::choose_simd(options.simd); !chosen) return chosen.error();
  const Result<ListPlan> plan = ListPlan::make(options);
  if (!plan) return plan.error();
  warn_of_missing_scenes(*plan);
  const std::size_t count = plan->scenes.size();
  return write_list(options, count, [&](const UseScene& use) {
    return ask_scenes(*plan, {0, count}, use);
  });
}

}  // namespace pelt::tools::list

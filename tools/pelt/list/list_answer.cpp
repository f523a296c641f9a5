#include "tools/pelt/list/list_answer.hpp"

#include <pelt/version.hpp>

#include "asset/printable.hpp"
#include "base/hash.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/summary_lists.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace pelt::tools::list {
namespace {

using nlohmann::ordered_json;

bool is_in_contact(const SceneEntry& entry) { return entry.contacts > 0; }
bool is_failed(const SceneEntry& entry) { return entry.is_failed; }

std::string first_line(std::size_t scenes) {
  return output::json_text(ordered_json{
      {"format", "pelt-check-list"}, {"version", 1}, {"pelt", PELT_VERSION}, {"scenes", scenes}});
}

/// Names the scene, if the message does not begin with it.
void print_error(const SceneEntry& entry) {
  const std::string place = entry.error->starts_with(entry.scene) ? "" : entry.scene + ": ";
  std::cerr << "pelt: error: " << asset::printable(place + *entry.error) << '\n';
}

void print_row(const SceneEntry& entry, std::ostream& out) {
  out << std::right << std::setw(12) << output::with_commas(entry.worst) << "  "
      << asset::printable(entry.scene);
  if (entry.worst > 0)
    out << ", frame " << entry.worst_frame << ", in contact in "
        << output::with_commas(entry.frames_in_contact) << " of "
        << output::counted(entry.frames, "frame");
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

}  // namespace

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
  if (const auto value = hash()) last["hash"] = output::hex16(*value);
  return output::json_text(last);
}

void ListTally::print_summary(std::uint32_t rows, std::ostream& out) const {
  const std::size_t in_contact = count(is_in_contact);
  scene::label(out, "scenes") << output::with_commas(scenes()) << ": "
                              << output::with_commas(count(is_failed)) << " failed, "
                              << output::with_commas(unchecked_) << " could not be checked\n";
  scene::label(out, "contact");
  if (in_contact == 0)
    out << "none in " << output::counted(frames_, "frame") << '\n';
  else
    out << "in " << output::counted(in_contact, "scene") << ", in "
        << output::with_commas(frames_in_contact_) << " of " << output::counted(frames_, "frame")
        << '\n';
  const std::vector<SceneEntry> listed = rows_of(entries_);
  if (!listed.empty()) out << "\nscenes, by the contacts of their worst frames\n";
  const check::ListLength length(rows);
  for (const SceneEntry& entry : length.shown(listed)) print_row(entry, out);
  length.print_rest(listed.size(), out);
  if (!listed.empty()) out << '\n';
  if (const auto value = hash()) scene::label(out, "hash") << output::hex16(*value) << '\n';
}

arguments::ExitCode ListTally::exit_code() const {
  if (unchecked_ > 0) return arguments::ExitCode::bad_input;
  return count(is_failed) > 0 ? arguments::ExitCode::contact : arguments::ExitCode::success;
}

Result<arguments::ExitCode> write_list(const check::CheckArguments& arguments, std::size_t scenes,
                                       const SceneSource& source) {
  output::OutputFile file;
  if (const auto opened = file.open(arguments.jsonl); !opened) return opened.error();
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
  std::ostream& words = output::words_beside({arguments.jsonl});
  tally.print_summary(arguments.list, words);
  output::print_written(arguments.jsonl, words);
  return tally.exit_code();
}

Result<arguments::ExitCode> run_list(const check::CheckArguments& arguments) {
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  const Result<ListPlan> plan = ListPlan::make(arguments);
  if (!plan) return plan.error();
  warn_of_missing_scenes(*plan);
  const std::size_t count = plan->scenes.size();
  return write_list(arguments, count, [&](const UseScene& use) {
    return ask_scenes(*plan, {0, count}, use);
  });
}

}  // namespace pelt::tools::list

#include "tools/pelt/shard/answer_text.hpp"

#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "tools/pelt/list/scene_entry.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/shard/contact_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace pelt::tools::shard {
namespace {

using check::FrameAnswer;
using nlohmann::json;
using nlohmann::ordered_json;

ordered_json work_json(const QueryStats& work) {
  return {work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs,
          work.displacements};
}

ordered_json left_out_json(const LeftOut& left_out) {
  return {left_out.takes_part, left_out.rings,  left_out.at_rest,
          left_out.always,     left_out.joints, left_out.groups};
}

ordered_json undecided_json(const std::vector<check::Undecided>& undecided) {
  ordered_json list = ordered_json::array();
  for (const check::Undecided& one : undecided)
    list.push_back({one.a, one.b, static_cast<std::uint32_t>(one.verdict), one.pairs,
                    one.resolution, one.distance_bound});
  return list;
}

ordered_json inside_json(const std::vector<check::InsidePair>& inside) {
  ordered_json list = ordered_json::array();
  for (const check::InsidePair& one : inside)
    list.push_back({one.a, one.b, static_cast<std::uint32_t>(one.containment), one.a_in_b.depth,
                    one.b_in_a.depth});
  return list;
}

ordered_json patches_json(const std::vector<check::DescribedPatch>& patches) {
  ordered_json list = ordered_json::array();
  for (const check::DescribedPatch& one : patches)
    list.push_back({one.a, one.b, one.joint_a, one.joint_b, one.length});
  return list;
}

ordered_json step_json(const check::StepAnswer& step) {
  ordered_json found = ordered_json::array();
  for (const check::FoundInStep& one : step.found)
    found.push_back({one.a, one.b, one.contact.triangle_a, one.contact.triangle_b,
                     one.first.seconds, one.first.share,
                     static_cast<std::uint32_t>(one.first.a.kind), one.first.a.number,
                     static_cast<std::uint32_t>(one.first.b.kind), one.first.b.number});
  const check::Deviation& deviation = step.deviation;
  return {{"from", step.from},
          {"found", std::move(found)},
          {"deviation", {deviation.distance, deviation.collider, deviation.vertex}},
          {"work", work_json(step.work)},
          {"seconds", step.seconds}};
}

/// Reads the elements of a list, one after the other. After the first bad one, `is_good` is false.
class List {
 public:
  explicit List(const json& list) : list_(list), is_good_(list.is_array()) {}

  /// A whole number below `limit`.
  std::uint64_t below(std::uint64_t limit) {
    const json* const next = take();
    if (next == nullptr || !next->is_number_unsigned() || next->get<std::uint64_t>() >= limit)
      return fail();
    return next->get<std::uint64_t>();
  }

  std::uint32_t index(std::uint64_t limit) { return static_cast<std::uint32_t>(below(limit)); }

  /// A finite number, at least 0.
  double length() {
    const json* const next = take();
    if (next == nullptr || !next->is_number()) return static_cast<double>(fail());
    const double value = next->get<double>();
    return std::isfinite(value) && value >= 0 ? value : static_cast<double>(fail());
  }

  bool has_more() const { return is_good_ && next_ < list_.size(); }
  bool is_good() const { return is_good_; }
  bool is_complete() const { return is_good_ && next_ == list_.size(); }

 private:
  const json* take() { return has_more() ? &list_[next_++] : nullptr; }

  std::uint64_t fail() {
    is_good_ = false;
    return 0;
  }

  const json& list_;
  std::size_t next_ = 0;
  bool is_good_;
};

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

/// Null if the key is absent.
const json& value_of(const json& object, const char* key) {
  static const json kNull;
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

/// Reads parts of an answer. Each function returns whether its value is good.
class AnswerReader {
 public:
  explicit AnswerReader(const scene::StagedScene& staged) : staged_(staged) {}

  bool read(const json& value, QueryStats& work) const {
    List list(value);
    for (std::uint64_t* const count : {&work.node_pairs, &work.refits, &work.posed_vertices,
                                       &work.triangle_pairs, &work.displacements})
      *count = list.below(kAny);
    return list.is_complete();
  }

  bool read(const json& value, LeftOut& left_out) const {
    List list(value);
    for (std::uint64_t* const count : {&left_out.takes_part, &left_out.rings, &left_out.at_rest,
                                       &left_out.always, &left_out.joints, &left_out.groups})
      *count = list.below(kAny);
    return list.is_complete();
  }

  bool read(const json& value, check::Undecided& one) const {
    List list(value);
    one.a = collider(list);
    one.b = collider(list);
    one.verdict = static_cast<pelt::Verdict>(list.below(3));
    one.pairs = list.below(kAny);
    one.resolution = list.length();
    one.distance_bound = list.length();
    return list.is_complete();
  }

  bool read(const json& value, check::InsidePair& one) const {
    List list(value);
    one.a = collider(list);
    one.b = collider(list);
    one.containment = static_cast<Containment>(list.below(3));
    one.a_in_b.depth = list.length();
    one.b_in_a.depth = list.length();
    return list.is_complete() && one.a < one.b;
  }

  bool read(const json& value, check::DescribedPatch& one) const {
    List list(value);
    one.a = collider(list);
    one.b = collider(list);
    one.joint_a = list.index(joints(one.a));
    one.joint_b = list.index(joints(one.b));
    one.length = static_cast<float>(list.length());
    return list.is_complete();
  }

  bool read(const json& value, check::FoundInStep& one) const {
    List list(value);
    one.a = collider(list);
    one.b = collider(list);
    one.contact = contact(list, one.a, one.b);
    one.first.seconds = list.length();
    one.first.share = list.length();
    for (Feature* const feature : {&one.first.a, &one.first.b}) {
      feature->kind = static_cast<FeatureKind>(list.below(3));
      feature->number = static_cast<std::uint8_t>(list.below(3));
    }
    return list.is_complete() && one.a <= one.b;
  }

  bool read(const json& value, check::Deviation& deviation) const {
    List list(value);
    deviation.distance = list.length();
    deviation.collider = collider(list);
    deviation.vertex = list.index(staged_.colliders[deviation.collider].model.vertex_count());
    return list.is_complete();
  }

  template <typename T>
  bool read(const json& value, std::vector<T>& list) const {
    if (!value.is_array()) return false;
    return std::all_of(value.begin(), value.end(),
                       [&](const json& one) { return read(one, list.emplace_back()); });
  }

  bool read(const json& value, const Expected& expected, check::StepAnswer& step) const {
    step.from = step.deviation.from = *expected.step_from;
    step.to = step.deviation.to = expected.frame;
    return value_of(value, "from") == step.from && read(value_of(value, "found"), step.found) &&
           is_ascending(step.found) && read(value_of(value, "deviation"), step.deviation) &&
           read(value_of(value, "work"), step.work) &&
           read(value_of(value, "seconds"), step.seconds);
  }

  bool read(const json& value, double& seconds) const {
    if (!value.is_number()) return false;
    seconds = value.get<double>();
    return std::isfinite(seconds) && seconds >= 0;
  }

 private:
  std::uint32_t collider(List& list) const { return list.index(staged_.colliders.size()); }

  Contact contact(List& list, std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t of_a = triangle(list, a);
    return {of_a, triangle(list, b)};
  }

  /// A triangle of a collider, numbered as in its asset.
  std::uint32_t triangle(List& list, std::uint32_t of) const {
    const scene::Collider& collider = staged_.colliders[of];
    const std::uint64_t number =
        list.below(std::uint64_t{collider.first_triangle} + collider.model.triangle_count());
    return std::max(static_cast<std::uint32_t>(number), collider.first_triangle);
  }

  std::uint64_t joints(std::uint32_t collider) const {
    return std::max<std::uint64_t>(1, staged_.asset_of(collider).joints.size());
  }

  static bool is_ascending(const std::vector<check::FoundInStep>& found) {
    const auto key = [](const check::FoundInStep& f) { return std::tie(f.a, f.b, f.contact); };
    return std::adjacent_find(found.begin(), found.end(), [&](const auto& x, const auto& y) {
             return !(key(x) < key(y));
           }) == found.end();
  }

  const scene::StagedScene& staged_;
};

ordered_json answer_json(const FrameAnswer& answer) {
  ordered_json value = {{"frame", answer.frame},
                        {"ignored", answer.ignored},
                        {"left_out", left_out_json(answer.left_out)},
                        {"undecided", undecided_json(answer.undecided)},
                        {"inside", inside_json(answer.inside)},
                        {"patches", patches_json(answer.patches)},
                        {"step", nullptr},
                        {"work", work_json(answer.work)},
                        {"seconds", answer.seconds}};
  if (answer.step) value["step"] = step_json(*answer.step);
  return value;
}

/// Sets all of an answer but its line and its contacts. Returns the key of the first bad value, or
/// null.
const char* read_values(const json& value, const Expected& expected, FrameAnswer& answer) {
  const AnswerReader reader(expected.staged);
  answer.frame = expected.frame;
  if (expected.staged.colliders.empty() || value_of(value, "frame") != expected.frame)
    return "frame";
  const json& ignored = value_of(value, "ignored");
  if (!ignored.is_number_unsigned()) return "ignored";
  answer.ignored = ignored.get<std::uint64_t>();
  if (!reader.read(value_of(value, "left_out"), answer.left_out)) return "left_out";
  if (!reader.read(value_of(value, "undecided"), answer.undecided)) return "undecided";
  if (!reader.read(value_of(value, "inside"), answer.inside)) return "inside";
  if (!reader.read(value_of(value, "patches"), answer.patches)) return "patches";
  if (!reader.read(value_of(value, "work"), answer.work)) return "work";
  if (!reader.read(value_of(value, "seconds"), answer.seconds)) return "seconds";
  const json& step = value_of(value, "step");
  if (step.is_null() == expected.step_from.has_value()) return "step";
  if (!step.is_null() && !reader.read(step, expected, answer.step.emplace())) return "step";
  return nullptr;
}

}  // namespace

std::string answer_text(const FrameAnswer& answer) {
  std::string text = output::json_text(answer_json(answer)) + '\n' + answer.line + '\n';
  add_contacts(answer.found, text);
  return text + '\n';
}

bool read_lines(std::istream& in, AnswerLines& lines) {
  return list::read_line(in, lines.values) && list::read_line(in, lines.line) &&
         list::read_line(in, lines.contacts);
}

Result<FrameAnswer> read_answer(AnswerLines& lines, const Expected& expected) {
  const auto bad = [](const char* what) {
    return asset::malformed(std::string("bad value of ") + what);
  };
  const Result<asset::ParsedJson> parsed = asset::parse_json(lines.values);
  if (!parsed) return parsed.error();
  FrameAnswer answer;
  answer.line = std::move(lines.line);
  if (!read_contacts(lines.contacts, expected.staged.colliders, answer.found))
    return bad("contacts");
  const char* const key = read_values(**parsed, expected, answer);
  if (key != nullptr) return bad(key);
  return answer;
}

}  // namespace pelt::tools::shard

#include "tools/pelt/arguments/values.hpp"

#include <pelt/config.hpp>

#include "text/format.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt::tools::arguments {
namespace {

constexpr std::array kInstructionSets = {InstructionSet::scalar, InstructionSet::simd128,
                                         InstructionSet::avx2};

std::string available_names() {
  std::string names;
  for (const InstructionSet set : available_instruction_sets())
    names += (names.empty() ? "" : " or ") + std::string(name_of(set));
  return names;
}

}  // namespace

std::vector<std::uint32_t> FrameRange::frames() const {
  std::vector<std::uint32_t> all;
  for (std::uint64_t frame = begin; frame < end; frame += stride) {
    all.push_back(static_cast<std::uint32_t>(frame));
  }
  return all;
}

Result<FrameRange> parse_frame_range(std::string_view text) {
  const Error unclear =
      text::bad_argument("--frames", text::quoted(text) + " is not a range of frames",
                         "give A:B with A < B, which excludes B, or A:B:STRIDE");
  const std::vector<std::string_view> fields = text::split(text, ':');
  if (fields.size() < 2 || fields.size() > 3) return unclear;
  FrameRange range;
  std::uint32_t* const targets[] = {&range.begin, &range.end, &range.stride};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!text::parse_whole(fields[i], *targets[i])) return unclear;
  }
  if (range.begin >= range.end || range.stride == 0) return unclear;
  return range;
}

Result<std::array<double, 3>> parse_position(const std::string& option, const std::string& text) {
  std::array<double, 3> position;
  const std::vector<std::string_view> fields = text::split(text, ',');
  bool good = fields.size() == position.size();
  for (std::size_t i = 0; good && i < position.size(); ++i) {
    good = text::parse_number(fields[i], position[i]) && std::fabs(position[i]) <= 1e12;
  }
  if (good) return position;
  return text::bad_argument(option, text::quoted(text) + " is not a position",
                            "give x,y,z as in " + option + " 0.5,0,-1");
}

Result<Vec3> parse_point(const std::string& option, const std::string& text) {
  const Result<std::array<double, 3>> p = parse_position(option, text);
  if (!p) return p.error();
  return Vec3{static_cast<float>((*p)[0]), static_cast<float>((*p)[1]),
              static_cast<float>((*p)[2])};
}

void add_simd_option(Verb& verb, std::string& name) {
  verb.option("--simd", name,
              "Instruction set for queries; does not change answers (default: the fastest that the "
              "processor supports)",
              {.type = "scalar|simd128|avx2"});
}

Result<void> choose_simd(const std::string& name) {
  if (name.empty()) return {};
  const auto set = std::find_if(kInstructionSets.begin(), kInstructionSets.end(),
                                [&](InstructionSet known) { return name == name_of(known); });
  const bool is_known = set != kInstructionSets.end();
  if (is_known && set_active_instruction_set(*set)) return {};
  return text::bad_argument("--simd",
                            is_known ? name + " is not supported by this processor"
                                     : "unknown value " + text::quoted(name),
                            "give " + available_names());
}

}  // namespace pelt::tools::arguments

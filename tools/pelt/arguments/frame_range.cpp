#include "tools/pelt/arguments/frame_range.hpp"

#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

namespace pelt::tools::arguments {

std::vector<std::uint32_t> FrameRange::frames() const {
  std::vector<std::uint32_t> all;
  for (std::uint64_t frame = begin; frame < end; frame += stride) {
    all.push_back(static_cast<std::uint32_t>(frame));
  }
  return all;
}

Result<FrameRange> parse_frame_range(std::string_view text) {
  const Error unclear =
      output::bad_argument("--frames", asset::quoted(text) + " is not a range of frames",
                           "give A:B with A < B, which excludes B, or A:B:STRIDE");
  const std::vector<std::string_view> fields = output::split(text, ':');
  if (fields.size() < 2 || fields.size() > 3) return unclear;
  FrameRange range;
  std::uint32_t* const targets[] = {&range.begin, &range.end, &range.stride};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!output::parse_whole(fields[i], *targets[i])) return unclear;
  }
  if (range.begin >= range.end || range.stride == 0) return unclear;
  return range;
}

}  // namespace pelt::tools::arguments

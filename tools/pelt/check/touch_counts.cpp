#include "tools/pelt/check/touch_counts.hpp"

#include <algorithm>
#include <tuple>

namespace pelt::tools::check {

void TouchCounts::add(std::uint32_t frame, std::uint64_t found) {
  contacts += found;
  ++frames;
  if (found <= worst) return;
  worst = found;
  worst_frame = frame;
}

std::uint32_t FrameTouches::add(std::uint32_t take, const TouchPlace& a, const TouchPlace& b) {
  touches_.push_back({{}, a, b, take});
  in_frame_.push_back(0);
  return static_cast<std::uint32_t>(touches_.size() - 1);
}

void FrameTouches::end_frame(std::uint32_t frame) {
  for (const std::uint32_t touch : counted_) {
    touches_[touch].add(frame, in_frame_[touch]);
    in_frame_[touch] = 0;
  }
  counted_.clear();
}

std::vector<Touch> FrameTouches::sorted() const {
  std::vector<Touch> touches = touches_;
  std::sort(touches.begin(), touches.end(), [](const Touch& x, const Touch& y) {
    return std::tie(y.contacts, x.take, x.a, x.b) < std::tie(x.contacts, y.take, y.a, y.b);
  });
  return touches;
}

}  // namespace pelt::tools::check

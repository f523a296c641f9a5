#pragma once

/// Contacts of pairs of places, added up frame by frame.

#include "tools/pelt/check/touch_places.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::check {

/// Contacts over all frames, or over those of a take.
struct TouchCounts {
  std::uint64_t contacts = 0;
  std::uint32_t frames = 0;       ///< with contacts
  std::uint64_t worst = 0;        ///< the most contacts of one frame
  std::uint32_t worst_frame = 0;  ///< the first frame with `worst` contacts

  /// Adds the contacts of a frame, at least one. Frames ascend.
  void add(std::uint32_t frame, std::uint64_t found);
};

/// The contacts of two places.
struct Touch : TouchCounts {
  TouchPlace a, b;         ///< a <= b
  std::uint32_t take = 0;  ///< index into the scene's takes, if it has any
};

/// Touches, with the contacts of the current frame.
class FrameTouches {
 public:
  /// Adds a touch without contacts. Returns its index.
  std::uint32_t add(std::uint32_t take, const TouchPlace& a, const TouchPlace& b);

  /// Adds contacts, at least one, to a touch in the current frame.
  void count(std::uint32_t touch, std::uint64_t contacts) {
    if (in_frame_[touch] == 0) counted_.push_back(touch);
    in_frame_[touch] += contacts;
  }

  /// The touches with contacts in the current frame, and the number of them.
  std::span<const std::uint32_t> counted() const { return counted_; }
  std::uint64_t in_frame(std::uint32_t touch) const { return in_frame_[touch]; }

  /// Adds the contacts of the current frame to the sums, and starts the next frame.
  void end_frame(std::uint32_t frame);

  /// Returns the touches by contacts, descending, then by take and places.
  std::vector<Touch> sorted() const;

 private:
  std::vector<Touch> touches_;
  std::vector<std::uint64_t> in_frame_;  // by touch
  std::vector<std::uint32_t> counted_;
};

}  // namespace pelt::tools::check

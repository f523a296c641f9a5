#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <vector>

namespace pelt::python {

/// Lists of all frames. Each thread appends the lists of its frames to one vector.
template <class Item>
class FrameLists {
 public:
  using List = std::vector<Item>;

  explicit FrameLists(std::size_t frames) : frames_(frames) {}

  std::size_t frame_count() const { return frames_.size(); }

  /// Returns the vector of a new thread. Safe to call from any thread.
  List& add_thread() {
    const std::lock_guard lock(mutex_);
    return threads_.emplace_back();
  }

  /// States that the items of `list` from `begin` to its end are the list of `frame`.
  void set(std::size_t frame, const List& list, std::size_t begin) {
    frames_[frame] = {&list, begin, list.size()};
  }

  /// Number of items of all frames.
  std::size_t size() const {
    std::size_t sum = 0;
    for (const Range& range : frames_) sum += range.end - range.begin;
    return sum;
  }

  /// Calls `visit(place, frame, item)` for each item, in order of the frames. `place` counts from
  /// 0.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::size_t place = 0;
    for (std::size_t frame = 0; frame < frames_.size(); ++frame)
      for (std::size_t i = frames_[frame].begin; i < frames_[frame].end; ++i)
        visit(place++, frame, (*frames_[frame].list)[i]);
  }

 private:
  struct Range {
    const List* list = nullptr;
    std::size_t begin = 0, end = 0;
  };

  std::mutex mutex_;
  std::deque<List> threads_;
  std::vector<Range> frames_;
};

}  // namespace pelt::python

#pragma once

/// Queries many frames of a check on several threads.

#include "tools/pelt/check/check_query.hpp"

#include <cstdint>
#include <functional>

namespace pelt::tools::check {

/// Indices of frames in a plan, from `begin` up to `end`, exclusive.
struct FrameIndices {
  std::size_t begin = 0, end = 0;

  std::size_t count() const { return end - begin; }
};

/// Queries frames on `threads` threads (0 means all cores) and passes their answers to `use`, in
/// order. Calls of `use` follow one another, but on any thread. Shows a progress bar. Returns the
/// first error in the order of frames. If there are fewer frames than threads, the queries of a
/// frame use several.
Result<void> ask_frames(const CheckPlan& plan, const FrameIndices& indices, std::uint32_t threads,
                        const std::function<Result<void>(const FrameAnswer& answer)>& use);

}  // namespace pelt::tools::check

#pragma once

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/programs/crowd_run.hpp"

#include <memory>

namespace pelt::reproduce {

/// Of a frame: the median time over the frames, the contacts of the last one.
struct PairwiseTiming {
  double frame_us = 0;
  std::size_t contacts = 0;
};

/// A method on the frames of a crowd, every pair asked by itself. A frame is what CrowdRun times:
/// all palettes set, and all contacts found.
class PairwiseRun {
 public:
  /// `job` must outlive the run.
  PairwiseRun(const programs::CrowdJob& job, methods::MethodKind method);

  PairwiseTiming run();

 private:
  void set_palettes();
  void collide_pairs();

  const programs::CrowdJob& job_;
  std::unique_ptr<methods::Method> method_;
  std::vector<Matrix4> palettes_;
  std::vector<Contact> contacts_;
};

}  // namespace pelt::reproduce

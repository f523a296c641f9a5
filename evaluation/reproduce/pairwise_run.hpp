#pragma once

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/programs/crowd.hpp"

#include <memory>

namespace pelt::reproduce {

/// Time per frame: the median over the frames. Contacts: of the last frame.
struct PairwiseTiming {
  double frame_us = 0;
  std::size_t contacts = 0;
};

/// Runs a method on the frames of a crowd, pair by pair. As in CrowdRun, a frame consists of
/// setting all palettes and finding all contacts.
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

#pragma once

/// The queries of `pelt check` for one frame.

#include <pelt/surface.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/check/step_query.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace pelt::tools::check {

/// Queries single frames, in any order. Answers do not depend on the order.
///
/// A frame is posed once: all questions share the nodes that the first of them opens. If only
/// contacts are needed, a crowd is queried, which uses several threads and less memory. Otherwise,
/// single poses are queried, for contacts, too.
class FrameQuery {
 public:
  /// `stage` is prepared, and must outlive the query. `threads`: of each crowd, at least 1.
  FrameQuery(const Stage& stage, std::uint32_t threads);

  /// Replaces `answer` by that for a frame, given by its index in the stage, except for its line.
  /// Error messages name the frame and the instance.
  Result<void> ask(std::size_t index, FrameAnswer& answer);

  /// The geometry of the contacts of each pair of the latest answer; empty without --contacts.
  /// Triangles are numbered as in the colliders' own models, and joints as in the assets.
  std::span<const ContactGeometry> geometry() const {
    return std::span(geometry_).first(described_);
  }

 private:
  using Bodies = std::pair<scenes::IgnoredPairs::Body, scenes::IgnoredPairs::Body>;

  Result<void> ask_frame(std::size_t index, FrameAnswer& answer);
  Result<void> find_contacts(FrameAnswer& answer);
  void find_by_poses(const Limits& limits, FrameAnswer& answer);
  void find_own(const Limits& limits, FrameAnswer& answer);
  void find_pairs(const Limits& limits, FrameAnswer& answer);
  void find_of_pair(const CrowdPair& pair, const Limits& limits, FrameAnswer& answer);
  void search(Pose& a, Pose& b, const CrowdPair& pair, FrameAnswer& answer);
  void ask_inside(FrameAnswer& answer);
  InsidePair inside_of(const CrowdPair& pair, bool touches);
  Penetration deepest(std::uint32_t a, std::uint32_t b);
  bool is_ignored(const CrowdPair& pair);
  void describe(FrameAnswer& answer);
  Result<void> ask_step(std::size_t index, FrameAnswer& answer);

  const Stage& stage_;
  std::optional<scene::SceneQuery> contacts_;  // nullopt: contacts are asked of the poses
  std::optional<scene::ScenePoses> posed_;     // nullopt: nothing is asked of poses
  std::optional<StepQuery> steps_;
  asset::SampleScratch sample_scratch_;
  scene::Palettes palettes_;  // of the frame
  scene::NearPairs near_pairs_;
  std::span<const CrowdPair> near_;  // of the frame
  Scratch scratch_;
  std::vector<Contact> found_;                        // of a pair, numbered as in the models
  std::vector<std::vector<Contact>> own_;             // of each collider with itself
  scene::FrameContacts pairs_;                        // of the frame, before any filter
  std::vector<scene::FrameContacts::Pair> touching_;  // before any filter
  std::map<Bodies, bool> are_ignored_;                // pairs that were looked up
  std::vector<ContactGeometry> geometry_;             // reused from frame to frame
  std::size_t described_ = 0;                         // number of them in the latest frame
  QueryStats work_;                                   // of the poses in the frame
};

/// Uses the answer of a frame.
using UseAnswer = std::function<Result<void>(const FrameAnswer& answer)>;

/// Queries frames, given by their indices in the stage, on the threads of the settings, and passes
/// their answers to `use`, in order (see compute_in_order). `writes_lines`: answers have lines of
/// --jsonl. The answers do not depend on the number of threads. Memory: a query for each thread,
/// and the answers of a few frames.
Result<void> ask_frames(const Stage& stage, const Indices& indices, bool writes_lines,
                        const UseAnswer& use);

}  // namespace pelt::tools::check

#pragma once

/// What `pelt check --jsonl` writes: a header, a line for every frame, the totals.

#include "scenes/scene.hpp"
#include "tools/pelt/contact_details.hpp"
#include "tools/pelt/frame_range.hpp"
#include "tools/pelt/scene_query.hpp"

#include <optional>
#include <ostream>
#include <string>

namespace pelt::tools {

struct CheckTotals {
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  QueryStats work;
  std::optional<std::uint64_t> hash;  ///< nothing where a limit on contacts was in force
};

/// The options that decide the answer, for the header.
struct CheckOptionsShown {
  std::string method, by;
  FrameRange frames;
  std::optional<std::uint32_t> max_contacts;
  std::optional<double> clearance;
  bool contacts = false;
};

enum class TriangleLists { left_out, written };

class JsonlWriter {
 public:
  /// All but `lists` must outlive the writer.
  JsonlWriter(std::ostream& out, TriangleLists lists, const scenes::Scene& scene,
              std::span<const Collider> colliders)
      : out_(out), lists_(lists), scene_(scene), colliders_(colliders) {}

  void header(const CheckOptionsShown& options);

  /// `details` may be null: then no geometry is written.
  void frame(std::uint32_t frame, double time, const FrameContacts& found,
             const ContactDetails* details);
  void totals(const CheckTotals& totals);

 private:
  std::ostream& out_;
  TriangleLists lists_;
  const scenes::Scene& scene_;
  std::span<const Collider> colliders_;
};

}  // namespace pelt::tools

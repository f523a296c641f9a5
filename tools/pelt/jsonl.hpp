#pragma once

/// What `pelt check --jsonl` writes: a header, a line for every frame, the totals.

#include "scenes/scene.hpp"
#include "tools/pelt/contact_details.hpp"
#include "tools/pelt/frame_range.hpp"
#include "tools/pelt/inside_query.hpp"
#include "tools/pelt/scene_query.hpp"
#include "tools/pelt/verdict.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>
#include <string>

namespace pelt::tools {

struct CheckTotals {
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t ignored = 0;  ///< contacts that do not count
  QueryStats work;
  std::optional<std::uint64_t> hash;  ///< nothing where a limit on contacts was in force
};

/// The options that decide the answer, for the header.
struct CheckOptionsShown {
  std::string method, by;
  FrameRange frames;
  std::optional<std::uint32_t> max_contacts;
  std::optional<double> clearance;
  bool contacts = false, inside = false;
  std::vector<scenes::NamePair> ignore;
};

enum class TriangleLists { left_out, written };

/// What is told of a frame beside its contacts; null: nothing.
struct FrameExtras {
  const ContactDetails* details = nullptr;
  const InsideQuery* inside = nullptr;
};

class JsonlWriter {
 public:
  /// All but `lists` must outlive the writer.
  JsonlWriter(std::ostream& out, TriangleLists lists, const scenes::Scene& scene,
              std::span<const Collider> colliders)
      : out_(out), lists_(lists), scene_(scene), colliders_(colliders) {}

  void header(const CheckOptionsShown& options);

  void frame(std::uint32_t frame, double time, const FrameContacts& found,
             const FrameExtras& extras);
  void totals(const CheckTotals& totals, std::span<const Touch> touches, const Verdict& verdict);

 private:
  nlohmann::ordered_json pairs_json(const FrameContacts& found,
                                    const ContactDetails* details) const;
  nlohmann::ordered_json inside_json(const InsideQuery& inside) const;

  std::ostream& out_;
  TriangleLists lists_;
  const scenes::Scene& scene_;
  std::span<const Collider> colliders_;
};

}  // namespace pelt::tools

#pragma once

/// What `pelt check --jsonl` writes: a header, a line for every frame, the totals.

#include "scenes/scene.hpp"
#include "tools/pelt/frame_range.hpp"
#include "tools/pelt/scene_query.hpp"

#include <nlohmann/json_fwd.hpp>

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
};

enum class TriangleLists { left_out, written };

class JsonlWriter {
 public:
  /// `out` must outlive the writer.
  JsonlWriter(std::ostream& out, TriangleLists lists) : out_(out), lists_(lists) {}

  void header(const scenes::Scene& scene, std::span<const Collider> colliders,
              const CheckOptionsShown& options);
  void frame(std::uint32_t frame, double time, const FrameContacts& found);
  void totals(const CheckTotals& totals);

 private:
  void line(const nlohmann::ordered_json& value);

  std::ostream& out_;
  TriangleLists lists_;
};

nlohmann::ordered_json counters_json(const QueryStats& work);

}  // namespace pelt::tools

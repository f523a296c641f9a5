#pragma once

/// Query of `pelt ray` for one frame, its totals and its output.

#include <pelt/ray.hpp>

#include "tools/pelt/query/frame_query.hpp"

#include <optional>
#include <vector>

namespace pelt::tools::query {

struct RaySettings {
  std::vector<Ray> rays;
  Facing facing = Facing::both;
  std::uint32_t stride = 1;  ///< of the frames
};

/// First hit of each ray on each instance.
class RayHits {
 public:
  RayHits(std::size_t rays, std::size_t instances) : rays_(rays), hits_(rays * instances) {}

  std::span<RayHit> of_instance(std::size_t instance) {
    return std::span(hits_).subspan(instance * rays_, rays_);
  }

  const RayHit& at(std::size_t instance, std::size_t ray) const {
    return hits_[instance * rays_ + ray];
  }

  /// The instance that a ray hits first.
  std::optional<std::uint32_t> first(std::size_t ray) const {
    std::optional<std::uint32_t> first;
    for (std::uint32_t i = 0; i * rays_ < hits_.size(); ++i) {
      if (at(i, ray) && (!first || at(i, ray).t < at(*first, ray).t)) first = i;
    }
    return first;
  }

  std::size_t ray_count() const { return rays_; }
  std::size_t instance_count() const { return hits_.size() / rays_; }

 private:
  std::size_t rays_;
  std::vector<RayHit> hits_;
};

/// Summary of a ray: frames with hits, and the least t of all frames.
struct RayTally {
  struct First {
    std::uint32_t frame = 0, instance = 0;
    RayHit hit;
  };
  std::vector<std::uint32_t> frames;
  std::optional<First> first_hit;

  void add(std::uint32_t frame, const RayHits& hits, std::size_t ray) {
    const std::optional<std::uint32_t> first = hits.first(ray);
    if (!first) return;
    frames.push_back(frame);
    const RayHit& hit = hits.at(*first, ray);
    if (!first_hit || hit.t < first_hit->hit.t) first_hit = {frame, *first, hit};
  }
};

class RayQuery final : public FrameQuery {
 public:
  RayQuery(const scene::StagedScene& staged, const RaySettings& settings)
      : staged_(staged),
        settings_(settings),
        hits_(settings.rays.size(), staged.colliders.size()),
        tallies_(settings.rays.size()) {}

  QueryStats ask(std::span<Pose> poses) override;
  void keep(std::uint32_t frame) override;

  const char* format() const override { return "pelt-ray"; }
  nlohmann::ordered_json options_json() const override;
  void write_frame(scene::JsonLine& line) const override;
  void write_totals(scene::JsonLine& line) const override;
  void print(std::size_t frames, std::ostream& words) const override;

 private:
  scene::StagedScene staged_;
  RaySettings settings_;
  RayHits hits_;
  std::vector<RayTally> tallies_;  // of each ray
};

}  // namespace pelt::tools::query

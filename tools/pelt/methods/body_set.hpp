#pragma once

/// Bodies with palettes. Data that depends only on the model is prepared once for each model.

#include <pelt/model.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/palette.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace pelt::methods {

/// Traits have the types Body and Prepared (computed once for each model); the constant kMorphs
/// (whether morph weights and dual quaternions are known); and prepare(mesh), make_body(mesh,
/// prepared) and update(body, palette).
template <typename Traits>
class BodySet {
 public:
  using Body = typename Traits::Body;

  void add(const SkinnedModel& model) {
    auto& prepared = prepared_[&model.detail()];
    if (!prepared) prepared = std::make_unique<PreparedModel>(model);
    const detail::SkinnedMesh& mesh = prepared->mesh;
    palettes_.emplace_back(mesh.joint_count, mesh.rest_extent, mesh.morph_extents,
                           mesh.dual_influences);
    bodies_.push_back(Traits::make_body(mesh, prepared->prepared));
    update_work_ += Traits::update(*bodies_.back(), palettes_.back());
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) {
    const bool any = std::any_of(weights.begin(), weights.end(), [](float w) { return w != 0; });
    if (any && !Traits::kMorphs)
      return Error{ErrorCode::unsupported,
                   "this method has no bounds for morph targets: choose "
                   "on_demand, eager or brute with --method (pelt bench: --methods)"};
    return palettes_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) {
    if (palettes_[body].is_dual() && !Traits::kMorphs)
      return Error{ErrorCode::unsupported,
                   "this method has no bounds for dual quaternion skinning: choose "
                   "on_demand, eager or brute with --method (pelt bench: --methods)"};
    Result<void> taken = palettes_[body].set(palette);
    if (taken) update_work_ += Traits::update(*bodies_[body], palettes_[body]);
    return taken;
  }

  Body& operator[](std::uint32_t body) { return *bodies_[body]; }
  const detail::Palette& palette(std::uint32_t body) const { return palettes_[body]; }

  /// The work of all updates so far.
  const QueryStats& update_work() const { return update_work_; }

 private:
  struct PreparedModel {
    explicit PreparedModel(const SkinnedModel& m)
        : model(m), mesh(detail::unpack_mesh(m.detail().tree)), prepared(Traits::prepare(mesh)) {}

    SkinnedModel model;
    detail::SkinnedMesh mesh;
    typename Traits::Prepared prepared;
  };

  std::map<const detail::Model*, std::unique_ptr<PreparedModel>> prepared_;
  std::vector<detail::Palette> palettes_;
  std::vector<std::unique_ptr<Body>> bodies_;
  QueryStats update_work_;
};

}  // namespace pelt::methods

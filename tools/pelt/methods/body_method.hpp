#pragma once

/// A method made of bodies with palettes: prepares data that depends only on the model once for
/// each model, validates a palette for each body, sorts contacts, counts work.

#include <pelt/model.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/palette.hpp"
#include "tools/pelt/methods/method.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pelt::methods {

/// Traits have the types Body, Prepared (computed once for each model) and Scratch; the constants
/// kUpdateCounts and kMorphs (whether morph weights and dual quaternions are known); and
/// prepare(mesh), make_body(mesh, prepared), update(body, palette), and collide(a, palette of a, b,
/// palette of b, scratch, contacts, max_contacts), whose contacts may have any order.
template <typename Traits>
class BodyMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    auto& prepared = prepared_[&model.detail()];
    if (!prepared) prepared = std::make_unique<PreparedModel>(model);
    const detail::SkinnedMesh& mesh = prepared->mesh;
    palettes_.emplace_back(mesh.joint_count, mesh.rest_extent, mesh.morph_extents,
                           mesh.dual_influences);
    bodies_.push_back(Traits::make_body(mesh, prepared->prepared));
    update_work_ += Traits::update(*bodies_.back(), palettes_.back());
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    const bool any = std::any_of(weights.begin(), weights.end(), [](float w) { return w != 0; });
    if (any && !Traits::kMorphs) return unsupported("morph targets");
    return palettes_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    if (palettes_[body].is_dual() && !Traits::kMorphs)
      return unsupported("dual quaternion skinning");
    Result<void> taken = palettes_[body].set(palette);
    if (taken) update_work_ += Traits::update(*bodies_[body], palettes_[body]);
    return taken;
  }

  bool update_counts() const override { return Traits::kUpdateCounts; }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    const QueryStats work = Traits::collide(*bodies_[a], palettes_[a], *bodies_[b], palettes_[b],
                                            scratch_, contacts, limits.max_contacts);
    std::sort(contacts.begin() + first, contacts.end());
    return work;
  }

  QueryStats update_work() const override { return update_work_; }

  typename Traits::Body& body(std::uint32_t body) { return *bodies_[body]; }
  const detail::Palette& palette(std::uint32_t body) const { return palettes_[body]; }

 private:
  struct PreparedModel {
    explicit PreparedModel(const SkinnedModel& m)
        : model(m), mesh(detail::unpack_mesh(m.detail().tree)), prepared(Traits::prepare(mesh)) {}

    SkinnedModel model;
    detail::SkinnedMesh mesh;
    typename Traits::Prepared prepared;
  };

  static Error unsupported(const char* what) {
    return {ErrorCode::unsupported,
            std::string("this method has no bounds for ") + what +
                ": choose on_demand, eager or brute with --method (pelt bench: --methods)"};
  }

  std::map<const detail::Model*, std::unique_ptr<PreparedModel>> prepared_;
  std::vector<detail::Palette> palettes_;
  std::vector<std::unique_ptr<typename Traits::Body>> bodies_;
  QueryStats update_work_;
  typename Traits::Scratch scratch_;
};

}  // namespace pelt::methods

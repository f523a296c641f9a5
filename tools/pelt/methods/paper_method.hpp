#pragma once

/// The paper's method, as a method of the command.

#include "paper/breadth_first.hpp"
#include "paper/on_demand.hpp"
#include "tools/pelt/methods/body_method.hpp"

namespace pelt::methods {

/// Bodies of the paper that need their palette during queries.
template <typename Body_, typename Prepared_>
struct OnDemandTraits {
  using Prepared = Prepared_;
  using Body = Body_;
  using Scratch = paper::Scratch;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = false;

  static QueryStats update(Body& body, const detail::Palette&) {
    body.invalidate();
    return {};
  }
  static QueryStats collide(Body& a, const detail::Palette& palette_a, Body& b,
                            const detail::Palette& palette_b, paper::Scratch& scratch,
                            std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    using paper::collide;
    return collide(a, palette_a, b, palette_b, scratch, contacts, max_contacts);
  }
};

template <paper::BoundKind kBound>
struct PaperTraits : OnDemandTraits<paper::OnDemandBody, paper::SphereModel> {
  static Prepared prepare(const detail::SkinnedMesh& mesh) {
    return paper::build_sphere_model(mesh, kBound);
  }
  static std::unique_ptr<Body> make_body(const detail::SkinnedMesh& mesh, const Prepared& model) {
    return std::make_unique<Body>(mesh, model);
  }
};

}  // namespace pelt::methods

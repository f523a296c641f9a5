#include "evaluation/methods/lab_methods.hpp"
#include "paper/eager.hpp"
#include "paper/rigid.hpp"
#include "tools/pelt/methods/paper_method.hpp"

namespace pelt::lab {
namespace {

using methods::BodyMethod;
using methods::PaperTraits;

using detail::Palette;
using detail::SkinnedMesh;

/// Bodies that do all their work when the palette is set.
template <typename Body_, typename Prepared_>
struct UpdatedTraits {
  using Prepared = Prepared_;
  using Body = Body_;
  using Scratch = paper::Scratch;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = true;

  static QueryStats update(Body& body, const Palette& palette) { return body.update(palette); }
  static QueryStats collide(Body& a, const Palette&, Body& b, const Palette&,
                            paper::Scratch& scratch, std::vector<Contact>& contacts,
                            std::uint32_t max_contacts) {
    using paper::collide;
    return collide(a, b, scratch, contacts, max_contacts);
  }
};

struct PaperEagerTraits : UpdatedTraits<paper::EagerBody, paper::SphereTree> {
  static Prepared prepare(const SkinnedMesh& mesh) {
    return paper::build_sphere_tree(mesh.rest_positions, mesh.triangles);
  }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Prepared& tree) {
    return std::make_unique<Body>(mesh, tree);
  }
};

struct Nothing {};

struct PaperRigidTraits : UpdatedTraits<paper::RigidBody, Nothing> {
  static constexpr bool kUpdateCounts = false;

  static Nothing prepare(const SkinnedMesh&) { return {}; }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Nothing&) {
    return std::make_unique<Body>(mesh);
  }
};

}  // namespace

std::unique_ptr<Method> make_paper_eq2() {
  return std::make_unique<BodyMethod<PaperTraits<paper::BoundKind::plain>>>();
}

std::unique_ptr<Method> make_paper_eager() {
  return std::make_unique<BodyMethod<PaperEagerTraits>>();
}

std::unique_ptr<Method> make_paper_rigid() {
  return std::make_unique<BodyMethod<PaperRigidTraits>>();
}

}  // namespace pelt::lab

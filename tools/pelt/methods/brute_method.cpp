#include "tools/pelt/methods/body_method.hpp"
#include "tools/pelt/methods/brute_force.hpp"
#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::methods {
namespace {

using detail::Palette;
using detail::SkinnedMesh;

struct Nothing {};

struct BruteTraits {
  using Prepared = Nothing;
  using Body = BruteForceBody;
  using Scratch = Nothing;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = true;

  static Nothing prepare(const SkinnedMesh&) { return {}; }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Nothing&) {
    return std::make_unique<Body>(mesh);
  }
  static QueryStats update(Body& body, const Palette& palette) { return body.update(palette); }
  static QueryStats collide(Body& a, const Palette&, Body& b, const Palette&, Nothing&,
                            std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    return brute_force_collide(a.triangles(), a.positions(), b.triangles(), b.positions(), contacts,
                               max_contacts);
  }
};

}  // namespace

std::unique_ptr<Method> make_brute() { return std::make_unique<BodyMethod<BruteTraits>>(); }

}  // namespace pelt::methods

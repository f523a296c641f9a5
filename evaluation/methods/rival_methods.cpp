#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "evaluation/rivals/bd_tree.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"
#include "tools/pelt/methods/paper_method.hpp"

namespace pelt::lab {
namespace {

using methods::BodyMethod;
using methods::OnDemandTraits;

struct BdTraits : OnDemandTraits<rivals::BdBody, rivals::BdModel> {
  static Prepared prepare(const detail::SkinnedMesh& mesh) { return Prepared(mesh); }
  static std::unique_ptr<Body> make_body(const detail::SkinnedMesh& mesh, const Prepared& model) {
    return std::make_unique<Body>(model, mesh.joint_count);
  }
};

}  // namespace

std::unique_ptr<Method> make_aabb_refit() { return adapt(rivals::make_aabb_refit()); }
std::unique_ptr<Method> make_aabb_rebuild() { return adapt(rivals::make_aabb_rebuild()); }
std::unique_ptr<Method> make_hybrid() { return adapt(rivals::make_hybrid()); }
std::unique_ptr<Method> make_hash() { return adapt(rivals::make_hash()); }
std::unique_ptr<Method> make_hash_overlap() { return adapt(rivals::make_hash_overlap()); }
std::unique_ptr<Method> make_bd_tree() { return std::make_unique<BodyMethod<BdTraits>>(); }

}  // namespace pelt::lab

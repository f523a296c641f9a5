/// The structure behind the public functions: the paper's sphere tree. The one file of src that
/// includes paper/.

#include "model/engine.hpp"
#include "paper/on_demand.hpp"

namespace pelt::detail {

struct Engine {
  const SkinnedMesh& mesh;
  paper::SphereModel model;
};

struct EnginePose {
  paper::OnDemandBody body;
};

std::shared_ptr<const Engine> build_engine(const SkinnedMesh& mesh) {
  return std::make_shared<const Engine>(Engine{mesh, paper::build_sphere_model(mesh)});
}

EnginePoseHandle make_engine_pose(const Engine& engine) {
  return {new EnginePose{paper::OnDemandBody(engine.mesh, engine.model)},
          [](EnginePose* pose) { delete pose; }};
}

void invalidate(EnginePose& pose) { pose.body.invalidate(); }

QueryStats engine_collide(const EngineSide& a, const EngineSide& b, Scratch& scratch,
                          std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  return paper::collide(a.pose.body, a.palette, b.pose.body, b.palette, scratch, contacts,
                        max_contacts);
}

}  // namespace pelt::detail

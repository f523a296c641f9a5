#include "evaluation/methods/posed_mesh_adapter.hpp"

#include "model/model.hpp"
#include "model/unpack.hpp"

#include <algorithm>
#include <map>

namespace pelt::lab {
namespace {

using methods::Method;

class PosedMeshAdapter final : public Method {
 public:
  explicit PosedMeshAdapter(std::unique_ptr<rivals::PosedMeshMethod> method)
      : method_(std::move(method)) {}

  void add(const SkinnedModel& model) override {
    const auto mesh = meshes_.try_emplace(&model.detail(), unpack(model)).first;
    bodies_.push_back({Pose(model), std::vector<Vec3>(model.vertex_count())});
    method_->add(mesh->second.triangles, mesh->second.rest_positions);
    update(static_cast<std::uint32_t>(bodies_.size() - 1));
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body].pose.set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    Result<void> taken = bodies_[body].pose.set_palette(palette);
    if (taken) update(body);
    return taken;
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    const QueryStats work = method_->collide(a, b, contacts, limits.max_contacts);
    std::sort(contacts.begin() + first, contacts.end());
    return work;
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct Body {
    Pose pose;
    std::vector<Vec3> positions;
  };

  static detail::SkinnedMesh unpack(const SkinnedModel& model) {
    return detail::unpack_mesh(model.detail().tree);
  }

  void update(std::uint32_t body) {
    Body& posed = bodies_[body];
    posed_vertices(posed.pose, posed.positions);
    update_work_.posed_vertices += posed.positions.size();
    method_->update(body, posed.positions);
  }

  std::unique_ptr<rivals::PosedMeshMethod> method_;
  std::map<const detail::Model*, detail::SkinnedMesh> meshes_;
  std::vector<Body> bodies_;
  QueryStats update_work_;
};

}  // namespace

std::unique_ptr<Method> adapt(std::unique_ptr<rivals::PosedMeshMethod> method) {
  return std::make_unique<PosedMeshAdapter>(std::move(method));
}

}  // namespace pelt::lab

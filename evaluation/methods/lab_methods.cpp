#include "evaluation/methods/lab_methods.hpp"

#include "collide/eager.hpp"
#include "evaluation/rivals/bd_tree.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "paper/eager.hpp"
#include "paper/rigid.hpp"
#include "self/neighbours.hpp"
#include "skin/skin.hpp"
#include "tools/pelt/methods/brute_force.hpp"
#include "tools/pelt/methods/paper_method.hpp"

#include <algorithm>
#include <map>

namespace pelt::lab {
namespace {

using detail::Palette;
using detail::SkinnedMesh;
using methods::BodyMethod;
using methods::OnDemandTraits;
using methods::PaperTraits;

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

namespace {

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

namespace {

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

namespace {

class SelfEagerMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    bodies_.push_back(std::make_unique<Body>(model));
    update_work_ += bodies_.back()->pose.open_all();
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    if (const auto taken = bodies_[body]->palette.set_morph_weights(weights); !taken) return taken;
    return bodies_[body]->pose.set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    if (const auto taken = bodies_[body]->pose.set_palette(palette); !taken) return taken;
    update_work_ += bodies_[body]->pose.open_all();
    return bodies_[body]->palette.set(palette);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    Body& body = *bodies_[a];
    found_.clear();
    const QueryStats work = detail::collide(body.pose, body.pose, scratch_, found_, {});
    body.skin();
    const std::size_t most = contacts.size() + limits.max_contacts;
    for (const Contact& contact : found_) {
      if (contact.triangle_a >= contact.triangle_b || !body.intersect(contact)) continue;
      if (contacts.size() == most) break;
      contacts.push_back(contact);
    }
    return work;
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct Body {
    explicit Body(const SkinnedModel& m)
        : model(m),
          mesh(detail::unpack_mesh(m.detail().tree)),
          surface(methods::surface_vertices(mesh)),
          positions(mesh.vertex_count()),
          pose(model.detail().tree),
          palette(mesh.joint_count, mesh.rest_extent, mesh.morph_extents) {}

    /// The vertices of the caller's numbers, which neighbours are decided by.
    void skin() { detail::posed_vertices(mesh, palette, positions); }

    detail::SurfaceTriangle triangle(std::uint32_t t) const {
      const Triangle& v = mesh.triangles[t];
      return {{positions[v[0]], positions[v[1]], positions[v[2]]},
              {surface[v[0]], surface[v[1]], surface[v[2]]}};
    }

    bool intersect(const Contact& contact) const {
      const detail::SurfaceTriangle s = triangle(contact.triangle_a);
      const detail::SurfaceTriangle t = triangle(contact.triangle_b);
      const bool share_none =
          std::find_first_of(s.vertices.begin(), s.vertices.end(), t.vertices.begin(),
                             t.vertices.end()) == s.vertices.end();
      return share_none || detail::surface_triangles_intersect(s, t);
    }

    SkinnedModel model;
    detail::SkinnedMesh mesh;
    std::vector<std::uint32_t> surface;
    std::vector<Vec3> positions;
    detail::EagerPose pose;
    detail::Palette palette;
  };

  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<Contact> found_;
  detail::Scratch scratch_;
  QueryStats update_work_;
};

}  // namespace

std::unique_ptr<Method> make_self_eager() { return std::make_unique<SelfEagerMethod>(); }

}  // namespace pelt::lab

#include "collide/eager.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "self/neighbours.hpp"
#include "skin/skin.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <algorithm>

namespace pelt::lab {
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

#include "evaluation/methods/moving_methods.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "motion/meeting_order.hpp"
#include "motion/moving_filter.hpp"
#include "skin/palette.hpp"
#include "skin/skin.hpp"

#include "geometry/triangle_pair.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pelt::lab {
namespace {

using detail::MovingTriangle;

/// The extent of what moves, over the whole step.
struct Extent {
  Vec3 low, high;

  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }

  /// Without branches, because it runs for all pairs.
  bool overlaps(const Extent& other) const {
    return (low.x <= other.high.x) & (other.low.x <= high.x) & (low.y <= other.high.y) &
           (other.low.y <= high.y) & (low.z <= other.high.z) & (other.low.z <= high.z);
  }
};

struct NumberedTriangle {
  MovingTriangle corners;
  std::uint32_t triangle;
};

/// Triangles of one body, with their extents apart, because all pairs of extents are compared.
struct Triangles {
  std::vector<NumberedTriangle> all;
  std::vector<Extent> extents;
};

/// The vertices of one body at both ends of a step.
class MovingVertices {
 public:
  explicit MovingVertices(const detail::SkinnedMesh& mesh)
      : mesh_(mesh),
        palette_(mesh.joint_count, mesh.rest_extent, mesh.morph_extents, mesh.dual_influences),
        from_(mesh.vertex_count()),
        to_(mesh.vertex_count()) {
    skin();
    from_ = to_;
  }

  void begin_step() { std::swap(from_, to_); }

  Result<void> set_morph_weights(std::span<const float> weights) {
    return palette_.set_morph_weights(weights);
  }

  Result<void> set_palette(std::span<const Matrix4> palette) {
    Result<void> taken = palette_.set(palette);
    if (taken) skin();
    return taken;
  }

  std::size_t vertex_count() const { return to_.size(); }

  Extent extent() const {
    Extent extent = {to_[0], to_[0]};
    for (const std::vector<Vec3>* end : {&from_, &to_})
      for (const Vec3& p : *end) extent.add(p);
    return extent;
  }

  /// The triangles whose extents overlap `where`.
  Triangles triangles_in(const Extent& where) const {
    Triangles found;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& v = mesh_.triangles[t];
      const MovingTriangle moving = {{from_[v[0]], from_[v[1]], from_[v[2]]},
                                     {to_[v[0]], to_[v[1]], to_[v[2]]}};
      Extent extent = {moving.from[0], moving.from[0]};
      for (const auto* end : {&moving.from, &moving.to})
        for (const Vec3& corner : *end) extent.add(corner);
      if (!extent.overlaps(where)) continue;
      found.all.push_back({moving, t});
      found.extents.push_back(extent);
    }
    return found;
  }

 private:
  void skin() { detail::posed_vertices(mesh_, palette_, to_); }

  const detail::SkinnedMesh& mesh_;
  detail::Palette palette_;
  std::vector<Vec3> from_, to_;
};

/// Calls `visit(a, b)` for each pair of triangles whose extents overlap, ascending, until it
/// returns false.
template <typename Visit>
void visit_pairs(const MovingVertices& a, const MovingVertices& b, const Visit& visit) {
  const Triangles all_a = a.triangles_in(b.extent()), all_b = b.triangles_in(a.extent());
  for (std::size_t i = 0; i < all_a.all.size(); ++i)
    for (std::size_t k = 0; k < all_b.all.size(); ++k)
      if (all_a.extents[i].overlaps(all_b.extents[k]) && !visit(all_a.all[i], all_b.all[k])) return;
}

bool intersect_at_start(const MovingTriangle& a, const MovingTriangle& b) {
  return detail::triangles_intersect(a.from, b.from);
}

/// Empty if the triangles never intersect.
std::optional<MovingContact> contact_of(const NumberedTriangle& a, const NumberedTriangle& b,
                                        const MovingOptions& options, MovingStats& work) {
  const Contact contact = {a.triangle, b.triangle};
  if (!options.times) {
    if (options.leave_out_start && intersect_at_start(a.corners, b.corners)) return {};
    if (!detail::intersect_while_moving(a.corners, b.corners, work)) return {};
    return MovingContact{contact, 0, false, {}, {}};
  }
  const auto first = detail::find_first_meeting(a.corners, b.corners, work);
  if (!first || (options.leave_out_start && first->at_start)) return {};
  return detail::moving_contact(contact, *first);
}

class MovingBrute final : public MovingMethod {
 public:
  void add(const SkinnedModel& model) override {
    auto& prepared = meshes_[&model.detail()];
    if (!prepared) prepared = std::make_unique<PreparedMesh>(model);
    bodies_.emplace_back(prepared->mesh);
    update_work_.posed_vertices += 2 * bodies_.back().vertex_count();
  }

  void begin_step() override {
    for (MovingVertices& body : bodies_) body.begin_step();
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    update_work_.posed_vertices += bodies_[body].vertex_count();
    return bodies_[body].set_palette(palette);
  }

  QueryStats collide_at_end(std::uint32_t a, std::uint32_t b,
                            std::vector<Contact>& contacts) override {
    MovingStats work;
    visit_pairs(bodies_[a], bodies_[b], [&](const auto& p, const auto& q) {
      ++work.triangle_pairs;
      if (detail::triangles_intersect(p.corners.to, q.corners.to))
        contacts.push_back({p.triangle, q.triangle});
      return true;
    });
    return work;
  }

  MovingStats collide_moving(std::uint32_t a, std::uint32_t b, std::vector<MovingContact>& contacts,
                             const MovingOptions& options) override {
    MovingStats work;
    std::uint32_t found = 0;
    visit_pairs(bodies_[a], bodies_[b], [&](const auto& p, const auto& q) {
      ++work.triangle_pairs;
      const std::optional<MovingContact> contact = contact_of(p, q, options, work);
      if (contact) contacts.push_back(*contact), ++found;
      return found < options.max_contacts;
    });
    return work;
  }

  MovingStats first_contact(std::uint32_t a, std::uint32_t b,
                            std::optional<MovingContact>& first) override {
    MovingStats work;
    detail::EarliestPair earliest;
    first.reset();
    visit_pairs(bodies_[a], bodies_[b], [&](const auto& p, const auto& q) {
      ++work.triangle_pairs;
      const Contact contact = {p.triangle, q.triangle};
      if (intersect_at_start(p.corners, q.corners))
        first = {contact, 0, true, {}, {}};
      else
        earliest.add(contact, p.corners, q.corners, work);
      return !first;
    });
    if (!first) first = earliest.contact();
    return work;
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct PreparedMesh {
    explicit PreparedMesh(const SkinnedModel& m)
        : model(m), mesh(detail::unpack_mesh(m.detail().tree)) {}

    SkinnedModel model;
    detail::SkinnedMesh mesh;
  };

  std::map<const detail::Model*, std::unique_ptr<PreparedMesh>> meshes_;
  std::vector<MovingVertices> bodies_;
  QueryStats update_work_;
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_brute() { return std::make_unique<MovingBrute>(); }

}  // namespace pelt::lab

#include "tools/pelt/methods/brute_force.hpp"

#include <pelt/math.hpp>

#include "geometry/triangle_pair.hpp"
#include "self/neighbours.hpp"
#include "skin/skin.hpp"
#include "tools/pelt/methods/body_method.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <memory>

namespace pelt::methods {
namespace {

using detail::Palette;
using detail::SkinnedMesh;
using SurfaceVertices = std::vector<std::uint32_t>;

struct PosedTriangle {
  detail::TriangleCorners corners;
  Box box;
  std::uint32_t triangle;
};

Vec3 low(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3 high(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

Box box_of(std::span<const Vec3> points) {
  Box box = {points[0], points[0]};
  for (const Vec3& p : points) box = {low(box.low, p), high(box.high, p)};
  return box;
}

/// Whether two boxes overlap. Has no branches, because it runs for all pairs.
bool boxes_meet(const Box& a, const Box& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
         (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

/// The triangles whose boxes overlap `where`; no others can touch anything inside it.
std::vector<PosedTriangle> triangles_in(const Box& where, std::span<const Triangle> triangles,
                                        std::span<const Vec3> positions) {
  std::vector<PosedTriangle> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& v = triangles[t];
    const detail::TriangleCorners corners = {positions[v[0]], positions[v[1]], positions[v[2]]};
    const Box box = box_of(corners);
    if (boxes_meet(box, where)) found.push_back({corners, box, t});
  }
  return found;
}

/// The bits that vertices of one surface vertex have in common.
std::vector<std::uint32_t> bits_of(const SkinnedMesh& mesh, std::uint32_t vertex) {
  std::vector<std::uint32_t> bits;
  const auto add = [&](const Vec3& v) {
    for (const float c : {v.x, v.y, v.z}) bits.push_back(std::bit_cast<std::uint32_t>(c));
  };
  const Vec3& p = mesh.rest_positions[vertex];
  add({p.x + 0.0F, p.y + 0.0F, p.z + 0.0F});  // turns -0.0 into 0.0
  for (const detail::Displacement& displacement : mesh.displacements_of(vertex)) {
    bits.push_back(displacement.target);
    add(displacement.by);
  }
  return bits;
}

/// Sweeps a plane along y. `active_` has the triangles that reach the plane.
class Sweep {
 public:
  Sweep(std::span<const Triangle> triangles, std::span<const Vec3> positions,
        const SurfaceVertices& surface) {
    for (const Triangle& t : triangles) {
      triangles_.push_back({{positions[t[0]], positions[t[1]], positions[t[2]]},
                            {surface[t[0]], surface[t[1]], surface[t[2]]}});
      boxes_.push_back(box_of(triangles_.back().corners));
      order_.push_back(static_cast<std::uint32_t>(order_.size()));
    }
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t s, std::uint32_t t) {
      return boxes_[s].low.y < boxes_[t].low.y;
    });
  }

  /// Appends the contacts, in no particular order.
  QueryStats run(std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    const std::size_t most = contacts.size() + max_contacts;
    for (const std::uint32_t s : order_) {
      std::erase_if(active_, [&](std::uint32_t t) { return boxes_[t].high.y < boxes_[s].low.y; });
      for (const std::uint32_t t : active_) {
        if (!boxes_meet(boxes_[s], boxes_[t])) continue;
        ++work_.triangle_pairs;
        if (!surface_triangles_intersect(triangles_[s], triangles_[t])) continue;
        work_.cut_short = contacts.size() == most;
        if (work_.cut_short) return work_;
        contacts.push_back({std::min(s, t), std::max(s, t)});
      }
      active_.push_back(s);
    }
    return work_;
  }

 private:
  std::vector<detail::SurfaceTriangle> triangles_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_, active_;
  QueryStats work_;
};

struct Nothing {};

/// A mesh whose vertices are all skinned for each palette.
class BruteForceBody {
 public:
  explicit BruteForceBody(const SkinnedMesh& mesh) : mesh_(mesh), positions_(mesh.vertex_count()) {}

  QueryStats update(const Palette& palette) {
    detail::posed_vertices(mesh_, palette, positions_);
    QueryStats work;
    work.posed_vertices = positions_.size();
    return work;
  }

  std::span<const Triangle> triangles() const { return mesh_.triangles; }
  std::span<const Vec3> positions() const { return positions_; }

 private:
  const SkinnedMesh& mesh_;
  std::vector<Vec3> positions_;
};

/// The members that the traits of both oracles share.
struct SkinnedTraits {
  using Scratch = Nothing;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = true;

  static QueryStats update(BruteForceBody& body, const Palette& palette) {
    return body.update(palette);
  }
};

struct BruteTraits : SkinnedTraits {
  using Prepared = Nothing;
  using Body = BruteForceBody;

  static Nothing prepare(const SkinnedMesh&) { return {}; }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Nothing&) {
    return std::make_unique<Body>(mesh);
  }
  static QueryStats collide(Body& a, const Palette&, Body& b, const Palette&, Nothing&,
                            std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    return brute_force_collide(a.triangles(), a.positions(), b.triangles(), b.positions(), contacts,
                               max_contacts);
  }
};

/// A mesh posed by brute force, with its surface vertices.
struct SurfaceBody : BruteForceBody {
  SurfaceBody(const SkinnedMesh& mesh, const SurfaceVertices& s)
      : BruteForceBody(mesh), surface(s) {}

  const SurfaceVertices& surface;
};

struct SelfBruteTraits : SkinnedTraits {
  using Prepared = SurfaceVertices;
  using Body = SurfaceBody;

  static SurfaceVertices prepare(const SkinnedMesh& mesh) { return surface_vertices(mesh); }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const SurfaceVertices& surface) {
    return std::make_unique<Body>(mesh, surface);
  }
  static QueryStats collide(Body& body, const Palette&, Body&, const Palette&, Nothing&,
                            std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    return Sweep(body.triangles(), body.positions(), body.surface).run(contacts, max_contacts);
  }
};

}  // namespace

QueryStats brute_force_collide(std::span<const Triangle> triangles_a,
                               std::span<const Vec3> positions_a,
                               std::span<const Triangle> triangles_b,
                               std::span<const Vec3> positions_b, std::vector<Contact>& contacts,
                               std::uint32_t max_contacts) {
  const auto all_a = triangles_in(box_of(positions_b), triangles_a, positions_a);
  const auto all_b = triangles_in(box_of(positions_a), triangles_b, positions_b);
  QueryStats stats;
  std::uint32_t found = 0;
  for (const PosedTriangle& a : all_a)
    for (const PosedTriangle& b : all_b) {
      if (!boxes_meet(a.box, b.box)) continue;
      if (found == max_contacts) {
        stats.cut_short = true;
        return stats;
      }
      ++stats.triangle_pairs;
      if (!detail::triangles_intersect(a.corners, b.corners)) continue;
      contacts.push_back(Contact{a.triangle, b.triangle});
      ++found;
    }
  return stats;
}

std::unique_ptr<Method> make_brute() { return std::make_unique<BodyMethod<BruteTraits>>(); }

std::vector<std::uint32_t> surface_vertices(const SkinnedMesh& mesh) {
  std::map<std::vector<std::uint32_t>, std::uint32_t> lowest;
  std::vector<std::uint32_t> surface;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
    surface.push_back(lowest.emplace(bits_of(mesh, v), v).first->second);
  return surface;
}

std::unique_ptr<Method> make_self_brute() {
  return std::make_unique<BodyMethod<SelfBruteTraits>>();
}

}  // namespace pelt::methods

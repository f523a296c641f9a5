#include "self/neighbour_pair.hpp"
#include "tools/pelt/methods/body_method.hpp"
#include "tools/pelt/methods/brute_force.hpp"
#include "tools/pelt/methods/self_methods.hpp"

#include <algorithm>
#include <bit>
#include <map>

namespace pelt::methods {
namespace {

using detail::Palette;
using detail::SkinnedMesh;
using detail::SurfaceTriangle;
using SurfaceVertices = std::vector<std::uint32_t>;

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

struct Extent {
  Vec3 low, high;
};

Extent extent_of(const detail::TriangleCorners& corners) {
  Extent extent = {corners[0], corners[0]};
  for (const Vec3& p : corners) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y),
                  std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                   std::max(extent.high.z, p.z)};
  }
  return extent;
}

bool overlap_in_x_and_z(const Extent& a, const Extent& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.z <= b.high.z) &
         (b.low.z <= a.high.z);
}

/// Sweeps a plane along y. `active_` has the triangles that reach the plane.
class Sweep {
 public:
  Sweep(std::span<const Triangle> triangles, std::span<const Vec3> positions,
        const SurfaceVertices& surface) {
    for (const Triangle& t : triangles) {
      triangles_.push_back({{positions[t[0]], positions[t[1]], positions[t[2]]},
                            {surface[t[0]], surface[t[1]], surface[t[2]]}});
      extents_.push_back(extent_of(triangles_.back().corners));
      order_.push_back(static_cast<std::uint32_t>(order_.size()));
    }
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t s, std::uint32_t t) {
      return extents_[s].low.y < extents_[t].low.y;
    });
  }

  /// Appends the contacts, in no particular order.
  QueryStats run(std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    const std::size_t most = contacts.size() + max_contacts;
    for (const std::uint32_t s : order_) {
      std::erase_if(active_,
                    [&](std::uint32_t t) { return extents_[t].high.y < extents_[s].low.y; });
      for (const std::uint32_t t : active_) {
        if (!overlap_in_x_and_z(extents_[s], extents_[t])) continue;
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
  std::vector<SurfaceTriangle> triangles_;
  std::vector<Extent> extents_;
  std::vector<std::uint32_t> order_, active_;
  QueryStats work_;
};

/// A mesh posed by brute force, with its surface vertices.
struct SurfaceBody : BruteForceBody {
  SurfaceBody(const SkinnedMesh& mesh, const SurfaceVertices& s)
      : BruteForceBody(mesh), surface(s) {}

  const SurfaceVertices& surface;
};

struct NoScratch {};

struct SelfBruteTraits {
  using Prepared = SurfaceVertices;
  using Body = SurfaceBody;
  using Scratch = NoScratch;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = true;

  static SurfaceVertices prepare(const SkinnedMesh& mesh) { return surface_vertices(mesh); }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const SurfaceVertices& surface) {
    return std::make_unique<Body>(mesh, surface);
  }
  static QueryStats update(Body& body, const Palette& palette) { return body.update(palette); }
  static QueryStats collide(Body& body, const Palette&, Body&, const Palette&, NoScratch&,
                            std::vector<Contact>& contacts, std::uint32_t max_contacts) {
    return Sweep(body.triangles(), body.positions(), body.surface).run(contacts, max_contacts);
  }
};

}  // namespace

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

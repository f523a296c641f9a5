#pragma once

/// Moving bodies for testing rivals, and the answer of brute force.

#include "geometry/triangle_pair.hpp"
#include "support/random.hpp"

#include <pelt/collide.hpp>
#include <pelt/mesh.hpp>

#include <vector>

namespace pelt::test {

using Contacts = std::vector<Contact>;
using Positions = std::vector<Vec3>;

/// A body in a few frames; the first is its rest pose.
struct PosedBody {
  std::vector<Triangle> triangles;
  std::vector<Positions> frames;
};

struct PosedBodies {
  PosedBody a, b;
};

/// Separate triangles. `place(random)` is the position of one, and `size(random)` the distance of
/// its vertices from there. They move from frame to frame.
template <typename Place, typename Size>
PosedBody scattered(Random& random, std::uint32_t count, std::uint32_t frames, const Place& place,
                    const Size& size) {
  PosedBody body;
  body.frames.resize(frames);
  for (std::uint32_t t = 0; t < count; ++t) {
    body.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    const double reach = size(random);
    for (Positions& frame : body.frames) {
      const Vec3 centre = place(random);
      for (int k = 0; k < 3; ++k) {
        const Vec3 offset = random.point(reach);
        frame.push_back({centre.x + offset.x, centre.y + offset.y, centre.z + offset.z});
      }
    }
  }
  return body;
}

inline Contacts all_contacts(const PosedBodies& bodies, std::size_t frame) {
  const auto corners = [frame](const PosedBody& body, std::uint32_t t) {
    const Positions& p = body.frames[frame];
    const Triangle& v = body.triangles[t];
    return detail::TriangleCorners{p[v[0]], p[v[1]], p[v[2]]};
  };
  Contacts contacts;
  for (std::uint32_t a = 0; a < bodies.a.triangles.size(); ++a)
    for (std::uint32_t b = 0; b < bodies.b.triangles.size(); ++b)
      if (detail::triangles_intersect(corners(bodies.a, a), corners(bodies.b, b)))
        contacts.push_back({a, b});
  return contacts;
}

}  // namespace pelt::test

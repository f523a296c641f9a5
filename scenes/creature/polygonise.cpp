#include "scenes/creature/polygonise.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace pelt::scenes {
namespace {

constexpr std::uint32_t kBlock = 4;  // cells along the side of the smallest cube
constexpr double kEndMargin = 0.12;

struct Cell {
  std::uint32_t x = 0, y = 0, z = 0;
};

/// Lattice nodes are numbered along each axis from `origin`.
struct Lattice {
  Vec3d origin;
  double spacing = 0;
  std::uint32_t cells = 0;  ///< along each axis, a power of two

  Vec3d position(double x, double y, double z) const { return origin + spacing * Vec3d(x, y, z); }
};

Lattice lattice_around(const Flesh& flesh, double spacing) {
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3d low(infinity, infinity, infinity), high(-infinity, -infinity, -infinity);
  for (const Limb& limb : flesh.limbs) {
    const Vec3d& c = limb.bound.centre;
    const double r = limb.bound.radius;
    low = {std::min(low.x, c.x - r), std::min(low.y, c.y - r), std::min(low.z, c.z - r)};
    high = {std::max(high.x, c.x + r), std::max(high.y, c.y + r), std::max(high.z, c.z + r)};
  }
  const Vec3d size = high - low;
  const double largest = std::max({size.x, size.y, size.z}) + 4 * spacing;
  Lattice lattice = {{}, spacing, kBlock};
  while (lattice.cells * spacing < largest) lattice.cells *= 2;
  const double half = lattice.cells * spacing / 2;
  lattice.origin = mix(low, high, 0.5) - Vec3d(half, half, half);
  return lattice;
}

/// A point where the surface crosses an edge of the lattice. The key identifies the edge, so that
/// all tetrahedra around it share the vertex.
struct Crossing {
  std::uint64_t edge = 0;
  double t = 0;              ///< from the lower to the upper node
  std::uint64_t corner = 0;  ///< corner of the mesh: 3 * triangle + 0..2
};

class Polygoniser {
 public:
  Polygoniser(const Flesh& flesh, double spacing)
      : flesh_(flesh), lattice_(lattice_around(flesh, spacing)) {}

  RawMesh run() {
    descend({}, lattice_.cells);
    return assemble();
  }

 private:
  /// A corner of a tetrahedron: a corner of its cell, bit 0, 1, 2 for x, y, z.
  struct TetCorner {
    std::uint32_t bits = 0;
    double value = 0;
  };
  using Tet = std::array<TetCorner, 4>;

  void descend(const Cell& low, std::uint32_t size);
  void march_block(const Cell& low);
  void march_cell(const Cell& low, const std::array<double, 8>& values);
  void march_tet(const Cell& low, const Tet& tet);
  void emit(const Cell& low, const TetCorner& inside, const TetCorner& outside);
  RawMesh assemble();
  Vec3d crossing_position(const Crossing& crossing) const;

  std::uint64_t nodes_along() const { return std::uint64_t{lattice_.cells} + 1; }

  const Flesh& flesh_;
  Lattice lattice_;
  std::vector<Crossing> crossings_;
};

// The distance changes by at most 1 per unit of length, so a cube whose centre is farther from the
// surface than from its corners contains no surface.
void Polygoniser::descend(const Cell& low, std::uint32_t size) {
  const double half = size / 2.0;
  const Vec3d centre = lattice_.position(low.x + half, low.y + half, low.z + half);
  const double reach = 1.7320508075688774 * half * lattice_.spacing;
  if (std::abs(sample_flesh(flesh_, centre).distance) > 1.001 * reach) return;
  if (size == kBlock) return march_block(low);
  const std::uint32_t s = size / 2;
  for (std::uint32_t child = 0; child < 8; ++child) {
    descend({low.x + s * (child & 1), low.y + s * (child >> 1 & 1), low.z + s * (child >> 2)}, s);
  }
}

void Polygoniser::march_block(const Cell& low) {
  constexpr std::uint32_t kNodes = kBlock + 1;
  std::array<double, std::size_t{kNodes} * kNodes * kNodes> values;
  const auto index = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (z * kNodes + y) * kNodes + x;
  };
  for (std::uint32_t z = 0; z < kNodes; ++z) {
    for (std::uint32_t y = 0; y < kNodes; ++y) {
      for (std::uint32_t x = 0; x < kNodes; ++x) {
        const Vec3d p = lattice_.position(low.x + x, low.y + y, low.z + z);
        values[index(x, y, z)] = sample_flesh(flesh_, p).distance;
      }
    }
  }
  for (std::uint32_t cell = 0; cell < kBlock * kBlock * kBlock; ++cell) {
    const std::uint32_t x = cell % kBlock, y = cell / kBlock % kBlock, z = cell / kBlock / kBlock;
    std::array<double, 8> corners;
    for (std::uint32_t bits = 0; bits < 8; ++bits) {
      corners[bits] = values[index(x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2))];
    }
    march_cell({low.x + x, low.y + y, low.z + z}, corners);
  }
}

// The cell's six tetrahedra share its diagonal: one for each order of the three axes on a path from
// corner 0 to corner 7, with positive volume.
void Polygoniser::march_cell(const Cell& low, const std::array<double, 8>& values) {
  constexpr std::uint32_t kTets[6][4] = {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7},
                                         {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}};
  bool any_inside = false, any_outside = false;
  for (double value : values) (value < 0 ? any_inside : any_outside) = true;
  if (!any_inside || !any_outside) return;
  for (const auto& corners : kTets) {
    Tet tet;
    for (int i = 0; i < 4; ++i) tet[i] = {corners[i], values[corners[i]]};
    march_tet(low, tet);
  }
}

// An even permutation moves the corners inside the surface to the front. The surface then crosses
// the edges from these to the other corners, and the order below makes it face outwards.
void Polygoniser::march_tet(const Cell& low, const Tet& tet) {
  constexpr std::uint32_t kOrder[16][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3},
                                           {2, 0, 1, 3}, {0, 2, 3, 1}, {1, 2, 0, 3}, {3, 0, 2, 1},
                                           {3, 0, 2, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}, {2, 0, 1, 3},
                                           {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}, {0, 1, 2, 3}};
  std::uint32_t inside = 0;
  for (std::uint32_t i = 0; i < 4; ++i) inside |= (tet[i].value < 0 ? 1u : 0u) << i;
  if (inside == 0 || inside == 15) return;

  const auto& order = kOrder[inside];
  const TetCorner &a = tet[order[0]], &b = tet[order[1]], &c = tet[order[2]], &d = tet[order[3]];
  const int inside_count = (a.value < 0) + (b.value < 0) + (c.value < 0) + (d.value < 0);
  const auto triangle = [&](const TetCorner& i0, const TetCorner& o0, const TetCorner& i1,
                            const TetCorner& o1, const TetCorner& i2, const TetCorner& o2) {
    emit(low, i0, o0);
    emit(low, i1, o1);
    emit(low, i2, o2);
  };
  if (inside_count == 1) {
    triangle(a, b, a, c, a, d);
  } else if (inside_count == 2) {
    triangle(a, c, a, d, b, d);
    triangle(a, c, b, d, b, c);
  } else {  // `a` is outside
    triangle(d, a, c, a, b, a);
  }
}

void Polygoniser::emit(const Cell& low, const TetCorner& inside, const TetCorner& outside) {
  const std::uint32_t lower = inside.bits & outside.bits, direction = inside.bits ^ outside.bits;
  // Keeps crossings away from the nodes: crossings close to one node would make needles.
  const double from_inside =
      std::clamp(inside.value / (inside.value - outside.value), kEndMargin, 1 - kEndMargin);
  const std::uint64_t x = low.x + (lower & 1), y = low.y + (lower >> 1 & 1),
                      z = low.z + (lower >> 2);
  const std::uint64_t node = (z * nodes_along() + y) * nodes_along() + x;
  const double t = lower == inside.bits ? from_inside : 1 - from_inside;
  crossings_.push_back({node * 8 + direction, t, crossings_.size()});
}

Vec3d Polygoniser::crossing_position(const Crossing& crossing) const {
  const std::uint64_t direction = crossing.edge % 8, node = crossing.edge / 8;
  const auto coordinate = [&](std::uint64_t number, int bit) {
    return static_cast<double>(number) + crossing.t * static_cast<double>(direction >> bit & 1);
  };
  return lattice_.position(coordinate(node % nodes_along(), 0),
                           coordinate(node / nodes_along() % nodes_along(), 1),
                           coordinate(node / nodes_along() / nodes_along(), 2));
}

RawMesh Polygoniser::assemble() {
  RawMesh mesh;
  mesh.triangles.resize(crossings_.size() / 3);
  std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.corner < b.corner;
  });
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    const Crossing& crossing = crossings_[i];
    if (i == 0 || crossing.edge != crossings_[i - 1].edge) {
      mesh.positions.push_back(crossing_position(crossing));
    }
    mesh.triangles[crossing.corner / 3][crossing.corner % 3] =
        static_cast<std::uint32_t>(mesh.positions.size() - 1);
  }
  return mesh;
}

}  // namespace

RawMesh polygonise(const Flesh& flesh, double spacing) {
  PELT_ASSERT(spacing > 0);
  return Polygoniser(flesh, spacing).run();
}

}  // namespace pelt::scenes

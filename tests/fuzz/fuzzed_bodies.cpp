#include "fuzz/fuzzed_bodies.hpp"

#include "support/require.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace pelt::test {

std::uint8_t FuzzBytes::next() { return next_ < bytes_.size() ? bytes_[next_++] : std::uint8_t{0}; }

float FuzzBytes::coordinate() {
  constexpr std::array kOdd = {0.0f,      -0.0f,    0x1p-149f, -0x1p-149f,     0x1p-126f, 0x1p-75f,
                               -0x1p-75f, 1.0f,     -1.0f,     0x1.000002p+0f, 0x1p-25f,  3e9f,
                               0x1p58f,   -0x1p58f, 0x1p29f,   0x1.fffffep+57f};
  const std::uint8_t kind = next();
  if (kind < 96) return static_cast<float>(kind % 7) - 3;
  if (kind < 144) return kOdd[kind % kOdd.size()];
  if (kind < 208) return std::ldexp(static_cast<float>(next()) - 128, -(kind % 16));
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) bits = bits << 8 | next();
  const auto value = std::bit_cast<float>(bits);
  return std::fabs(value) <= 0x1p58f ? value : 0;
}

Vec3 FuzzBytes::point() {
  const float x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

float FuzzBytes::size() { return std::fabs(coordinate()); }

namespace {

struct Topology {
  std::vector<Triangle> triangles;
  std::uint32_t vertex_count;
};

Topology make_soup_of(FuzzBytes& bytes) {
  Topology soup = {{}, 3 + bytes.index(6)};
  const std::uint32_t count = 1 + bytes.index(8);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto corner = [&] { return bytes.index(soup.vertex_count); };
    const std::uint32_t a = corner(), b = corner(), c = corner();
    soup.triangles.push_back({a, b, c});
  }
  return soup;
}

/// A limb has enough triangles for a tree of several nodes, and vertices that several joints move.
/// The vertices of all other shapes follow one joint each.
Shape make_shape(FuzzBytes& bytes) {
  const std::uint8_t kind = bytes.next();
  if (kind >= 224) {
    const std::uint32_t rings = 4 + bytes.index(12), sides = 3 + bytes.index(6);
    return make_limb(rings, sides, 1 + bytes.index(4));
  }
  if (kind % 4 == 0) return make_pinned(4, tetrahedron());
  if (kind % 4 == 1) return make_pinned(6, octahedron());
  if (kind % 4 == 2) return make_pinned(9, torus(3, 3));
  const Topology soup = make_soup_of(bytes);
  return make_pinned(soup.vertex_count, soup.triangles);
}

/// At most two targets, each moving some vertices.
void add_morphs(FuzzBytes& bytes, Shape& shape) {
  const std::uint32_t count = bytes.index(3);
  if (count == 0) return;
  shape.morph_begin = {0};
  for (std::uint32_t target = 0; target < count; ++target) {
    for (std::uint32_t v = 0; v < shape.rest_positions.size(); ++v) {
      if (bytes.index(2) == 0) continue;
      shape.morph_vertices.push_back(v);
      shape.morph_displacements.push_back(bytes.point());
    }
    shape.morph_begin.push_back(static_cast<std::uint32_t>(shape.morph_vertices.size()));
  }
}

bool is_pinned(const Shape& shape) { return shape.influences_per_vertex == 1; }

/// Most joints of a pinned shape map their vertex to a point. Some only translate or scale it, so
/// that displacements and rest positions matter. The joints of a limb do the latter, and some shear
/// it.
std::vector<Matrix4> make_palette(FuzzBytes& bytes, const Shape& shape) {
  std::vector<Vec3> positions;
  for (std::uint32_t j = 0; j < shape.joint_count; ++j)
    positions.push_back(j > 0 && bytes.index(8) == 0 ? positions[bytes.index(j)] : bytes.point());
  std::vector<Matrix4> palette = pin(positions);
  for (Matrix4& joint : palette) {
    const std::uint32_t kind = bytes.index(4);
    if (kind == 3) {
      joint.m[0] = joint.m[5] = joint.m[10] = bytes.coordinate();
    } else if (!is_pinned(shape)) {
      joint.m[0] = joint.m[5] = joint.m[10] = 1;
      if (kind == 2) joint.m[bytes.index(3) * 4 + bytes.index(3)] = bytes.coordinate();
    }
  }
  return palette;
}

/// Any caps up to 2^58; none unless the body has offsets.
std::vector<float> make_caps(FuzzBytes& bytes, const Shape& shape, Posing posing) {
  std::vector<float> caps(posing == Posing::offsets ? shape.rest_positions.size() : 0);
  for (float& cap : caps) cap = bytes.size();
  return caps;
}

/// Sets offsets, some of which are NaN, or nothing.
void take_offsets(FuzzBytes& bytes, FuzzedBody& body) {
  if (body.posing != Posing::offsets) return;
  const auto coordinate = [&] {
    return bytes.index(8) == 0 ? std::numeric_limits<float>::quiet_NaN() : bytes.coordinate();
  };
  body.offsets.resize(body.posed.size());
  for (Vec3& offset : body.offsets) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    offset = {x, y, z};
  }
  require(static_cast<bool>(body.pose.set_offsets(body.offsets)), "offsets are refused");
}

/// Updates the posed vertices. A palette that has nothing to do with given ones must not matter.
void take_posed(FuzzedBody& body) {
  posed_vertices(body.pose, body.posed);
  if (body.posing != Posing::given) return;
  (void)body.pose.set_palette(std::vector<Matrix4>(body.shape.joint_count));
  require(static_cast<bool>(body.pose.set_vertices(body.posed)), "posed vertices are refused");
}

}  // namespace

std::vector<std::array<Vec3, 3>> FuzzedBody::all_corners() const {
  std::vector<std::array<Vec3, 3>> all;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) all.push_back(corners(t));
  return all;
}

std::optional<FuzzedBody> make_body(FuzzBytes& bytes, Posing posing) {
  Shape shape = make_shape(bytes);
  add_morphs(bytes, shape);
  const std::vector<float> caps = make_caps(bytes, shape, posing);
  SkinnedMeshView view = shape.view();
  view.offset_caps = caps;
  const Result<SkinnedModel> model = build_model(view);
  if (!model) return std::nullopt;
  Pose pose(*model);
  std::vector<Matrix4> palette = make_palette(bytes, shape);
  if (!pose.set_palette(palette)) return std::nullopt;
  std::vector<float> weights;
  for (std::uint32_t t = 0; t < shape.morph_target_count(); ++t)
    weights.push_back(bytes.coordinate());
  if (!pose.set_morph_weights(weights)) return std::nullopt;
  std::vector<Vec3> posed(shape.rest_positions.size());
  FuzzedBody body{std::move(shape),
                  std::move(palette),
                  std::move(weights),
                  std::move(pose),
                  std::move(posed),
                  posing,
                  {}};
  take_offsets(bytes, body);
  take_posed(body);
  return body;
}

void move_body(FuzzBytes& bytes, FuzzedBody& body) {
  std::vector<Matrix4> palette = make_palette(bytes, body.shape);
  if (!body.pose.set_palette(palette)) return;
  body.palette = std::move(palette);
  take_offsets(bytes, body);
  take_posed(body);
}

Vec3 point_near(FuzzBytes& bytes, const FuzzedBody& body) {
  const auto count = static_cast<std::uint32_t>(body.posed.size());
  const auto vertex = [&] { return body.posed[bytes.index(count)]; };
  switch (bytes.index(4)) {
    case 0:
      return vertex();
    case 1: {
      const Vec3 p = vertex(), q = vertex();
      return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
    }
    case 2: {
      Vec3 p = vertex();
      float Vec3::*const axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
      float& moved = p.*axes[bytes.index(3)];
      moved = std::nextafter(moved, bytes.coordinate());
      return p;
    }
    default:
      return bytes.point();
  }
}

}  // namespace pelt::test

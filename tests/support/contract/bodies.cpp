#include "support/contract/stage.hpp"

#include "self/surface_shapes.hpp"
#include "support/dual_bodies.hpp"
#include "support/pinned_shapes.hpp"
#include "support/random_offsets.hpp"

#include <pelt/model.hpp>

#include <utility>

namespace pelt::contract {

using test::Motion;
using test::Turns;
using test::Weights;

using Matrices = std::vector<Matrix4>;
using Points = std::vector<Vec3>;

Body::Body(Shape s, SkinnedModel m, PoseInput first, PoseInput last)
    : shape(std::move(s)),
      from_input(std::move(first)),
      to_input(std::move(last)),
      from(m),
      to(std::move(m)) {
  renew();
}

void Body::renew() {
  const SkinnedModel model = to.model();
  from = Pose(model), to = Pose(model);
  set();
}

void Body::set() { apply(from_input, from), apply(to_input, to); }

void Body::reserve() {
  from.reserve();
  to.reserve();
}

Body Body::given() const {
  PoseInput first, last;
  first.palette = last.palette = Matrices(to.model().joint_count());
  first.vertices = positions_of(from), last.vertices = positions_of(to);
  return {shape, to.model(), std::move(first), std::move(last)};
}

namespace {

PoseInput posed_by(Matrices palette) { return {.palette = std::move(palette)}; }

Vec3 near(Random& random, const Vec3& at, double distance) {
  const Vec3 way = random.point(distance);
  return {at.x + way.x, at.y + way.y, at.z + way.z};
}

/// Leaves the numbers of neighbours far apart.
void shuffle_triangles(Random& random, Shape& shape) {
  for (auto i = static_cast<std::uint32_t>(shape.triangles.size()); i > 1; --i)
    std::swap(shape.triangles[i - 1], shape.triangles[random.index(i)]);
}

/// Bends the limb, in a third of the cases until it folds onto itself.
Matrices bend(Random& random, const Shape& limb, const Vec3& at) {
  const double angle = random.chance(0.3) ? random.uniform(0.8, 1.6) : random.uniform(-0.5, 0.5);
  return test::bend_limb(random, limb.joint_count, angle, at);
}

Shape random_limb(Random& random, std::uint32_t size) {
  Shape limb = test::make_limb((3 + random.index(3)) * size, 8, 4);
  if (random.chance(0.5)) shuffle_triangles(random, limb);
  return limb;
}

Body limb(Random& random, const Vec3& at, std::uint32_t size) {
  Shape shape = random_limb(random, size);
  SkinnedModel model = *build_model(shape.view());
  Matrices first = bend(random, shape, near(random, at, 0.2)), last = bend(random, shape, at);
  return {std::move(shape), std::move(model), posed_by(first), posed_by(last)};
}

Body loaded_limb(Random& random, const Vec3& at, std::uint32_t size) {
  const Body body = limb(random, at, size);
  return {body.shape, *load_model(save_model(body.to.model())), body.from_input, body.to_input};
}

Shape random_soup(Random& random, std::uint32_t size) {
  constexpr Weights kWeights[] = {Weights::one_joint, Weights::random, Weights::adversarial};
  constexpr std::uint32_t kInfluences[] = {1, 3, 4, 9};
  const Weights weights = kWeights[random.index(3)];
  return test::make_soup(random, 24 * size, 6, kInfluences[random.index(4)], weights);
}

template <Motion kMotion>
Body soup(Random& random, const Vec3&, std::uint32_t size) {
  Shape shape = random_soup(random, size);
  SkinnedModel model = *build_model(shape.view());
  Matrices first = test::make_palette(random, 6, kMotion, 1);
  Matrices last = test::make_palette(random, 6, kMotion, 1);
  return {std::move(shape), std::move(model), posed_by(first), posed_by(last)};
}

/// The same limb in the same pose each time: two of them coincide everywhere.
Body twin(Random&, const Vec3&, std::uint32_t size) {
  Random same(90);
  return limb(same, {}, size);
}

/// Triangles between points of a small integer grid; each vertex follows one joint, or two equal
/// ones.
Shape grid_soup(Random& random, std::uint32_t triangle_count, std::uint32_t joint_count) {
  Shape shape;
  shape.joint_count = joint_count;
  shape.influences_per_vertex = 2;
  const auto coordinate = [&] { return static_cast<float>(random.index(5)) - 2; };
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    const auto first = static_cast<std::uint32_t>(shape.rest_positions.size());
    const auto joint = static_cast<std::uint16_t>(random.index(joint_count));
    for (int corner = 0; corner < 3; ++corner) {
      shape.rest_positions.push_back({coordinate(), coordinate(), coordinate()});
      shape.joints.insert(shape.joints.end(),
                          {joint, random.chance(0.2) ? std::uint16_t{0} : joint});
      shape.weights.insert(shape.weights.end(), {0.5f, 0.5f});
    }
    shape.triangles.push_back({first, first + 1, first + 2});
  }
  return shape;
}

/// Rotations by right angles, reflections and translations by whole units, which preserve the grid.
Matrix4 grid_joint(Random& random) {
  std::uint32_t axes[3] = {0, 1, 2};
  std::swap(axes[0], axes[random.index(3)]);
  std::swap(axes[1], axes[1 + random.index(2)]);
  Matrix4 joint;
  joint.m = {};
  for (std::uint32_t column = 0; column < 3; ++column)
    joint.m[4 * column + axes[column]] = random.chance(0.5) ? 1.0f : -1.0f;
  for (std::uint32_t row = 0; row < 3; ++row)
    joint.m[12 + row] = static_cast<float>(random.index(3)) - 1;
  joint.m[15] = 1;
  return joint;
}

/// Sets whole rows to zero: everything is mapped to planes of the grid, lines, or a point.
Matrix4 flattened(Random& random, Matrix4 joint) {
  for (std::size_t row = 0; row < 3; ++row)
    if (random.chance(0.4))
      for (std::size_t column = 0; column < 4; ++column) joint.m[4 * column + row] = 0;
  return joint;
}

Matrix4 moved(Matrix4 joint, float distance, float scale) {
  for (std::size_t e = 0; e < 16; ++e)
    if (e % 4 != 3) joint.m[e] *= scale;
  joint.m[12] += distance;
  return joint;
}

template <typename Joint>
Body on_grid(Random& random, std::uint32_t size, const Joint& joint) {
  Shape shape = grid_soup(random, 14 * size, 4);
  SkinnedModel model = *build_model(shape.view());
  Matrices first, last;
  for (int j = 0; j < 4; ++j) first.push_back(joint()), last.push_back(joint());
  return {std::move(shape), std::move(model), posed_by(first), posed_by(last)};
}

Body grid(Random& random, const Vec3&, std::uint32_t size) {
  return on_grid(random, size, [&] { return grid_joint(random); });
}
Body flat_grid(Random& random, const Vec3&, std::uint32_t size) {
  return on_grid(random, size, [&] { return flattened(random, grid_joint(random)); });
}
Body far_grid(Random& random, const Vec3&, std::uint32_t size) {
  return on_grid(random, size, [&] { return moved(grid_joint(random), 0x1p20f, 1); });
}
Body tiny_grid(Random& random, const Vec3&, std::uint32_t size) {
  return on_grid(random, size, [&] { return moved(grid_joint(random), 0, 0x1p-70f); });
}
Body huge_grid(Random& random, const Vec3&, std::uint32_t size) {
  return on_grid(random, size, [&] { return moved(grid_joint(random), 0, 0x1p50f); });
}

/// In the plane z = 0.
Body plane(Random& random, const Vec3&, std::uint32_t size) {
  Body body = soup<Motion::affine>(random, {}, size);
  for (PoseInput* input : {&body.from_input, &body.to_input})
    for (Matrix4& joint : input->palette)
      for (std::size_t column = 0; column < 4; ++column) joint.m[4 * column + 2] = 0;
  body.renew();
  return body;
}

Body morphed(Random& random, Shape shape, const Matrices& first, const Matrices& last) {
  SkinnedModel model = *build_model(shape.view());
  const auto weights = [&] {
    return test::make_morph_weights(random, shape.morph_target_count(),
                                    test::kAllMorphings[random.index(6)]);
  };
  PoseInput from = posed_by(first), to = posed_by(last);
  from.morph_weights = weights(), to.morph_weights = weights();
  return {std::move(shape), std::move(model), std::move(from), std::move(to)};
}

Body morphing_limb(Random& random, const Vec3& at, std::uint32_t size) {
  Shape shape = test::make_morphing_limb(5 * size, 6, 4);
  test::add_morph_targets(random, shape, 12, 0.1, 0.05);
  const Matrices first = bend(random, shape, near(random, at, 0.2)), last = bend(random, shape, at);
  return morphed(random, std::move(shape), first, last);
}

Body morphing_soup(Random& random, const Vec3&, std::uint32_t size) {
  Shape shape = random_soup(random, size);
  test::add_morph_targets(random, shape, 10, 0.3, random.chance(0.5) ? 0.1 : 3);
  const Matrices first = test::make_palette(random, 6, Motion::affine, 1);
  const Matrices last = test::make_palette(random, 6, Motion::affine, 1);
  return morphed(random, std::move(shape), first, last);
}

/// Limbs and soups with up to eight influences, with or without morph targets and offsets.
template <Turns kTurns>
Body dual(Random& random, const Vec3& at, std::uint32_t size) {
  const test::DualKind kind = {kTurns, 1 + random.index(8), random.chance(0.5), random.chance(0.5),
                               random.chance(0.5)};
  Shape shape = test::make_dual_shape(random, kind, 16 * size);
  test::Caps caps;
  if (kind.has_offsets)
    caps = test::random_caps(random, shape.rest_positions.size(), kind.is_soup ? 0.2 : 0.02);
  SkinnedMeshView view = shape.view();
  view.offset_caps = caps;
  SkinnedModel model = *build_model(view, test::kDual);
  const auto input = [&](const Vec3& place) {
    PoseInput set = posed_by(test::dual_palette(random, kind, place));
    if (random.chance(0.5))
      set.dual_quaternions = test::signed_dual_quaternions(random, set.palette);
    set.morph_weights =
        test::make_morph_weights(random, shape.morph_target_count(), test::Morphing::all);
    if (kind.has_offsets) set.offsets = test::random_offsets(random, caps);
    return set;
  };
  PoseInput first = input(near(random, at, 0.2)), last = input(at);
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

/// A limb or a soup with offsets of its posed vertices, some beyond their caps or NaN.
Body with_offsets(Random& random, const Vec3& at, std::uint32_t size) {
  Body body = random.chance(0.5) ? limb(random, at, size) : soup<Motion::affine>(random, at, size);
  const test::Caps caps = test::random_caps(random, body.shape.rest_positions.size(), 0.05);
  SkinnedMeshView view = body.shape.view();
  view.offset_caps = caps;
  for (PoseInput* input : {&body.from_input, &body.to_input})
    input->offsets = test::random_offsets(random, caps);
  return {body.shape, *build_model(view), body.from_input, body.to_input};
}

/// Triangles between few points: neighbours of every kind, cracked or not.
Body cracked_soup(Random& random, const Vec3&, std::uint32_t size) {
  const std::uint32_t joints = 1 + random.index(2);
  Shape shape = test::make_grid_soup(random, 30 * size, 3, joints);
  SkinnedModel model = *build_model(shape.view());
  Matrices first = test::make_palette(random, joints, Motion::affine, 1);
  Matrices last = test::make_palette(random, joints, Motion::affine, 1);
  return {std::move(shape), std::move(model), posed_by(first), posed_by(last)};
}

/// Triangles around one vertex, more than a certificate of fans supports, or as many; half of the
/// poses are flat.
Body fan(Random& random, const Vec3& at, std::uint32_t size) {
  Shape shape;
  shape.influences_per_vertex = 1;
  const std::uint32_t count = random.chance(0.3) ? 24 + random.index(2) : 60 * size;
  test::add_fan(random, shape, count, random.chance(0.5), {});
  SkinnedModel model = *build_model(shape.view());
  const auto place = [&](const Vec3& centre) {
    Matrix4 joint = test::rotation_about(random.point(1), random.uniform(0, 6), {}, centre);
    if (random.chance(0.5)) joint.m[0] = joint.m[4] = joint.m[8] = 0;
    return posed_by({joint});
  };
  PoseInput first = place(near(random, at, 0.2)), last = place(at);
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

/// Closed surfaces with vertices anywhere on a small grid: folds by a half turn, duplicates,
/// collapsed fans, T-joints.
Body crumpled(Random& random, const Vec3&, std::uint32_t) {
  const std::pair<std::uint32_t, std::vector<Triangle>> surfaces[] = {
      {4, test::tetrahedron()}, {6, test::octahedron()}, {20, test::torus(5, 4)}};
  const auto& surface = surfaces[random.index(3)];
  const std::uint32_t vertex_count = surface.first;
  Shape shape = test::make_pinned(vertex_count, surface.second);
  SkinnedModel model = *build_model(shape.view());
  const std::uint32_t points = 2 + random.index(5);
  const auto place = [&] {
    Points positions(vertex_count);
    for (Vec3& p : positions)
      p = {static_cast<float>(random.index(points)), static_cast<float>(random.index(points)),
           static_cast<float>(random.index(3))};
    return posed_by(test::pin(positions));
  };
  PoseInput first = place(), last = place();
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

/// A limb whose corners are split into vertices with equal influences.
Shape make_split_limb(Random& random, std::uint32_t size) {
  Shape shape = test::make_limb(4 * size, 6, 2);
  test::split_corners(random, shape, 0.1, 0);
  return shape;
}

/// Half of the vertices move apart to points of a small grid.
Points torn(Random& random, const Shape& shape) {
  Points positions = shape.rest_positions;
  for (Vec3& p : positions)
    if (random.chance(0.5))
      p = {static_cast<float>(random.index(4)), static_cast<float>(random.index(4)),
           static_cast<float>(random.index(4))};
  return positions;
}

PoseInput given_at(const Shape& shape, Points vertices) {
  return {.palette = Matrices(shape.joint_count), .vertices = std::move(vertices)};
}

Body torn_by_vertices(Random& random, const Vec3&, std::uint32_t size) {
  Shape shape = make_split_limb(random, size);
  SkinnedModel model = *build_model(shape.view(), {.weld = false});
  PoseInput first = given_at(shape, torn(random, shape)),
            last = given_at(shape, torn(random, shape));
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

Body torn_by_offsets(Random& random, const Vec3&, std::uint32_t size) {
  Shape shape = make_split_limb(random, size);
  const std::vector<float> caps(shape.rest_positions.size(), 4);
  SkinnedMeshView view = shape.view();
  view.offset_caps = caps;
  SkinnedModel model = *build_model(view);
  PoseInput first = posed_by(Matrices(2)), last = first;
  first.offsets = torn(random, shape), last.offsets = torn(random, shape);
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

/// Triangles with any vertices, or with vertices on a grid of the largest or least floats.
Body with_given_vertices(Random& random, const Vec3&, std::uint32_t size) {
  Shape shape = test::make_soup(random, 20 * size, 3, 2, Weights::random);
  SkinnedModel model = *build_model(shape.view(), {.weld = random.chance(0.5)});
  constexpr float kScales[] = {0x1p58f, 0x1p-149f, 0x1p-126f, 0x1p-70f};
  const float scale = random.chance(0.5) ? 0 : kScales[random.index(4)];
  const auto place = [&] {
    Points points(shape.rest_positions.size());
    const auto step = [&] { return scale * (static_cast<float>(random.index(3)) - 1); };
    for (Vec3& p : points) p = scale == 0 ? random.point(1) : Vec3{step(), step(), step()};
    return given_at(shape, std::move(points));
  };
  PoseInput first = place(), last = place();
  return {std::move(shape), std::move(model), std::move(first), std::move(last)};
}

/// A limb without joints, by given vertices.
Body without_joints(Random& random, const Vec3& at, std::uint32_t size) {
  Body body = limb(random, at, size).given();
  body.shape.joints.clear(), body.shape.weights.clear();
  SkinnedMeshView view;
  view.rest_positions = body.shape.rest_positions, view.triangles = body.shape.triangles;
  body.from_input.palette = body.to_input.palette = Matrices(1);
  return {body.shape, *build_model(view), body.from_input, body.to_input};
}

}  // namespace

std::span<const Kind> kinds() {
  static constexpr Kind kKinds[] = {
      {"limbs", limb},
      {"limbs loaded from bytes", loaded_limb},
      {"twins", twin, true},
      {"rigid soups", soup<Motion::rigid>},
      {"affine soups", soup<Motion::affine>},
      {"collapsed soups", soup<Motion::collapsed>},
      {"soups far away", soup<Motion::far_away>},
      {"in one plane", plane, true},
      {"on a grid", grid, true},
      {"collapsed on a grid", flat_grid, true},
      {"on a grid far away", far_grid, true},
      {"on a tiny grid", tiny_grid, true},
      {"on a huge grid", huge_grid, true},
      {"cracked soups", cracked_soup, true},
      {"fans", fan},
      {"crumpled on a grid", crumpled, true},
      {"morphing limbs", morphing_limb},
      {"morphing soups", morphing_soup},
      {"dual quaternions, small turns", dual<Turns::small>},
      {"dual quaternions, large turns", dual<Turns::large>},
      {"dual quaternions, any turns", dual<Turns::any>},
      {"dual quaternions, half turns", dual<Turns::antipodal>},
      {"dual quaternions, far away", dual<Turns::far_away>},
      {"offsets", with_offsets},
      {"torn by offsets", torn_by_offsets},
      {"torn by given vertices", torn_by_vertices},
      {"given vertices", with_given_vertices},
      {"limbs without joints", without_joints},
  };
  return kKinds;
}

}  // namespace pelt::contract

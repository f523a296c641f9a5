#include <pelt/bounds.hpp>
#include <pelt/collide.hpp>
#include <pelt/distance.hpp>
#include <pelt/height_field.hpp>
#include <pelt/inside.hpp>
#include <pelt/ray.hpp>
#include <pelt/solid.hpp>
#include <pelt/surface.hpp>

#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"
#include "tools/pelt/picture/still.hpp"

#include <array>
#include <cmath>
#include <span>

namespace pelt::pictures {
namespace {

// Left: the guaranteed box and the exact box. Right: the exact boxes of the vertices of each
// joint.

constexpr std::string_view kBoundsScene = R"({
  "models": {"c": {"creature": {"triangles": 24000, "joints": 27, "seed": 1}}},
  "instances": [
    {"model": "c", "clip": "walk", "start": 0.62, "translation": [0, 0, -0.95]},
    {"model": "c", "clip": "walk", "start": 0.62, "translation": [0, 0, 1.15]}
  ]})";

std::string boxes_of_joints(const Actor& actor) {
  const VertexGroups groups = group_by_joint(actor.pose.model());
  std::string text;
  for (std::uint32_t g = 0; g < groups.count(); ++g)
    if (groups.vertex_count(g) > 0) {
      Box box;
      exact_group_bounds(actor.pose, groups, g, box);
      text += edges(box, 0.003, Tone::question);
    }
  return text;
}

}  // namespace

Picture bounds_picture() {
  Cast cast(kBoundsScene, 0);
  Actor &whole = cast.actors[0], &by_joint = cast.actors[1];
  std::string objects = painted(whole, 0) + painted(by_joint, 0);
  Bounds guaranteed, exact;
  bounds(whole.pose, guaranteed);
  exact_bounds(whole.pose, exact);
  objects += edges(guaranteed.box, 0.0045, Tone::quiet);
  objects += edges(exact.box, 0.007, Tone::question);
  objects += boxes_of_joints(by_joint);
  return framed("bounds", {{-5.4, 1.7, 0.9}, {0, 0.86, -0.08}, 43, 16. / 9}, objects);
}

namespace {

// The frustum of a camera among creatures: inside, partly inside and outside.

/// A camera at the origin of its frame that looks along -z.
struct Eye {
  Vec3d place;
  double turn, half_width, half_height, near, far;  ///< radians about y; half sizes at depth 1

  Vec3d at(double x, double y, double depth) const {
    const double c = std::cos(turn), s = std::sin(turn);
    const double right = x * half_width * depth, up = y * half_height * depth;
    return place + Vec3d(c * right - s * depth, up, -s * right - c * depth);
  }

  Matrix4 view_projection() const {
    const double c = std::cos(turn), s = std::sin(turn);
    const double scale = (far + near) / (far - near), shift = 2 * far * near / (far - near);
    const Vec3d rows[4] = {(1 / half_width) * Vec3d(c, 0, -s), (1 / half_height) * Vec3d(0, 1, 0),
                           -scale * Vec3d(s, 0, c), -1.0 * Vec3d(s, 0, c)};
    Matrix4 matrix;
    for (int row = 0; row < 4; ++row) {
      const double last = -dot(rows[row], place) - (row == 2 ? shift : 0);
      const double numbers[] = {rows[row].x, rows[row].y, rows[row].z, last};
      for (int column = 0; column < 4; ++column)
        matrix.m[4 * column + row] = static_cast<float>(numbers[column]);
    }
    return matrix;
  }
};

std::string loop(std::span<const Vec3d> corners) {
  std::string text;
  for (std::size_t i = 0; i < corners.size(); ++i)
    text += line(corners[i], corners[(i + 1) % corners.size()], 0.012, Tone::question);
  return text;
}

/// The outline of the frustum down to the ground, where its lower face ends.
std::string outline(const Eye& eye) {
  const double landing = eye.place.y / eye.half_height;
  const auto on_ground = [&](double x, double depth) {
    return eye.at(x, -landing / depth, depth) + Vec3d(0, 0.01, 0);
  };
  std::string text = dot_at(eye.place, 0.07, Tone::question);
  for (const double x : {-1.0, 1.0}) {
    text += line(eye.place, eye.at(x, 1, eye.far), 0.012, Tone::question);
    text += line(eye.place, on_ground(x, landing), 0.012, Tone::question);
  }
  const double n = eye.near;
  text += loop(std::array{eye.at(-1, -1, n), eye.at(1, -1, n), eye.at(1, 1, n), eye.at(-1, 1, n)});
  text += loop(std::array{on_ground(-1, landing), on_ground(1, landing), on_ground(1, eye.far),
                          on_ground(-1, eye.far)});
  return text + loop(std::array{on_ground(-1, eye.far), on_ground(1, eye.far),
                                eye.at(1, 1, eye.far), eye.at(-1, 1, eye.far)});
}

std::string scene_text() {
  std::string instances;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) {
      const std::string place = "[" + std::to_string(1.35 * (column - 2) + 0.3 * (row % 2)) +
                                ", 0, " + std::to_string(1.45 * (1.5 - row)) + "]";
      instances += std::string(instances.empty() ? "" : ",") +
                   R"({"model": "c", "clip": "walk", "start": )" +
                   std::to_string(0.21 * (5 * row + column)) + R"(, "translation": )" + place +
                   R"(, "rotation": [0, )" + (column % 2 ? "0.6, 0, 0.8" : "0.28, 0, 0.96") + "]}";
    }
  return R"({"models": {"c": {"creature": {"triangles": 8000, "joints": 27, "seed": 2}}},
             "instances": [)" +
         instances + "]}";
}

}  // namespace

Picture culling_picture() {
  Cast cast(scene_text(), 0);
  const Eye eye = {{-1.2, 1.0, 5.4}, -0.2, 0.42, 0.36, 0.8, 7.6};
  const Region seen = make_frustum(eye.view_projection());
  Scratch scratch;
  std::string objects = outline(eye);
  for (Actor& actor : cast.actors) {
    Placement placement = Placement::outside;
    classify(actor.pose, seen, scratch, placement);
    switch (placement) {
      case Placement::outside:
        objects += painted(actor, paint({0.72F, 0.73F, 0.74F}), {});
        break;
      case Placement::partly:
        objects += painted(actor, paint({0.80F, 0.50F, 0.12F}), {});
        break;
      case Placement::inside:
        objects += painted(actor, paint({0.14F, 0.34F, 0.60F}), {});
        break;
    }
  }
  return framed("culling", {{3.6, 7.6, 11.4}, {-0.1, 0.35, 0.9}, 47, 16. / 9}, objects);
}

namespace {

// A fan of rays, their first hits, and the normals there.

constexpr std::string_view kRayScene = R"({
  "models": {"c": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
  "instances": [{"model": "c", "clip": "walk", "start": 0.2, "translation": [0, 0, 0.75]}]})";

}  // namespace

Picture ray_picture() {
  Cast cast(kRayScene, 0);
  Actor& actor = cast.actors[0];
  const Vec3 eye = {-0.45f, 1.2f, 2.55f};
  std::string objects = painted(actor, 0) + dot_at(Vec3d(eye), 0.035, Tone::question);
  for (int i = 0; i < 9; ++i) {
    const Vec3 aim = {-0.25f + 0.05f * static_cast<float>(i), 0.1f + 0.21f * static_cast<float>(i),
                      0.1f};
    const Ray ray = segment(eye, aim);
    RayHit hit;
    pelt::cast(actor.pose, ray, hit);
    const Vec3d direction(ray.direction);
    if (!hit) {
      objects += line(Vec3d(eye), Vec3d(eye) + 1.3 * direction, 0.004, Tone::quiet);
      continue;
    }
    const Vec3d place = Vec3d(eye) + static_cast<double>(hit.t) * direction;
    objects += line(Vec3d(eye), place, 0.006, Tone::question) + dot_at(place, 0.022, Tone::answer) +
               arrow(place, place + 0.2 * Vec3d(hit.normal), 0.007, Tone::answer);
  }
  return framed("ray", {{-4.4, 1.5, 1.6}, {0, 0.9, 1.2}, 42, 16. / 9}, objects);
}

namespace {

/// A scene of the instances of two creatures, "a" and "b".
std::string two_creatures(std::string_view instances) {
  return R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}},
             "b": {"creature": {"triangles": 24000, "joints": 56, "seed": 2}}},
  "instances": [)" +
         std::string(instances) + "]}";
}

// Two creatures with the segment between their closest points, and a point with its closest
// surface point.

constexpr std::string_view kDistanceInstances = R"(
    {"model": "a", "clip": "walk", "start": 0.25, "translation": [0, 0, -0.8]},
    {"model": "b", "clip": "walk", "start": 0.75, "translation": [0.15, 0, 0.8],
     "rotation": [0, 1, 0, 0]})";

/// A segment between two points, with a dot at each end.
std::string between(const Vec3d& from, const Vec3d& to) {
  return line(from, to, 0.010, Tone::answer) + dot_at(from, 0.026, Tone::answer) +
         dot_at(to, 0.026, Tone::answer);
}

}  // namespace

Picture distance_picture() {
  Cast cast(two_creatures(kDistanceInstances), 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  Distance between_them;
  distance(a.pose, b.pose, scratch, between_them);
  const Vec3 point = {-0.1f, 1.35f, 1.3f};
  ClosestPoint closest;
  closest_point(b.pose, point, scratch, closest);
  const std::string objects =
      painted(a, 0) + painted(b, 1) +
      between(Vec3d(between_them.a.position), Vec3d(between_them.b.position)) +
      line(Vec3d(point), Vec3d(closest.point.position), 0.007, Tone::question) +
      dot_at(Vec3d(point), 0.032, Tone::question) +
      dot_at(Vec3d(closest.point.position), 0.02, Tone::answer);
  return framed("distance", {{-4.2, 1.5, 0.4}, {0, 0.9, 0}, 44, 16. / 9}, objects);
}

namespace {

// The curves in which two creatures intersect, and the normal of each patch.

constexpr std::string_view kContactInstances = R"(
    {"model": "a", "clip": "walk", "start": 1.3, "translation": [-0.1, 0, -0.19]},
    {"model": "b", "clip": "walk", "start": 1.95, "translation": [0.1, 0, 0.19],
     "rotation": [0, 1, 0, 0]})";

std::string curves(const ContactGeometry& geometry) {
  std::string text;
  for (const ContactTrace& trace : geometry.traces)
    if (trace.kind == ContactKind::segment)
      text += line(Vec3d(trace.from), Vec3d(trace.to), 0.009, Tone::answer) +
              dot_at(Vec3d(trace.from), 0.009, Tone::answer) +
              dot_at(Vec3d(trace.to), 0.009, Tone::answer);
  return text;
}

}  // namespace

Picture contact_picture() {
  Cast cast(two_creatures(kContactInstances), 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a.pose, b.pose, scratch, contacts);
  ContactGeometry geometry;
  describe_contacts(a.pose, b.pose, contacts, scratch, geometry);
  std::string objects = unshadowed(painted(a, glass({0.26F, 0.40F, 0.55F}, 0.45), {})) +
                        painted(b, 1) + curves(geometry);
  for (const ContactPatch& patch : geometry.patches)
    objects += arrow(Vec3d(patch.point), Vec3d(patch.point) + 0.35 * Vec3d(patch.normal), 0.011,
                     Tone::question);
  return framed("contact", {{-4.3, 1.45, -0.9}, {0, 0.87, 0}, 44, 16. / 9}, objects);
}

namespace {

// A creature in a hilly field, the triangles of both that touch, and the distance of the creature
// from a pillar.

constexpr std::string_view kTerrainScene = R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
  "instances": [{"model": "a", "clip": "walk", "start": 1.3, "translation": [0, 0.06, 0]}]})";

constexpr std::uint32_t kColumns = 41, kRows = 61;
constexpr float kSpacing = 0.08f;
constexpr double kGround = 0.25;  // its mean height: above the floor of the picture

std::vector<float> hills() {
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double x = column * double{kSpacing}, z = row * double{kSpacing};
      heights.push_back(static_cast<float>(kGround +
                                           0.09 * std::sin(3.1 * x + 1) * std::cos(2.3 * z) +
                                           0.05 * std::sin(1.3 * z + 2)));
    }
  }
  return heights;
}

std::string painted(const HeightField& field, const std::vector<bool>& touched) {
  std::string text;
  for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
    const std::array<Vec3, 3> corners = field.triangle(t);
    text += "triangle {" + tools::picture::pov_vector(Vec3d(corners[0])) + ", " +
            tools::picture::pov_vector(Vec3d(corners[1])) + ", " +
            tools::picture::pov_vector(Vec3d(corners[2])) + " texture {" +
            paint(touched[t] ? std::array{0.95f, 0.22f, 0.02f} : std::array{0.62f, 0.66f, 0.55f}) +
            "}}\n";
  }
  return text;
}

}  // namespace

Picture terrain_picture() {
  const std::vector<float> heights = hills();
  const auto field =
      build_height_field({heights, kColumns, kRows, {-1.6f, 0, -2.4f}, kSpacing, kSpacing});
  Cast cast(kTerrainScene, 0);
  Actor& actor = cast.actors[0];
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(actor.pose, *field, scratch, contacts);
  std::vector<bool> of_skin(actor.posed.triangles.size()), of_field(field->triangle_count());
  for (const Contact& contact : contacts) {
    of_skin[contact.triangle_a] = true;
    of_field[contact.triangle_b] = true;
  }
  const Capsule pillar = {{0, 0.2f, 1.2f}, {0, 1.3f, 1.2f}, 0.16f};
  SolidDistance closest;
  distance(actor.pose, pillar, scratch, closest);
  const Vec3d from(closest.surface.position), to(closest.solid);
  const std::string stone = "sphere_sweep {linear_spline 2, " +
                            tools::picture::pov_vector(Vec3d(pillar.a)) + ", 0.16, " +
                            tools::picture::pov_vector(Vec3d(pillar.b)) + ", 0.16 texture {" +
                            paint({0.72f, 0.66f, 0.56f}) + "}}\n";
  const std::string objects = painted(actor, paint({0.26f, 0.40f, 0.55f}), of_skin) +
                              painted(*field, of_field) + stone +
                              line(from, to, 0.012, Tone::answer) +
                              dot_at(from, 0.028, Tone::answer) + dot_at(to, 0.028, Tone::answer);
  return framed("terrain", {{-4.4, 2.6, 1.6}, {0, 0.95, 0.25}, 44, 16. / 9}, objects);
}

namespace {

// The vertex of one creature that is deepest in another, and the segment to the nearest surface
// point.

constexpr std::string_view kInsideInstances = R"(
    {"model": "a", "clip": "walk", "start": 0.3, "translation": [0.05, 0, -0.32]},
    {"model": "b", "clip": "idle", "translation": [0, 0, 0.22], "rotation": [0, 1, 0, 0]})";

}  // namespace

Picture inside_picture() {
  Cast cast(two_creatures(kInsideInstances), 0);
  Actor &a = cast.actors[0], &b = cast.actors[1];
  Scratch scratch;
  Penetration deepest;
  deepest_vertex(a.pose, b.pose, scratch, deepest);
  const Vec3d vertex(deepest.position), surface(deepest.closest.position);
  const std::string objects = unshadowed(painted(a, glass({0.26F, 0.40F, 0.55F}, 0.35), {})) +
                              unshadowed(painted(b, glass({0.66F, 0.57F, 0.42F}, 0.45), {})) +
                              line(vertex, surface, 0.010, Tone::answer) +
                              dot_at(vertex, 0.022, Tone::answer) +
                              dot_at(surface, 0.022, Tone::answer);
  return framed("inside", {{-3.0, 1.75, 0.5}, {0, 1.32, -0.03}, 34, 16. / 9}, objects);
}

}  // namespace pelt::pictures

#include "tools/pelt/arguments/region_arguments.hpp"

#include "asset/transform.hpp"
#include "base/vec3.hpp"
#include "text/format.hpp"
#include "text/message.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace pelt::tools::arguments {
namespace {

using detail::Vec3d;

/// An option, its name in answers, and its number of values.
struct Kind {
  const char *option, *name, *example;
  std::size_t count;
  std::string RegionArguments::*text;
};

constexpr Kind kKinds[] = {
    {"--box", "box", "0,0,-1,1,2,1", 6, &RegionArguments::box},
    {"--sphere", "sphere", "0,1,0,0.5", 4, &RegionArguments::sphere},
    {"--capsule", "capsule", "0,0,0,0,2,0,0.5", 7, &RegionArguments::capsule},
    {"--camera", "camera", "0,1,4,0,1,0", 6, &RegionArguments::camera},
};

Result<std::vector<float>> parse_numbers(const Kind& kind, const std::string& text) {
  std::vector<float> numbers;
  for (const std::string_view field : text::split(text, ',')) {
    double number = 0;
    if (!text::parse_number(field, number) || !(std::fabs(number) <= 1e12)) break;
    numbers.push_back(static_cast<float>(number));
  }
  if (numbers.size() == kind.count && text::split(text, ',').size() == kind.count) return numbers;
  return text::bad_argument(
      kind.option, text::quoted(text) + " is not " + std::to_string(kind.count) + " numbers",
      std::string("give numbers as in ") + kind.option + " " + kind.example);
}

/// Validates a radius, and the order of a box's corners.
Result<void> check_numbers(const Kind& kind, std::span<const float> n) {
  const bool has_radius = kind.count % 3 == 1;
  if (has_radius && n.back() < 0)
    return text::bad_argument(kind.option, "the radius is negative", "give 0 or more");
  const std::string name = kind.name;
  for (int axis = 0; axis < 3 && name == "box"; ++axis)
    if (n[axis] > n[axis + 3])
      return text::bad_argument(kind.option, "the lowest corner is above the highest corner",
                                "give the lowest x, y and z first");
  if (name == "camera" && n[0] == n[3] && n[1] == n[4] && n[2] == n[5])
    return text::bad_argument(kind.option, "position and target are the same point",
                              "give another point to look at");
  return {};
}

Vec3d unit(const Vec3d& v) { return (1 / std::sqrt(squared_length(v))) * v; }

HalfSpace face_through(const Vec3d& place, const Vec3d& normal) {
  const Vec3 rounded = to_float(normal);
  return {rounded, static_cast<float>(dot(Vec3d(rounded), place))};
}

}  // namespace

ChosenRegion::ChosenRegion(const std::string& kind, std::vector<float> numbers)
    : kind_(kind), numbers_(std::move(numbers)) {}

ChosenRegion ChosenRegion::seen_by_camera(std::vector<float> numbers, const FieldOfView& view) {
  const Vec3d eye(Vec3{numbers[0], numbers[1], numbers[2]});
  const Vec3d ahead = unit(Vec3d(Vec3{numbers[3], numbers[4], numbers[5]}) - eye);
  const Vec3d pole = std::fabs(ahead.y) < 0.999 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d right = unit(cross(ahead, pole)), up = cross(right, ahead);
  const double half = view.degrees / 360 / 2;  // in turns
  const double sine = asset::sine_of_turns(half), cosine = asset::cosine_of_turns(half);
  ChosenRegion chosen("camera", std::move(numbers));
  chosen.view_ = view;
  for (const double side : {1.0, -1.0}) {
    chosen.faces_.push_back(face_through(eye, side * cosine * right - sine * ahead));
    chosen.faces_.push_back(face_through(eye, side * view.aspect * cosine * up - sine * ahead));
  }
  return chosen;
}

Region ChosenRegion::region() const {
  const std::vector<float>& n = numbers_;
  if (kind_ == "box") return Box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  if (kind_ == "sphere") return Sphere{{n[0], n[1], n[2]}, n[3]};
  if (kind_ == "capsule") return Capsule{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6]};
  return ConvexPolyhedron{faces_};
}

void add_region_options(Verb& verb, RegionArguments& arguments) {
  verb.option("--box", arguments.box, "Box, by its lowest and highest corner",
              {.type = "X,Y,Z,X,Y,Z"});
  verb.option("--sphere", arguments.sphere, "Ball, by its centre and radius", {.type = "X,Y,Z,R"});
  verb.option("--capsule", arguments.capsule, "Capsule, by the ends of its segment and its radius",
              {.type = "X,Y,Z,X,Y,Z,R"});
  verb.option(
      "--camera", arguments.camera,
      "View of a camera without a far plane, by its position and the point that it looks at",
      {.type = "X,Y,Z,X,Y,Z"});
  verb.option("--angle", arguments.angle, "Horizontal field of view of the camera (default: 60)",
              {.type = "DEGREES"});
  verb.option("--aspect", arguments.aspect,
              "Width over height of the camera's picture (default: 16/9)", {.type = "RATIO"});
}

Result<ChosenRegion> choose_region(const RegionArguments& arguments) {
  const Kind* chosen = nullptr;
  for (const Kind& kind : kKinds) {
    if ((arguments.*kind.text).empty()) continue;
    if (chosen != nullptr)
      return text::bad_argument(
          kind.option, std::string("cannot be combined with ") + chosen->option, "give one region");
    chosen = &kind;
  }
  if (chosen == nullptr)
    return text::bad_argument("--box", "no region was given",
                              "give one with --box, --sphere, --capsule or --camera");
  Result<std::vector<float>> numbers = parse_numbers(*chosen, arguments.*chosen->text);
  if (!numbers) return numbers.error();
  if (const auto checked = check_numbers(*chosen, *numbers); !checked) return checked.error();
  if (chosen->text != &RegionArguments::camera)
    return ChosenRegion(chosen->name, std::move(*numbers));
  const double angle = arguments.angle.value_or(60), aspect = arguments.aspect.value_or(16. / 9);
  if (!(angle > 0 && angle < 180))
    return text::number_not_allowed("--angle", angle, "give degrees between 0 and 180");
  if (!(aspect > 0 && aspect <= 1e6))
    return text::number_not_allowed("--aspect", aspect, "give a ratio up to 1e6, as in 1.78");
  return ChosenRegion::seen_by_camera(std::move(*numbers), {angle, aspect});
}

}  // namespace pelt::tools::arguments

#include <pelt/self_filter.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/index_arrays.hpp"

#include <pybind11/stl.h>

#include <span>
#include <tuple>

namespace pelt::python {
namespace {

using Integers = py::array_t<std::int32_t>;

Integers array_of_pairs(std::span<const IndexPair> pairs) {
  Integers array = new_array<std::int32_t>({pairs.size(), 2});
  std::int32_t* out = array.mutable_data();
  for (const auto& [first, second] : pairs) {
    *out++ = first;
    *out++ = second;
  }
  return array;
}

Integers array_of_zones(std::span<const TriangleZone> zones) {
  Integers array = new_array<std::int32_t>({zones.size(), 2});
  std::int32_t* out = array.mutable_data();
  for (const auto& [triangle, zone] : zones) {
    *out++ = static_cast<std::int32_t>(triangle);
    *out++ = zone;
  }
  return array;
}

std::vector<Vec3> read_positions(const std::optional<py::array>& array, std::size_t vertices) {
  if (!array) return {};
  check_shape(*array, "positions", {static_cast<py::ssize_t>(vertices), 3},
              "[" + std::to_string(vertices) + ", 3]");
  const FloatView view(*array, "positions");
  std::vector<Vec3> positions(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    positions[v] = {view.at(v, 0), view.at(v, 1), view.at(v, 2)};
  return positions;
}

/// The bodies [J], the pairs of joints and the pairs in zones [N, 2], and the zones [N, 2].
using NearColumns = std::tuple<Integers, Integers, Integers, Integers>;

NearColumns all_near_joints(const SkinnedModel& model, const Integers& bodies,
                            const Integers& above, const std::optional<py::array>& positions,
                            const std::optional<Integers>& at_rest) {
  const JointBodies of_joints = {read_numbers(bodies, "joint_bodies"),
                                 read_parents(above, "joint_parents")};
  const std::vector<Vec3> posed = read_positions(positions, model.vertex_count());
  const auto contacts =
      read_pairs<Contact, std::uint32_t>(at_rest, "at_rest", model.triangle_count());
  const NearJoints near = [&] {
    const py::gil_scoped_release unlocked;
    return value_of(near_joints(model, of_joints, posed, contacts), "near_joints");
  }();
  Integers found = new_array<std::int32_t>({near.bodies.size()});
  std::copy(near.bodies.begin(), near.bodies.end(), found.mutable_data());
  return {found, array_of_pairs(near.joint_pairs), array_of_pairs(near.joint_pairs_in_zones),
          array_of_zones(near.zones)};
}

}  // namespace

void add_near_joints(py::module_& module) {
  module.def("near_joints", &all_near_joints, py::arg("model"), py::arg("bodies"), py::arg("above"),
             py::arg("positions"), py::arg("at_rest"));
}

}  // namespace pelt::python

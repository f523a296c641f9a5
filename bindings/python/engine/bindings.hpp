#pragma once

/// Each function adds the classes and functions of one file to the Python module.

#include <pybind11/pybind11.h>

namespace pelt::python {

void add_model(pybind11::module_& module);
void add_poses(pybind11::module_& module);
void add_character(pybind11::module_& module);
void add_collide(pybind11::module_& module);
void add_self_collide(pybind11::module_& module);
void add_near_joints(pybind11::module_& module);
void add_self_distance(pybind11::module_& module);
void add_crowd(pybind11::module_& module);
void add_motion(pybind11::module_& module);
void add_distance(pybind11::module_& module);
void add_solid(pybind11::module_& module);
void add_height_field(pybind11::module_& module);
void add_rays(pybind11::module_& module);
void add_body_vertices(pybind11::module_& module);
void add_bounds(pybind11::module_& module);
void add_inside(pybind11::module_& module);
void add_contact_geometry(pybind11::module_& module);
void add_volume(pybind11::module_& module);

}  // namespace pelt::python

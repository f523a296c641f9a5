#include <pelt/version.hpp>

#include "bindings/python/engine/argument_error.hpp"
#include "bindings/python/engine/bindings.hpp"

PYBIND11_MODULE(_pelt, module) {
  namespace py = pybind11;
  py::register_exception<pelt::python::ArgumentError>(module, "Error", PyExc_ValueError);
  module.attr("__version__") = PELT_VERSION;
  pelt::python::add_model(module);
  pelt::python::add_poses(module);
  pelt::python::add_character(module);
  pelt::python::add_collide(module);
  pelt::python::add_self_collide(module);
  pelt::python::add_near_joints(module);
  pelt::python::add_self_distance(module);
  pelt::python::add_crowd(module);
  pelt::python::add_motion(module);
  pelt::python::add_distance(module);
  pelt::python::add_solid(module);
  pelt::python::add_height_field(module);
  pelt::python::add_rays(module);
  pelt::python::add_bounds(module);
  pelt::python::add_inside(module);
  pelt::python::add_contact_geometry(module);
  pelt::python::add_volume(module);
  pelt::python::add_body_vertices(module);
}

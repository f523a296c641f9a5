#pragma once

#include <pelt/surface.hpp>

#include <pybind11/pybind11.h>

#include <span>

namespace pelt::python {

/// Returns the geometry of all frames as arrays with the names of pelt.ContactGeometry, except the
/// columns of the contacts. Indices of traces count over all frames.
pybind11::dict geometry_columns(std::span<const ContactGeometry> frames);

}  // namespace pelt::python

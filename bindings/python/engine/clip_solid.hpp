#pragma once

/// A simple solid in all frames of a call.

#include <pelt/solid.hpp>

#include "bindings/python/engine/array_view.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelt::python {

/// A solid that stands still, or that has numbers of its own in each frame. Valid for all queries.
class ClipSolid {
 public:
  /// `kind`: the name of a class of Python, such as "Sphere".
  /// `numbers`: [F, n] or [1, n] the members of the solid, in order.
  ///
  /// Throws an error that names the frame and the member if a number is invalid.
  ClipSolid(const std::string& kind, const py::array& numbers);

  /// F, or 1 for a solid that stands still.
  std::size_t frame_count() const { return solids_.size(); }

  const Solid& at(std::size_t frame) const { return solids_[solids_.size() == 1 ? 0 : frame]; }

 private:
  std::vector<Solid> solids_;
};

}  // namespace pelt::python

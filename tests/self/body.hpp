#pragma once

#include "self_brute_force.hpp"

#include <pelt/self_filter.hpp>

namespace pelt::test {

/// A pose and its filter.
struct Body {
  explicit Body(const Shape& s, const SelfFilterOptions& options = {}, const ModelOptions& how = {})
      : shape(s),
        pose(*build_model(s.view(), how)),
        filter(*build_self_filter(pose.model(), options)) {}

  Shape shape;
  Pose pose;
  SelfFilter filter;
  Scratch scratch;
};

}  // namespace pelt::test

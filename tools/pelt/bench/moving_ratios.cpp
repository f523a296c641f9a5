#include "tools/pelt/bench/moving_ratios.hpp"

#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/methods/moving_methods.hpp"

#include <algorithm>

namespace pelt::tools::bench {
namespace {

/// The cost over that of a question to on_demand.
std::optional<double> over_on_demand(const MovingSceneFigures& scene, const MovingFigures& figures,
                                     MovingQuestion question) {
  const MovingFigures* found = find_figures(scene, methods::kMovingOnDemand.name, question);
  return ratio(&figures.times.mean_us, found ? &found->times.mean_us : nullptr);
}

}  // namespace

const MovingFigures* find_figures(const MovingSceneFigures& scene, std::string_view method,
                                  MovingQuestion question) {
  const auto found = std::find_if(
      scene.figures.begin(), scene.figures.end(),
      [&](const MovingFigures& f) { return f.method == method && f.question == question; });
  return found == scene.figures.end() ? nullptr : &*found;
}

std::optional<double> of_collide(const MovingSceneFigures& scene, const MovingFigures& figures) {
  return over_on_demand(scene, figures, MovingQuestion::collide);
}

std::optional<double> of_on_demand(const MovingSceneFigures& scene, const MovingFigures& figures) {
  return over_on_demand(scene, figures, figures.question);
}

}  // namespace pelt::tools::bench

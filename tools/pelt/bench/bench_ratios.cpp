#include "tools/pelt/bench/bench_ratios.hpp"

#include "tools/pelt/output/text.hpp"

#include <algorithm>

namespace pelt::tools::bench {

bool is_same(const Variant& a, const Variant& b) {
  return a.question == b.question && a.cache == b.cache;
}

const Figures* find_figures(const SceneFigures& scene, const std::string& method,
                            std::uint32_t threads, const Variant& variant) {
  for (const Figures& figures : scene.figures)
    if (figures.method == method && figures.threads == threads && is_same(figures.variant, variant))
      return &figures;
  return nullptr;
}

bool has_method(const SceneFigures& scene, const std::string& method) {
  return std::any_of(scene.figures.begin(), scene.figures.end(),
                     [&](const Figures& figures) { return figures.method == method; });
}

const double* mean_of(const SceneFigures& scene, const std::string& method,
                      const Variant& variant) {
  const Figures* found = find_figures(scene, method, 1, variant);
  return found ? &found->times.mean_us : nullptr;
}

std::optional<double> ratio(const double* dividend, const double* divisor) {
  if (!dividend || !divisor) return std::nullopt;
  return *dividend / *divisor;
}

Ratios ratios_of(const SceneFigures& scene, const Figures& figures) {
  const double* own = &figures.times.mean_us;
  return {ratio(mean_of(scene, "paper", figures.variant), own),
          ratio(mean_of(scene, "eager", figures.variant), own),
          ratio(own, mean_of(scene, "rigid", figures.variant)),
          ratio(own, mean_of(scene, "boxes", figures.variant))};
}

std::string in_words(const std::optional<double>& ratio) {
  return ratio ? output::fixed(*ratio, 2) : "-";
}

}  // namespace pelt::tools::bench

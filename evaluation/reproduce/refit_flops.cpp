#include "evaluation/reproduce/refit_flops.hpp"

#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/specimen.hpp"
#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::SphereModel;

/// Means over all spheres.
struct FlopCount {
  double sets = 0, joints = 0, corners = 0, counted = 0, stated = 0;
  double unexplained = 0;  ///< spheres whose counts differ for another reason than joining sets
};

FlopCount count_flops(const SphereModel& model, const Palette& palette) {
  FlopCount sum;
  const auto count = static_cast<std::uint32_t>(model.tree.nodes.size());
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::span<const paper::JointSet> sets = model.bounds.sets_of(n);
    const int counted = counted_refit(model, n, palette).flops.total();
    const int stated = paper::stated_flops(sets).total();
    const auto set_count = static_cast<int>(sets.size());
    sum.sets += set_count;
    for (const paper::JointSet& set : sets) {
      sum.joints += set.joint_count;
      sum.corners += set.corner_count;
    }
    sum.counted += counted;
    sum.stated += stated;
    sum.unexplained += counted != stated + 2 * (set_count - 1);
  }
  for (double* mean : {&sum.sets, &sum.joints, &sum.corners, &sum.counted, &sum.stated})
    *mean /= count;
  return sum;
}

}  // namespace

Result<Table> flops_table() {
  Table table = {"refit_flops",
                 "Operations of a refit, means over all spheres",
                 {{"character", "character"},
                  {"spheres", "spheres"},
                  {"sets", "joint sets"},
                  {"joints", "joints in them"},
                  {"corners", "corners"},
                  {"counted_flops", "flops, counted"},
                  {"stated_flops", "flops, by the formula"},
                  {"unexplained", "spheres with other differences"}},
                 {},
                 "The formula is the sum of 18 p + 11 m + 8 p m - 2 over the joint sets, of p "
                 "joints and m corners each. One sphere is put around the corners of all sets, "
                 "which takes 2 flops more for each set after the first; the last column "
                 "counts spheres with any other difference."};
  for (const PaperCharacter& character : kPaperCharacters) {
    const Result<Specimen> specimen = make_specimen(character.options);
    if (!specimen) return specimen.error();
    const SphereModel model = paper::build_sphere_model(specimen->mesh);
    const FlopCount flops = count_flops(model, walking_palette(*specimen, 0.3f));
    table.rows.push_back({character.name, static_cast<double>(model.tree.nodes.size()), flops.sets,
                          flops.joints, flops.corners, flops.counted, flops.stated,
                          flops.unexplained});
  }
  return table;
}

}  // namespace pelt::reproduce

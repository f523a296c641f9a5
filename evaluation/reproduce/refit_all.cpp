#include <pelt/pose.hpp>

#include "base/assert.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/refit_cost.hpp"
#include "paper/eager.hpp"
#include "paper/on_demand.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "pose/pose_boxes.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <cstdint>
#include <vector>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using methods::MethodKind;

/// Duration of `work` in microseconds: the median of `repetitions` runs.
template <typename Work>
double median_us(std::uint32_t repetitions, const Work& work) {
  std::vector<double> times;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    tools::bench::Stopwatch watch;
    work();
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return tools::output::median(times);
}

std::uint32_t repetitions_of(const Conditions& conditions) { return conditions.is_quick ? 5 : 25; }

/// Times in which the paper's method refits all spheres of a body, in microseconds.
struct AllSpheres {
  double spheres = 0, on_demand_us = 0, skinning_us = 0, bottom_up_us = 0;
};

AllSpheres refit_all(const Specimen& specimen, const Palette& palette, std::uint32_t repetitions) {
  const paper::SphereModel model = paper::build_sphere_model(specimen.mesh);
  const auto count = static_cast<std::uint32_t>(model.tree.nodes.size());
  paper::Refit refit(model, specimen.mesh.joint_count);
  const auto on_demand = [&] {
    refit.invalidate();
    for (std::uint32_t n = 0; n < count; ++n) refit.refit(n, palette);
  };
  paper::EagerBody eager(specimen.mesh, model.tree);
  AllSpheres all;
  all.spheres = count;
  all.on_demand_us = median_us(repetitions, on_demand);
  all.skinning_us = median_us(repetitions, [&] { eager.skin(palette); });
  all.bottom_up_us = median_us(repetitions, [&] { eager.refit_bottom_up(); });
  return all;
}

/// Times for both men together, in the phases of the scene "approaching".
AllSpheres refit_two_men(const Specimen& man, std::uint32_t repetitions) {
  AllSpheres both;
  for (const float start : {0.0f, 0.55f}) {
    const AllSpheres one = refit_all(man, walking_palette(man, start), repetitions);
    both.spheres += one.spheres;
    both.on_demand_us += one.on_demand_us;
    both.skinning_us += one.skinning_us;
    both.bottom_up_us += one.bottom_up_us;
  }
  return both;
}

/// Time for one body, by a method that does all its work when the palette is set.
double update_us(MethodKind kind, const Specimen& specimen, const Palette& palette,
                 std::uint32_t repetitions) {
  const std::unique_ptr<methods::Method> method = kind.make();
  method->add(specimen.model);
  return median_us(repetitions, [&] {
    const Result<void> taken = method->set_palette(0, palette.joints());
    PELT_ASSERT(taken);
  });
}

/// Computes all boxes of Pelt's tree from the bounds that queries use.
double all_bounds_us(const Specimen& specimen, const Palette& palette, std::uint32_t repetitions) {
  Pose pose(specimen.model);
  return median_us(repetitions, [&] {
    const Result<void> taken = pose.set_palette(palette.joints());
    PELT_ASSERT(taken);
    const detail::PosedTree tree = pose.detail().posed_tree();
    make_table(tree);
    detail::compute_all_bounds(tree);
  });
}

double build_us(const Specimen& specimen, std::uint32_t repetitions) {
  return median_us(repetitions, [&] {
    const Result<SkinnedModel> model = build_model(specimen.asset.mesh());
    PELT_ASSERT(model);
  });
}

std::vector<Cell> rebuild_row(const char* name, const Specimen& specimen,
                              const Conditions& conditions) {
  const Palette palette = walking_palette(specimen, 0.3f);
  const std::uint32_t repetitions = repetitions_of(conditions);
  const std::uint32_t builds = conditions.is_quick ? 1 : 5;
  const AllSpheres all = refit_all(specimen, palette, repetitions);
  const double rebuild = update_us(lab::kPaperRigid, specimen, palette, builds);
  const double opened = all_bounds_us(specimen, palette, repetitions);
  const double build = build_us(specimen, builds);
  return {name,
          static_cast<double>(specimen.mesh.triangle_count()),
          all.on_demand_us,
          all.skinning_us + all.bottom_up_us,
          rebuild,
          rebuild / all.on_demand_us,
          rebuild / (all.skinning_us + all.bottom_up_us),
          kPaperRebuildOverRefit,
          opened,
          update_us(methods::kEager, specimen, palette, repetitions),
          build,
          build / opened};
}

}  // namespace

Result<Table> all_spheres_table(const Conditions& conditions) {
  const Result<Specimen> man = make_specimen(scenes::kMan);
  if (!man) return man.error();
  const AllSpheres all = refit_two_men(*man, repetitions_of(conditions));
  const auto row = [](const char* what, double spheres, double on_demand, double bottom_up,
                      Cell skinning) -> std::vector<Cell> {
    return {what,
            spheres,
            on_demand,
            1e6 * on_demand / spheres,
            bottom_up,
            skinning,
            on_demand / bottom_up};
  };
  const double on_demand = all.on_demand_us / 1000, bottom_up = all.bottom_up_us / 1000;
  Table table = {
      "all_spheres",
      "All spheres of the two men",
      {{"what", "what"},
       {"spheres", "spheres"},
       {"on_demand_ms", "refitted on demand [ms]"},
       {"on_demand_ns", "per sphere [ns]"},
       {"bottom_up_ms", "refitted bottom-up [ms]"},
       {"skinning_ms", "skinning before that [ms]"},
       {"ratio", "time on demand / bottom-up"}},
      {row("here", all.spheres, on_demand, bottom_up, all.skinning_us / 1000),
       row("in the paper", kPaperSpheresOfTheMen, kPaperAllOnDemand, kPaperAllBottomUp, Cell())},
      "The paper does not say whether its bottom-up time includes skinning, nor which spheres it "
      "counts: two of its men have more triangles than that, and each triangle is a leaf."};
  table.rows.push_back({"improvement since, factor", Cell(), kPaperAllOnDemand / on_demand,
                        kPaperAllOnDemand / on_demand * all.spheres / kPaperSpheresOfTheMen,
                        kPaperAllBottomUp / bottom_up, Cell(),
                        kPaperAllOnDemand / kPaperAllBottomUp / (on_demand / bottom_up)});
  return table;
}

Result<Table> rebuild_table(const Conditions& conditions) {
  Table table = {
      "rebuild",
      "Refitting all bounds, and building trees again",
      {{"character", "character"},
       {"triangles", "triangles"},
       {"paper_on_demand_us", "spheres on demand [us]"},
       {"paper_bottom_up_us", "spheres bottom-up [us]"},
       {"paper_rebuild_us", "building the sphere tree [us]"},
       {"paper_over_on_demand", "build / on demand"},
       {"paper_over_bottom_up", "build / bottom-up"},
       {"printed_over_bottom_up", "build / bottom-up, boxes, cited by the paper"},
       {"on_demand_us", "Pelt [us]"},
       {"eager_us", "Pelt eager [us]"},
       {"build_us", "building Pelt's model [us]"},
       {"ratio", "build / Pelt"}},
      {},
      "All methods except the paper's refit on demand also pose all vertices. A model is "
      "built from its rest pose, including all data that other poses need."};
  for (const PaperCharacter& character : kPaperCharacters) {
    const Result<Specimen> specimen = make_specimen(character.options);
    if (!specimen) return specimen.error();
    table.rows.push_back(rebuild_row(character.name, *specimen, conditions));
  }
  return table;
}

}  // namespace pelt::reproduce

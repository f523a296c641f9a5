#include "evaluation/reproduce/experiment.hpp"

#include <array>

namespace pelt::reproduce {
namespace {

constexpr std::array kExperiments = {
    Experiment{"characters", "The characters (Table 1)", characters},
    Experiment{"sphere_trees", "The trees (section 5, section 3.1's constant)", sphere_trees},
    Experiment{"tightness", "How tight refitted bounds are (Table 2, Figure 4)", tightness},
    Experiment{"refit_cost", "The cost of a refit (sections 4.2 and 5)", refit_cost},
    Experiment{"two_men", "Two men walk towards each other (Figure 5)", two_men},
    Experiment{"worst_case", "Two creatures walk through each other (Figure 6)", worst_case},
    Experiment{"subdivision", "Dwarves, subdivided (Table 3, Figure 7)", subdivision},
    Experiment{"crowd", "A crowd of fifty creatures (Figure 1)", crowd_of_fifty},
    Experiment{"real_pairs", "Intersecting real characters", real_pairs},
    Experiment{"growth", "How queries grow", growth},
    Experiment{"self_collision", "Characters against themselves", self_collision},
    Experiment{"between_frames", "Between frames", between_frames},
    Experiment{"comparison", "The open comparison: trees, hashing, image space", comparison},
};

}  // namespace

std::span<const Experiment> experiments() { return kExperiments; }

const Experiment* peers_experiment() {
#ifdef PELT_HAS_PEERS
  static constexpr Experiment kPeers = {"peers", "Other libraries", peers};
  return &kPeers;
#else
  return nullptr;
#endif
}

}  // namespace pelt::reproduce

#include "tools/reproduce/experiment.hpp"

#include <array>

namespace pelt::reproduce {
namespace {

constexpr std::array kExperiments = {
    Experiment{"characters", "The characters (Table 1)", characters},
    Experiment{"sphere_trees", "The trees (section 5, section 3.1's constant)", sphere_trees},
    Experiment{"tightness", "How tight refitted bounds are (Table 2, Figure 4)", tightness},
};

}  // namespace

std::span<const Experiment> experiments() { return kExperiments; }

}  // namespace pelt::reproduce

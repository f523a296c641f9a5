#pragma once

/// Redraws the figures of the paper that show characters from computed data.

#include "evaluation/reproduce/experiment.hpp"
#include "evaluation/reproduce/specimen.hpp"
#include "scenes/scene.hpp"

namespace pelt::reproduce {

/// Figure 4: the creature at rest (above) and in that pose (below), with the spheres of levels 4
/// and 6.
Picture level_picture(const Specimen& creature, const detail::Palette& palette,
                      const Conditions& conditions);

/// The frame of Figure 5, in which the two first touch.
inline constexpr std::uint32_t kRefitFrame = 117;

/// Figure 5: two men, and the same with the spheres of levels 5 and 6: blue if the query refitted
/// them, otherwise red. Precondition: two instances of one character.
Result<Picture> refit_picture(const scenes::Scene& scene, const Conditions& conditions);

/// Figure 6: two creatures before, during and after passing through each other.
Result<Picture> passing_picture(const scenes::Scene& scene, const Conditions& conditions);

/// Figure 7: the first frames of both scenes side by side, and contacts of the second scene in
/// close-up, also with its triangles subdivided.
Result<Picture> dwarves_picture(const scenes::Scene& apart, const scenes::Scene& interfering,
                                const scenes::Scene& subdivided, const Conditions& conditions);

/// Figure 1: the first frame of a crowd.
Result<Picture> crowd_picture(const scenes::Scene& scene, const Conditions& conditions);

}  // namespace pelt::reproduce

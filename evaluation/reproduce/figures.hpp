#pragma once

/// Redraws the figures of the paper that show characters from computed data: with the spheres of
/// the paper's trees, and with a magnifying glass for details that are too small to see.

#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/report.hpp"
#include "paper/on_demand.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/picture/still.hpp"

namespace pelt::reproduce {

/// The root is on level 1.
std::vector<std::uint32_t> nodes_on_level(const paper::SphereTree& tree, std::uint32_t level);

/// A body after a query that refitted the spheres it needed.
struct AskedBody {
  std::vector<paper::Float4> spheres;  ///< of all nodes, under the palette of the query
  std::vector<bool> refitted;          ///< by node: whether the query refitted it
};

struct AskedPair {
  std::array<AskedBody, 2> bodies;
  QueryStats work;
};

/// Queries two bodies of one model for all contacts.
AskedPair ask_on_demand(const detail::SkinnedMesh& mesh, const paper::SphereModel& model,
                        const std::array<detail::Palette, 2>& palettes);

/// The spheres of all nodes, each refitted.
std::vector<paper::Float4> all_refitted(const paper::SphereModel& model,
                                        const detail::Palette& palette);

struct Lens {
  detail::Vec3d focus;  ///< on the stage
  double reach;         ///< radius of the magnified ball around the focus
  double x, y, radius;  ///< in the picture, from its middle, in half heights
};

/// The magnified part of `objects`, translated by `shift`, and a ring around that part on the stage
/// with a line to the lens.
std::string magnified(const Lens& lens, const std::string& objects, const detail::Vec3d& shift,
                      const tools::picture::PovCamera& camera);

/// The middle of the triangles in contact within `reach` of the triangle with most such neighbours;
/// the origin if nothing touches.
detail::Vec3d densest_contact(const tools::picture::StillFrame& still, double reach);

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

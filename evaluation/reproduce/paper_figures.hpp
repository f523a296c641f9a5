#pragma once

/// The figures that Kavan & Zara 2005 print, for comparison with ours. Times are from a 2.5 GHz
/// Athlon; only ratios can be compared.

#include "scenes/creature.hpp"

#include <array>

namespace pelt::reproduce {

/// A character of Table 1, and the generated character of the same size.
struct PaperCharacter {
  const char* name;
  double vertices, triangles, joints;
  scenes::CreatureOptions options;
};

inline constexpr std::array kPaperCharacters = {
    PaperCharacter{"dwarf", 859, 1664, 45, scenes::kDwarf},
    PaperCharacter{"man", 4435, 8270, 27, scenes::kMan},
    PaperCharacter{"creature", 6682, 13590, 56, scenes::kCreature}};

/// Section 5, the creature's tree before and after collapsing.
inline constexpr double kPaperSpheresBefore = 27079, kPaperSpheresAfter = 18679;
inline constexpr double kPaperDepthBefore = 22, kPaperDepthAfter = 9;
inline constexpr double kPaperMostChildren = 15, kPaperCollapseRatio = 0.6;
inline constexpr std::array kPaperRadiiBefore = {
    34.55, 31.82, 23.63, 18.86, 13.07, 7.32, 4.86, 3.46, 2.60, 1.92, 1.47,
    1.14,  0.90,  0.72,  0.61,  0.53,  0.47, 0.42, 0.39, 0.38, 0.37, 0.36};

/// Table 2, by level.
inline constexpr std::array kPaperReference = {34.55, 18.86, 7.38, 3.68, 1.69,
                                               0.91,  0.61,  0.42, 0.30};
inline constexpr std::array kPaperOnDemand = {43.89, 26.17, 8.05, 3.95, 1.77,
                                              0.94,  0.63,  0.43, 0.30};
inline constexpr std::array kPaperBottomUp = {45.68, 24.63, 9.21, 4.58, 2.27,
                                              1.17,  0.74,  0.49, 0.35};
inline constexpr std::array kPaperBest = {33.33, 19.39, 7.31, 3.70, 1.70, 0.92, 0.61, 0.42, 0.30};

/// Times of the two men (Figure 5) and of the worst case (Figure 6) in milliseconds.
inline constexpr double kPaperTwoMenOnDemand = 0.36, kPaperTwoMenBottomUp = 18.13;
inline constexpr double kPaperWorstOnDemand = 6.97, kPaperWorstBottomUp = 37.1;
inline constexpr double kPaperWorstFirstOnDemand = 0.82, kPaperWorstFirstBottomUp = 30.18;

/// Times of the crowd (Figure 1) in milliseconds.
inline constexpr double kPaperCrowdOnDemand = 52.83, kPaperCrowdBottomUp = 779.3;

/// Section 2, citing van den Bergen 1997: the cost of rebuilding a tree over the cost of refitting
/// it.
inline constexpr double kPaperRebuildOverRefit = 10;

/// Time to refit all spheres of the two men in milliseconds.
inline constexpr double kPaperSpheresOfTheMen = 15339;
inline constexpr double kPaperAllOnDemand = 20.21, kPaperAllBottomUp = 17.28;

/// Table 3 and section 5, by subdivisions; times in milliseconds.
inline constexpr std::array kPaperApartSpeedUps = {32.0, 126.0, 502.0, 1995.0};
inline constexpr std::array kPaperDwarvesSpheres = {2046.0, 8821.0, 36506.0, 147025.0};
inline constexpr std::array kPaperDwarvesContacts = {46.0, 90.0, 178.0, 350.0};
inline constexpr std::array kPaperDwarvesOnDemand = {1.33, 2.17, 3.8, 8.04};
inline constexpr std::array kPaperDwarvesOnDemandPairs = {4866.0, 9309.0, 17083.0, 37682.0};
inline constexpr std::array kPaperDwarvesBottomUp = {5.24, 18.1, 66.37, 260.0};
inline constexpr std::array kPaperDwarvesBottomUpPairs = {9515.0, 19833.0, 40527.0, 86437.0};
inline constexpr std::array kPaperDwarvesSpeedUps = {3.9, 8.34, 17.47, 32.34};
inline constexpr double kPaperRigidQuery = 0.7, kPaperRigidBuild = 1549;

}  // namespace pelt::reproduce

#pragma once

/// The methods that only the comparison needs, beside those of the command.

#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::methods {

std::unique_ptr<Method> make_rigid();
std::unique_ptr<Method> make_paper_eq2();
std::unique_ptr<Method> make_paper_eager();
std::unique_ptr<Method> make_paper_rigid();
std::unique_ptr<Method> make_aabb_refit();
std::unique_ptr<Method> make_aabb_rebuild();
std::unique_ptr<Method> make_hybrid();
std::unique_ptr<Method> make_hash();
std::unique_ptr<Method> make_hash_overlap();
std::unique_ptr<Method> make_bd_tree();

/// The yardstick: what the same query costs rigid bodies. For each palette the tree is built afresh
/// over the posed mesh, and all is opened with exact boxes; a query then has no more to do than one
/// between rigid bodies. The last two palettes of a body are remembered, so that going to and fro
/// between two frames builds nothing.
inline constexpr MethodKind kRigid = {"rigid", Skins::first, make_rigid};

/// The paper's method with the un-optimised bound of its eq. 2.
inline constexpr MethodKind kPaperEq2 = {"paper_eq2", Skins::where_queried, make_paper_eq2};

/// The paper's rival: all vertices skinned, the same sphere tree refitted bottom-up.
inline constexpr MethodKind kPaperEager = {"paper_eager", Skins::first, make_paper_eager};

/// A sphere tree built afresh over the posed mesh.
inline constexpr MethodKind kPaperRigid = {"paper_rigid", Skins::first, make_paper_rigid};

/// van den Bergen 1997: all vertices skinned, a tree of boxes refitted.
inline constexpr MethodKind kAabbRefit = {"aabb_refit", Skins::first, make_aabb_refit};

/// The same tree built afresh.
inline constexpr MethodKind kAabbRebuild = {"aabb_rebuild", Skins::first, make_aabb_rebuild};

/// Larsson & Akenine-Moller 2001: that tree, its upper half refitted, the rest on demand.
inline constexpr MethodKind kHybrid = {"hybrid", Skins::first, make_hybrid};

/// Teschner et al. 2003: all triangles hashed into cells.
inline constexpr MethodKind kHash = {"hash", Skins::first, make_hash};

/// The same where the bodies' boxes overlap, cells sorted.
inline constexpr MethodKind kHashOverlap = {"hash_overlap", Skins::first, make_hash_overlap};

/// James & Pai 2004: spheres from the entries of the joint matrices, on demand.
inline constexpr MethodKind kBdTree = {"bd_tree", Skins::where_queried, make_bd_tree};

/// What the program `pelt-lab` offers: the command's methods and these.
inline constexpr std::array kLabMethods = {
    kOnDemand,  kEager,       kRigid,  kPaper, kPaperEq2,    kPaperEager, kPaperRigid,
    kAabbRefit, kAabbRebuild, kHybrid, kHash,  kHashOverlap, kBdTree,     kBrute};

}  // namespace pelt::methods

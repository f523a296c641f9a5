#pragma once

/// Methods that are used only for comparison, in addition to the methods of the command.

#include "evaluation/rivals/posed_mesh_method.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/method.hpp"

namespace pelt::lab {

using methods::Method;
using methods::MethodKind;
using methods::Skins;

/// Adapts a method that starts from posed vertices. For every new palette, the adapter skins all
/// vertices with the library's fastest code. This time counts as part of the method's cost.
std::unique_ptr<Method> adapt(std::unique_ptr<rivals::PosedMeshMethod> method);

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
std::unique_ptr<Method> make_self_eager();

/// A lower bound for comparison: the cost of the same query between rigid bodies. For each palette,
/// builds the tree again over the posed mesh and opens all nodes with exact boxes, so a query does
/// no more work than a query between rigid bodies. Stores the last two palettes of a body, so
/// alternating between two frames builds nothing.
inline constexpr MethodKind kRigid = {"rigid", Skins::first, make_rigid};

/// The paper's method with the bound of its eq. 2, which is not optimised.
inline constexpr MethodKind kPaperEq2 = {"paper_eq2", Skins::where_queried, make_paper_eq2};

/// The method that the paper compares with: skins all vertices, refits the same sphere tree
/// bottom-up.
inline constexpr MethodKind kPaperEager = {"paper_eager", Skins::first, make_paper_eager};

/// Builds a new sphere tree over the posed mesh.
inline constexpr MethodKind kPaperRigid = {"paper_rigid", Skins::first, make_paper_rigid};

/// van den Bergen 1997: skins all vertices, refits a tree of boxes.
inline constexpr MethodKind kAabbRefit = {"aabb_refit", Skins::first, make_aabb_refit};

/// Builds the same tree again in each frame.
inline constexpr MethodKind kAabbRebuild = {"aabb_rebuild", Skins::first, make_aabb_rebuild};

/// Larsson & Akenine-Moller 2001: the same tree, with its upper half refitted and the rest refitted
/// on demand.
inline constexpr MethodKind kHybrid = {"hybrid", Skins::first, make_hybrid};

/// Teschner et al. 2003: hashes all triangles into cells.
inline constexpr MethodKind kHash = {"hash", Skins::first, make_hash};

/// The same, only where the boxes of the bodies overlap, with sorted cells.
inline constexpr MethodKind kHashOverlap = {"hash_overlap", Skins::first, make_hash_overlap};

/// James & Pai 2004: spheres from the entries of the joint matrices, on demand.
inline constexpr MethodKind kBdTree = {"bd_tree", Skins::where_queried, make_bd_tree};

/// All methods of the program `pelt-lab`: the methods of the command, and these.
inline constexpr std::array kLabMethods = {methods::kOnDemand,
                                           methods::kEager,
                                           kRigid,
                                           methods::kPaper,
                                           kPaperEq2,
                                           kPaperEager,
                                           kPaperRigid,
                                           kAabbRefit,
                                           kAabbRebuild,
                                           kHybrid,
                                           kHash,
                                           kHashOverlap,
                                           kBdTree,
                                           methods::kBrute};

// --- for a character against itself

/// The simplest use of the library's tree: opens all nodes, queries the posed tree against itself
/// as if it were two characters, and decides pairs of neighbours, which always touch, one by one
/// with the exact predicate. Finds each pair twice.
inline constexpr MethodKind kSelfEager = {"eager", Skins::with_boxes, make_self_eager};

inline constexpr std::array kLabSelfMethods = {methods::kSelf, methods::kBoxes, kSelfEager,
                                               methods::kSelfBrute};

}  // namespace pelt::lab

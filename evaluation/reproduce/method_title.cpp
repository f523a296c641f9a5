#include "evaluation/reproduce/method_title.hpp"

#include "base/assert.hpp"

namespace pelt::reproduce {
namespace {

using methods::MethodKind;

struct Words {
  MethodKind method;
  const char *title, *description;
};

constexpr Words kWords[] = {
    {methods::kOnDemand, "Pelt",
     "the library: a tree of boxes with up to eight slots per node; vertices are skinned and boxes "
     "computed only in nodes that a query visits"},
    {methods::kEager, "Pelt eager",
     "the same tree and query, with all vertices skinned and all boxes computed bottom-up first: "
     "our fastest method that refits everything"},
    {lab::kRigid, "Pelt rigid",
     "the same tree and query, with the tree built over the posed mesh, which is not timed: the "
     "cost of a query between rigid bodies"},
    {methods::kPaper, "paper on demand",
     "Kavan & Zara 2005: a tree of spheres, refitted on demand with the optimised bound"},
    {lab::kPaperEq2, "paper eq. 2", "the same with the bound of their equation 2"},
    {lab::kPaperEager, "paper bottom-up",
     "the method that the paper compares with: all vertices skinned, the same tree refitted "
     "bottom-up"},
    {lab::kPaperRigid, "paper rigid",
     "a tree of spheres built over the posed mesh, which is not timed"},
    {lab::kAabbRefit, "AABB refit",
     "van den Bergen 1997: all vertices skinned, a binary tree of boxes refitted bottom-up"},
    {lab::kAabbRebuild, "AABB rebuild", "the same tree, built again for every pose"},
    {lab::kHybrid, "AABB hybrid",
     "Larsson & Akenine-Moller 2001: all vertices skinned, the upper half of that tree "
     "refitted, the lower half only where a query visits it"},
    {lab::kHash, "hash",
     "Teschner et al. 2003: all vertices skinned, all triangles hashed into the cells of a grid"},
    {lab::kHashOverlap, "hash in overlap",
     "the same, only for triangles in the overlap of the two bodies' boxes, with sorted cells"},
    {lab::kBdTree, "BD-tree",
     "James & Pai 2004: spheres refitted on demand from the entries of the joint "
     "matrices, as a reduced model"},
    {methods::kBrute, "brute force", "every triangle of one against every triangle of the other"},
};

const Words& words_of(MethodKind method) {
  for (const Words& words : kWords)
    if (words.method == method) return words;
  PELT_ASSERT(false);
  return kWords[0];
}

}  // namespace

std::string title_of(MethodKind method) { return words_of(method).title; }
std::string description_of(MethodKind method) { return words_of(method).description; }

}  // namespace pelt::reproduce

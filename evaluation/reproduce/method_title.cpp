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
     "Pelt's engine: a tree of boxes eight wide, vertices skinned and boxes computed only where "
     "the "
     "query comes"},
    {methods::kEager, "Pelt eager",
     "the same tree and query after all vertices have been skinned and all boxes taken bottom-up: "
     "the strongest rival that refits everything"},
    {methods::kRigid, "Pelt rigid",
     "the same tree and query built afresh over the posed mesh, which is not counted: what a rigid "
     "body would cost"},
    {methods::kPaper, "paper on demand",
     "Kavan & Zara 2005: a tree of spheres refitted on demand by the optimised bound"},
    {methods::kPaperEq2, "paper eq. 2", "the same with the bound of their equation 2"},
    {methods::kPaperEager, "paper bottom-up",
     "the paper's rival: all vertices skinned, the same tree of spheres refitted bottom-up"},
    {methods::kPaperRigid, "paper rigid",
     "a tree of spheres built afresh over the posed mesh, which is not counted"},
    {methods::kAabbRefit, "AABB refit",
     "van den Bergen 1997: all vertices skinned, a binary tree of boxes refitted bottom-up"},
    {methods::kAabbRebuild, "AABB rebuild", "the same tree built anew for every pose"},
    {methods::kHybrid, "AABB hybrid",
     "Larsson & Akenine-Moller 2001: all vertices skinned, that tree refitted in its upper half, "
     "below only where the query comes"},
    {methods::kHash, "hash",
     "Teschner et al. 2003: all vertices skinned, all triangles hashed into the cells of a grid"},
    {methods::kHashOverlap, "hash in overlap",
     "the same with only the triangles in the overlap of the two bodies' boxes, cells sorted"},
    {methods::kBdTree, "BD-tree",
     "James & Pai 2004: spheres refitted on demand from the entries of the joint matrices, taken "
     "as "
     "a reduced model"},
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

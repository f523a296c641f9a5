#pragma once

/// The functions that exist once for each target, and the choice between them. The floors above
/// declare what they do; this one only knows their names.

#include <pelt/collide.hpp>
#include <pelt/ray.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::detail {

class Palette;
enum class RegionWish;
struct CapsuleRegion;
struct FacesRegion;
struct HeightField;
struct BoxFound;
struct NodeBounds;
struct OpenedNode;
struct PaletteScan;
struct PointGap;
struct PosedTree;
struct PreparedSolid;
struct RegionAnswer;
struct RootBox;
struct Scratch;
struct SearchLimits;
struct SolidGap;
struct Tree;
struct TriangleGap;
template <typename T>
class Stack;

struct WideCode {
  PaletteScan (*scan_palette)(const float* floats, std::size_t joint_count);
  RootBox (*box_root)(const NodeBounds& bounds, const Palette& palette);
  void (*pose_vertices)(const Tree& tree, const Palette& palette, std::span<Vec3> out);
  const RootBox& (*root_box)(const PosedTree& posed, QueryStats& work);
  const OpenedNode& (*open_node)(const PosedTree& posed, std::uint32_t node, QueryStats& work);
  QueryStats (*open_all_exactly)(const PosedTree& posed);
  QueryStats (*open_fully)(const PosedTree& posed);
  QueryStats (*collide_trees)(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                              std::uint32_t max_contacts);
  BoxFound (*bounding_box)(const PosedTree& posed, std::uint32_t levels);
  float (*bounding_radius)(const NodeBounds& bounds, const Palette& palette, const float* centre);
  BoxFound (*bound_of_set)(const NodeBounds& bounds, std::uint32_t set, const Palette& palette);
  BoxFound (*box_places)(const Tree& tree, const Palette& palette,
                         std::span<const std::uint32_t> places);
  QueryStats (*first_hits)(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                           std::span<RayHit> hits);
  QueryStats (*any_hits)(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                         std::span<bool> hit);
  QueryStats (*all_hits)(const PosedTree& posed, const Ray& ray, Facing facing,
                         Stack<RayHit>& hits);
  QueryStats (*winding_number)(const PosedTree& posed, const Vec3& point, int& winding);
  RegionAnswer (*descend_in_faces)(const PosedTree& posed, const FacesRegion& region,
                                   Scratch& scratch, RegionWish wish);
  RegionAnswer (*descend_in_capsule)(const PosedTree& posed, const CapsuleRegion& region,
                                     Scratch& scratch, RegionWish wish);
  QueryStats (*collide_field)(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                              std::uint32_t max_contacts);
  QueryStats (*nearest_field_triangle)(const PosedTree& posed, const HeightField& field,
                                       Scratch& scratch, const SearchLimits& limits,
                                       TriangleGap& nearest);
  QueryStats (*nearest_triangles)(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                  const SearchLimits& limits, TriangleGap& nearest);
  QueryStats (*triangles_within)(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                 double tolerance, std::uint32_t max_pairs);
  QueryStats (*nearest_to_point)(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                                 double max_distance, PointGap& nearest);
  QueryStats (*nearest_to_solid)(const PosedTree& posed, const PreparedSolid& solid,
                                 Scratch& scratch, double max_distance, SolidGap& nearest);
};

/// Those of the active target.
const WideCode& wide_code();

}  // namespace pelt::detail

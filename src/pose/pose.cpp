/// A pose: what the caller sets, its checks, and the table of its opened nodes.

#include "pose/pose.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"
#include "pose/pose_boxes.hpp"
#include "pose/posed_tree.hpp"
#include "skin/skin.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace pelt::detail {

void make_table(const PosedTree& posed) {
  if (posed.opened) return;
  posed.opened = OpenedNodes(static_cast<std::uint32_t>(posed.tree.nodes.size()), posed.arena);
}

/// Limited to what no machine has, because the sum can be larger than a 32-bit std::size_t.
std::size_t bytes_to_open(const Tree& tree) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::ptrdiff_t>::max();
  constexpr auto piece = Arena::size_of_piece;
  std::uint64_t bytes = piece(tree.nodes.size() * sizeof(std::atomic<OpenedNode*>));
  bytes += std::uint64_t{tree.nodes.size()} * piece(sizeof(OpenedNode));
  bytes += std::uint64_t{tree.clusters.size()} * piece(sizeof(TriangleBoxes));
  std::uint64_t positions = 0;
  for (const Node& node : tree.nodes)
    positions += piece(std::size_t{node.vertex_count} * kFloatsPerVertex * sizeof(float));
  bytes += std::max<std::uint64_t>(positions,
                                   piece(bytes_of_positions(tree)) + piece(bytes_of_boxes(tree)));
  return static_cast<std::size_t>(std::min(bytes, kMax));
}

namespace {

bool is_within(float coordinate) { return std::fabs(coordinate) <= kMaxCoordinate; }

/// Precondition: a coordinate is not within the limit.
Problem describe_first(std::span<const Vec3> vertices) {
  std::size_t v = 0;
  const auto is_good = [](const Vec3& p) {
    return is_within(p.x) && is_within(p.y) && is_within(p.z);
  };
  while (is_good(vertices[v])) ++v;
  const Vec3& p = vertices[v];
  return problem("vertices[%zu] is (%g, %g, %g), expected finite coordinates within 2^60", v,
                 static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
}

}  // namespace

GivenVertices copy_given(const Tree& tree, const GivenVertices& given, Arena& arena) {
  std::byte* const positions = arena.allocate(bytes_of_positions(tree));
  std::byte* const boxes = arena.allocate(bytes_of_boxes(tree));
  std::memcpy(positions, given.positions, bytes_of_positions(tree));
  std::memcpy(boxes, given.boxes, bytes_of_boxes(tree));
  return {reinterpret_cast<const float*>(positions), reinterpret_cast<const GivenBox*>(boxes)};
}

Problem check_vertices(const Tree& tree, std::span<const Vec3> vertices) {
  if (vertices.size() != tree.vertex_count())
    return problem("vertices has %zu elements, expected one for each of the model's %u vertices",
                   vertices.size(), tree.vertex_count());
  if (!are_within(vertices)) return describe_first(vertices);
  for (const WeldedVertex& welded : tree.welded_vertices)
    if (!(vertices[welded.vertex] == vertices[welded.into]))
      return problem(
          "vertices[%u] differs from vertices[%u], but the model has merged both because they are "
          "equal in the rest pose: build it with ModelOptions::weld = false",
          welded.vertex, welded.into);
  return {};
}

Result<void> Pose::set_vertices(std::span<const Vec3> vertices) {
  const Tree& tree = model.detail().tree;
  if (Problem found = check_vertices(tree, vertices); !found.empty())
    return invalid_argument(std::move(found));
  close_all();
  given = refit_given(tree, vertices, arena);
  return {};
}

Problem check_offsets(const Tree& tree, std::span<const Vec3> offsets) {
  if (offsets.empty()) return {};
  if (tree.offset_caps.empty())
    return problem("the model has no caps for offsets: set SkinnedMeshView::offset_caps");
  if (offsets.size() == tree.vertex_count()) return {};
  return problem("offsets has %zu elements, expected none or one for each of the %u vertices",
                 offsets.size(), tree.vertex_count());
}

Result<void> Pose::set_offsets(std::span<const Vec3> offsets) {
  if (Problem found = check_offsets(model.detail().tree, offsets); !found.empty())
    return invalid_argument(std::move(found));
  palette.set_offsets(offsets);
  close_all();
  return {};
}

void Pose::reserve() {
  const Tree& tree = model.detail().tree;
  const Arena old = std::exchange(arena, Arena());
  const GivenVertices kept = given;
  close_all();
  arena.reserve(bytes_to_open(tree));
  if (kept) given = copy_given(tree, kept, arena);
}

}  // namespace pelt::detail

namespace pelt {

Pose::Pose(SkinnedModel model) : pose_(std::make_unique<detail::Pose>(std::move(model))) {}
Pose::Pose(Pose&&) noexcept = default;
Pose& Pose::operator=(Pose&&) noexcept = default;
Pose::~Pose() = default;

const SkinnedModel& Pose::model() const { return pose_->model; }

Result<void> Pose::set_palette(const JointMatrices& palette) {
  Result<void> taken = pose_->palette.set(palette);
  if (taken) pose_->close_all();
  return taken;
}

Result<void> Pose::set_dual_quaternions(std::span<const float> dual_quaternions) {
  Result<void> taken = pose_->palette.set_dual_quaternions(dual_quaternions);
  if (taken) pose_->close_all();
  return taken;
}

Result<void> Pose::set_morph_weights(std::span<const float> weights) {
  Result<void> taken = pose_->palette.set_morph_weights(weights);
  if (taken) pose_->close_all();
  return taken;
}

Result<void> Pose::set_vertices(std::span<const Vec3> vertices) {
  return pose_->set_vertices(vertices);
}

Result<void> Pose::set_offsets(std::span<const Vec3> offsets) {
  return pose_->set_offsets(offsets);
}

void Pose::reserve() { pose_->reserve(); }

void posed_vertices(const Pose& pose, std::span<Vec3> out) {
  const detail::Pose& data = pose.detail();
  const detail::Tree& tree = data.model.detail().tree;
  PELT_ASSERT(out.size() == tree.vertex_count());
  if (!data.given) return pose_vertices(tree, data.palette, out);
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = data.given.vertex(tree.vertex_places[v]);
}

std::uint32_t check_offsets(const Pose& pose) {
  const detail::Tree& tree = pose.model().detail().tree;
  const std::span<const Vec3> offsets = pose.detail().palette.offsets();
  std::uint32_t clamped = 0;
  for (std::size_t v = 0; v < offsets.size(); ++v)
    clamped += detail::is_clamped(offsets[v], tree.offset_caps[tree.vertex_places[v]]);
  return clamped;
}

}  // namespace pelt

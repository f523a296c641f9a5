/// ODE's trimesh: OPCODE's binary tree of boxes, refitted by dGeomTriMeshDataUpdate.
///
/// The narrow phase is ODE's own, and finds points for a solver instead of pairs of triangles.
/// Coinciding points are merged. ODE does not report the triangles of a merged point unless a
/// callback provides a number for them. Here, this number represents a group of triangles, and each
/// triangle of one group is assumed to touch each of the other's. Without this, a third of the
/// pairs would be missing; with it, 1 to 7 % are missing, and a few are wrong. OPCODE finds all
/// pairs before the first point is computed, so a small limit saves little.
#include "evaluation/peers/adapters.hpp"

#include <ode/ode.h>

#include <algorithm>
#include <array>

namespace pelt::peers {
namespace {

/// ODE counts contact points in 16 bits.
constexpr std::uint32_t kMaxPoints = 0xffff;

/// Numbers, starting at the number of triangles, that each represent two others.
class TriangleGroups {
 public:
  explicit TriangleGroups(std::size_t triangle_count) : first_(static_cast<int>(triangle_count)) {}

  void clear() { joined_.clear(); }

  int join(int a, int b) {
    joined_.push_back({a, b});
    return first_ + static_cast<int>(joined_.size()) - 1;
  }

  /// Appends the triangles that a number represents.
  void resolve(int number, std::vector<std::uint32_t>& triangles) const {
    if (number < first_) {
      triangles.push_back(static_cast<std::uint32_t>(number));
      return;
    }
    for (const int member : joined_[number - first_]) resolve(member, triangles);
  }

 private:
  int first_;
  std::vector<std::array<int, 2>> joined_;
};

int join_in(dGeomID geom, int a, int b) {
  return static_cast<TriangleGroups*>(dGeomGetData(geom))->join(a, b);
}

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : positions_(rest.begin(), rest.end()),
        groups_(triangles.size()),
        data_(dGeomTriMeshDataCreate()) {
    dGeomTriMeshDataBuildSingle(data_, positions_.data(), sizeof(Vec3),
                                static_cast<int>(positions_.size()), triangles.data(),
                                static_cast<int>(3 * triangles.size()), sizeof(Triangle));
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    dGeomSetData(geom_, &groups_);
    dGeomTriMeshSetTriMergeCallback(geom_, join_in);
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  ~Body() {
    dGeomDestroy(geom_);
    dGeomTriMeshDataDestroy(data_);
  }

  /// ODE borrows the vertices and needs them at the same address.
  void update(std::span<const Vec3> positions) {
    std::copy(positions.begin(), positions.end(), positions_.begin());
    dGeomTriMeshDataUpdate(data_);
  }

  dGeomID geom() const { return geom_; }
  TriangleGroups& groups() { return groups_; }

 private:
  std::vector<Vec3> positions_;
  TriangleGroups groups_;
  dTriMeshDataID data_;
  dGeomID geom_;
};

/// Initialises ODE while it is used, and silences its message about points that were not merged.
class Library {
 public:
  Library() {
    dInitODE2(0);
    dSetMessageHandler([](int, const char*, va_list) {});
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

class OdeMethod final : public MethodOfBodies<Body> {
 public:
  /// The library outlives the bodies.
  ~OdeMethod() override { bodies_.clear(); }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    QueryStats work;
    work.cut_short = max_contacts == 0;
    if (work.cut_short) return work;
    std::uint32_t most = std::min(max_contacts, kMaxPoints);
    while (find(*bodies_[a], *bodies_[b], most) && pairs_.size() < max_contacts &&
           most < kMaxPoints)
      most = std::min(2 * most, kMaxPoints);
    work.cut_short = pairs_.size() >= max_contacts;
    pairs_.resize(std::min<std::size_t>(pairs_.size(), max_contacts));
    contacts.insert(contacts.end(), pairs_.begin(), pairs_.end());
    return work;
  }

 private:
  /// Finds the pairs of at most `most` points; several points may belong to one pair. Returns true
  /// if there may be more points.
  bool find(Body& a, Body& b, std::uint32_t most) {
    pairs_.clear();
    a.groups().clear();
    b.groups().clear();
    const int count =
        dCollide(a.geom(), b.geom(), static_cast<int>(most), points_.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) add_pairs(a, b, points_[i]);
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return static_cast<std::uint32_t>(count) == most;
  }

  void add_pairs(Body& a, Body& b, const dContactGeom& point) {
    group_a_.clear();
    group_b_.clear();
    a.groups().resolve(point.side1, group_a_);
    b.groups().resolve(point.side2, group_b_);
    for (const std::uint32_t triangle_a : group_a_)
      for (const std::uint32_t triangle_b : group_b_) pairs_.push_back({triangle_a, triangle_b});
  }

  Library library_;
  std::vector<dContactGeom> points_ = std::vector<dContactGeom>(kMaxPoints);
  std::vector<Contact> pairs_;
  std::vector<std::uint32_t> group_a_, group_b_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_ode() { return std::make_unique<OdeMethod>(); }

std::string ode_version() { return PELT_ODE_VERSION; }

}  // namespace pelt::peers

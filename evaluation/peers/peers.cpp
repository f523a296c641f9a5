#include "evaluation/peers/peers.hpp"

#include "evaluation/peers/adapters.hpp"

#include <algorithm>

namespace pelt::peers {
namespace {

using Make = std::unique_ptr<rivals::PosedMeshMethod> (*)();

struct Entry {
  Peer peer;
  Make make;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{"fcl", "FCL, AABB tree", fcl_version(), "refit", NarrowPhase::theirs, Answers::exact},
       make_fcl},
      {{"embree", "Embree, rtcCollide", embree_version(), "refit", NarrowPhase::ours,
        Answers::exact},
       make_embree},
      {{"bullet", "Bullet, GImpact", bullet_version(), "refit", NarrowPhase::ours, Answers::exact},
       make_bullet},
      {{"bullet_own", "Bullet, GImpact", bullet_version(), "refit", NarrowPhase::theirs,
        Answers::more},
       make_bullet_own},
      {{"ode", "ODE, trimesh", ode_version(), "refit", NarrowPhase::theirs, Answers::fewer},
       make_ode},
      {{"cgal_tree", "CGAL, AABB_tree", cgal_version(), "rebuild", NarrowPhase::theirs,
        Answers::exact},
       make_cgal_tree},
      {{"cgal_boxes", "CGAL, box_intersection_d", cgal_version(), "boxes", NarrowPhase::ours,
        Answers::exact},
       make_cgal_boxes},
  };
  return all;
}

const std::vector<Entry>& self_entries() {
  static const std::vector<Entry> all = {
      {{"cgal_mesh", "CGAL, self_intersections", cgal_version(), "points", NarrowPhase::theirs,
        Answers::exact},
       make_self_cgal_mesh},
      {{"cgal_boxes", "CGAL, box_self_intersection_d", cgal_version(), "boxes", NarrowPhase::ours,
        Answers::exact},
       make_self_cgal_boxes},
      {{"cgal_boxes_apart", "the same without neighbours", cgal_version(), "boxes",
        NarrowPhase::ours, Answers::fewer},
       make_self_cgal_boxes_apart},
      {{"cgal_boxes_own", "the same without neighbours", cgal_version(), "boxes",
        NarrowPhase::theirs, Answers::fewer},
       make_self_cgal_boxes_own},
      {{"embree", "Embree, rtcCollide", embree_version(), "refit", NarrowPhase::ours,
        Answers::exact},
       make_self_embree},
  };
  return all;
}

std::vector<Peer> peers_of(const std::vector<Entry>& entries) {
  std::vector<Peer> peers;
  for (const Entry& entry : entries) peers.push_back(entry.peer);
  return peers;
}

std::unique_ptr<rivals::PosedMeshMethod> make_named(const std::vector<Entry>& entries,
                                                    std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.peer.name == name; });
  return found == entries.end() ? nullptr : found->make();
}

}  // namespace

std::span<const Peer> all_peers() {
  static const std::vector<Peer> peers = peers_of(entries());
  return peers;
}

std::unique_ptr<rivals::PosedMeshMethod> make_peer(std::string_view name) {
  return make_named(entries(), name);
}

std::span<const Peer> all_self_peers() {
  static const std::vector<Peer> peers = peers_of(self_entries());
  return peers;
}

std::unique_ptr<rivals::PosedMeshMethod> make_self_peer(std::string_view name) {
  return make_named(self_entries(), name);
}

}  // namespace pelt::peers

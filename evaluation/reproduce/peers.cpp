/// Times of other libraries for the same query, and the part of the contacts that they find.

#include "evaluation/peers/moving_peer_figures.hpp"
#include "evaluation/peers/peer_figures.hpp"
#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "text/format.hpp"
#include "tools/pelt/arguments/values.hpp"

namespace pelt::reproduce {
namespace {

/// Pelt's own methods have the same names as in the rest of the report.
std::string shown_name(const std::string& method) {
  constexpr std::string_view kOurs = "pelt ";
  if (!method.starts_with(kOurs)) return method;
  const auto ours =
      methods::find_method(lab::kLabMethods, std::string_view(method).substr(kOurs.size()));
  return ours ? title_of(*ours) : method;
}

std::string own_skinning(tools::Contest contest) {
  if (contest == tools::Contest::self)
    return "Pelt skins during its query, and its tree asked as if it were two characters (Pelt "
           "eager) while it is updated. The cost over Pelt includes skinning only for Pelt.";
  return title_of(methods::kOnDemand) + " skins during its query, " + title_of(methods::kEager) +
         " while it updates its structure.";
}

Table table_of(const std::string& id, const std::string& title, const tools::ScenePeers& scene) {
  Table table = {id,
                 title,
                 {{"library", "library"},
                  {"version", "version"},
                  {"update", "for each pose"},
                  {"narrow_phase", "narrow phase"},
                  {"skinning_us", "skinning [us]"},
                  {"update_us", "structure [us]"},
                  {"all_us", "query, all [us]"},
                  {"frame_us", "frame, all [us]"},
                  {"first_us", "query, first [us]"},
                  {"first_frame_us", "frame, first [us]"},
                  {"missing", "missing pairs"},
                  {"extra", "extra pairs"},
                  {"of_pelt", "cost over Pelt"}},
                 {},
                 text::counted(scene.frames, "frame") + ", " +
                     std::to_string(scene.frames_in_contact) + " of them in contact, with " +
                     text::with_commas(scene.contacts) + " contacts in all. Medians of " +
                     std::to_string(scene.repetitions) +
                     " repetitions, means over the frames; one thread, hot caches. Skinning is "
                     "measured as a separate method; " +
                     own_skinning(scene.contest)};
  for (const tools::PeerFigures& of : scene.methods)
    table.rows.push_back(
        {shown_name(of.method), of.version, of.update, of.narrow_phase,
         of.skinning_us > 0 ? Cell(of.skinning_us) : Cell(), of.update_us, of.all_us, of.frame_us,
         of.first_us, of.first_frame_us, static_cast<double>(of.difference.missing),
         static_cast<double>(of.difference.extra), tools::cost_over_pelt(scene, of)});
  return table;
}

struct PeerWalk {
  const char *id, *title;
  std::string_view scene;
  std::uint32_t frame_count;
  tools::Contest contest = tools::Contest::pairs;
};

Result<Table> measure_peer_walk(const PeerWalk& walk, const Conditions& conditions) {
  const auto scene = scenes::parse_scene(walk.scene, {});
  if (!scene) return scene.error();
  const auto colliders =
      tools::scene::make_colliders(*scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  const std::uint32_t most = conditions.is_quick ? 2 : walk.frame_count;
  const std::vector<std::uint32_t> frames =
      tools::arguments::FrameRange{0, scene->frame_count, (scene->frame_count + most - 1) / most}
          .frames();
  const auto figures = tools::measure_peers(
      {*scene, *colliders, frames}, conditions.is_quick ? 3 : 9, [] {}, walk.contest);
  if (!figures) return figures.error();
  return table_of(walk.id, walk.title, *figures);
}

/// The steps between the frames of the creatures that pass through each other.
Result<Table> measure_moving_peer_walk(const Conditions& conditions) {
  const auto scene = scenes::parse_scene(passing_through_scene(), {});
  if (!scene) return scene.error();
  const auto colliders =
      tools::scene::make_colliders(*scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  const auto steps = lab::choose_steps(
      *scene, tools::arguments::FrameRange{0, scene->frame_count, conditions.is_quick ? 60u : 10u});
  if (!steps) return steps.error();
  const auto figures =
      tools::measure_moving_peers({*scene, *colliders, *steps}, conditions.is_quick ? 3 : 9);
  if (!figures) return figures.error();
  Table table = {"peers_between",
                 "Two creatures through each other, between frames",
                 {{"library", "library"},
                  {"skinning_us", "skinning [us]"},
                  {"update_us", "structure [us]"},
                  {"query_us", "query, with times [us]"},
                  {"step_us", "step [us]"},
                  {"of_pelt", "cost over Pelt"},
                  {"missing", "missing pairs that first touch during a step"},
                  {"missing_at_start", "missing pairs that touch from the start"},
                  {"extra", "extra pairs"},
                  {"early", "times too early"},
                  {"late", "times too late"}},
                 {},
                 text::counted(figures->steps, "step") + ", " +
                     text::with_commas(figures->contacts) + " contacts in all, " +
                     text::with_commas(figures->contacts_at_start) +
                     " of them from the start of the step. A time is wrong if it differs by more "
                     "than 0.0001 of a step. FCL's tolerances are absolute: the last row is FCL "
                     "with positions in millimetres instead of metres."};
  for (const tools::MovingPeerFigures& of : figures->methods)
    table.rows.push_back(
        {shown_name(of.method), of.skinning_us > 0 ? Cell(of.skinning_us) : Cell(), of.update_us,
         of.query_us, of.step_us, of.step_us / figures->methods[0].step_us,
         static_cast<double>(of.difference.missing_later),
         static_cast<double>(of.difference.missing_at_start),
         static_cast<double>(of.difference.extra), static_cast<double>(of.difference.early),
         static_cast<double>(of.difference.late)});
  return table;
}

}  // namespace

Result<Section> peers(const Conditions& conditions) {
  Section section;
  section.text = {
      "Every library gets the vertices from our fastest skinning code, whose time is included, and "
      "runs with the best settings for deforming meshes that we know. Its answer is compared with "
      "the exact one as a set of pairs of triangles: missing pairs touch but are not reported; "
      "extra pairs are reported but do not touch. If the narrow phase is ours, the library only "
      "finds candidate pairs, which are tested as in Pelt. Against itself, cgal_mesh is CGAL's "
      "self_intersections, whose rule for triangles that share a corner or an edge is that of Pelt "
      "for manifold meshes without collapsed triangles and open cracks. cgal_boxes is "
      "box_self_intersection_d; cgal_boxes_apart and cgal_boxes_own leave out pairs of triangles "
      "that share a corner, and miss those that are folded into each other."};
  for (const PeerWalk& walk : {PeerWalk{"peers_two_men", "Two men", approaching_scene(), 6},
                               PeerWalk{"peers_worst_case", "Two creatures through each other",
                                        passing_through_scene(), 12},
                               PeerWalk{"peers_crowd", "Fifty creatures", crowd_scene(), 1},
                               PeerWalk{"peers_self", "Two creatures, each against itself",
                                        passing_through_scene(), 6, tools::Contest::self}}) {
    auto table = measure_peer_walk(walk, conditions);
    if (!table) return table.error();
    section.tables.push_back(std::move(*table));
  }
  auto between = measure_moving_peer_walk(conditions);
  if (!between) return between.error();
  section.tables.push_back(std::move(*between));
  return section;
}

}  // namespace pelt::reproduce

#include "tools/reproduce/eager_split.hpp"

#include "base/assert.hpp"
#include "bench/method.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "paper/eager.hpp"
#include "tools/pelt/scene_query.hpp"
#include "tools/reproduce/median_time.hpp"
#include "tools/reproduce/scene_figures.hpp"
#include "tools/reproduce/scene_texts.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using bench::MethodKind;
using tools::Question;

/// Microseconds of a frame.
struct Split {
  double skinning = 0, refit = 0, query = 0;
};

/// An instance as the paper's rival has it.
struct EagerInstance {
  explicit EagerInstance(const tools::Collider& collider)
      : instance(collider.instance),
        mesh(detail::unpack_mesh(collider.model.detail().tree)),
        tree(paper::build_sphere_tree(mesh.rest_positions, mesh.triangles)),
        palette(mesh.joint_count, mesh.rest_extent),
        body(mesh, tree) {}

  EagerInstance(const EagerInstance&) = delete;
  EagerInstance& operator=(const EagerInstance&) = delete;

  std::uint32_t instance;
  detail::SkinnedMesh mesh;
  paper::SphereTree tree;
  detail::Palette palette;
  paper::EagerBody body;
};

/// Of the palettes that two instances have.
Split split_of(EagerInstance& a, EagerInstance& b, std::uint32_t repetitions) {
  Split split;
  split.skinning = median_us(repetitions, [&] {
    a.body.skin(a.palette);
    b.body.skin(b.palette);
  });
  split.refit = median_us(repetitions, [&] {
    a.body.refit_bottom_up();
    b.body.refit_bottom_up();
  });
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  split.query = median_us(repetitions, [&] {
    contacts.clear();
    collide(a.body, b.body, scratch, contacts, UINT32_MAX);
  });
  return split;
}

/// The mean over so many frames of a scene of two.
Result<Split> paper_split(const scenes::Scene& scene, std::uint32_t frames,
                          std::uint32_t repetitions) {
  const auto colliders = tools::make_colliders(scene, tools::Granularity::instance, {});
  if (!colliders) return colliders.error();
  PELT_ASSERT(colliders->size() == 2);
  EagerInstance a((*colliders)[0]), b((*colliders)[1]);
  asset::SampleScratch scratch;
  tools::Palettes palettes;
  Split mean;
  for (std::uint32_t i = 0; i < frames; ++i) {
    tools::sample_palettes(scene, i * scene.frame_count / frames, scratch, palettes);
    for (EagerInstance* one : {&a, &b})
      if (const auto taken = one->palette.set(palettes[one->instance]); !taken)
        return taken.error();
    const Split split = split_of(a, b, repetitions);
    mean.skinning += split.skinning / frames;
    mean.refit += split.refit / frames;
    mean.query += split.query / frames;
  }
  return mean;
}

Result<Split> our_split(const scenes::Scene& scene, std::uint32_t most_frames,
                        const Conditions& conditions) {
  constexpr std::array kEager = {MethodKind::eager};
  const auto figures = measure_scene(scene, kEager, most_frames, conditions);
  if (!figures) return figures.error();
  const tools::Times& times = figures->figures[0].times;
  const double skinning = figures->skinning.mean_us;
  return Split{skinning, times.mean_update_us - skinning, times.mean_us - times.mean_update_us};
}

std::vector<Cell> split_row(const char* scene, const char* method, const Split& split) {
  const double all = split.skinning + split.refit + split.query;
  const auto percent = [&](double part) { return 100 * part / all; };
  return {scene,
          method,
          split.skinning,
          split.refit,
          split.query,
          all,
          percent(split.skinning),
          percent(split.refit),
          percent(split.query)};
}

Result<void> append_rows(const char* name, std::string_view text, std::uint32_t most_frames,
                         const Conditions& conditions, Table& table) {
  const Result<scenes::Scene> scene = scenes::parse_scene(text, {});
  if (!scene) return scene.error();
  const std::uint32_t frames = conditions.is_quick ? std::max(most_frames / 4, 1u) : most_frames;
  const auto paper = paper_split(*scene, frames, conditions.is_quick ? 3 : 9);
  if (!paper) return paper.error();
  const auto ours = our_split(*scene, most_frames, conditions);
  if (!ours) return ours.error();
  table.rows.push_back(split_row(name, "the paper's, bottom-up", *paper));
  table.rows.push_back(split_row(name, "our eager", *ours));
  return {};
}

}  // namespace

Result<Table> eager_split_table(std::uint32_t most_frames, const Conditions& conditions) {
  Table table = {"eager_split",
                 "Where the time of eager methods goes",
                 {{"scene", "scene"},
                  {"method", "method"},
                  {"skinning_us", "skinning [us]"},
                  {"refit_us", "refit [us]"},
                  {"query_us", "query [us]"},
                  {"all_us", "all [us]"},
                  {"skinning_percent", "skinning [%]"},
                  {"refit_percent", "refit [%]"},
                  {"query_percent", "query [%]"}},
                 {},
                 "A frame, all contacts. Our eager method skins and takes boxes node by node; its "
                 "skinning is told by what all vertices take by themselves, and its refit is the "
                 "rest of the update."};
  if (const auto done = append_rows("two men", approaching_scene(), most_frames, conditions, table);
      !done)
    return done.error();
  if (const auto done =
          append_rows("two creatures", passing_through_scene(), most_frames, conditions, table);
      !done)
    return done.error();
  return table;
}

}  // namespace pelt::reproduce

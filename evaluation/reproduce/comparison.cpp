/// The comparison that the paper proposes in its last lines: trees refitted on demand and bottom-up
/// against rebuilt trees, spatial hashing and image space. All get the same joint palettes and find
/// the same contacts, except the images, which only answer yes or no. Skinning counts for the
/// methods that need skinned vertices, and is also shown separately.

#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/image_space.hpp"

namespace pelt::reproduce {
namespace {

Result<void> measure_all(const scenes::Character& creature, const Conditions& conditions,
                         Section& section) {
  if (const auto done = add_separation(creature, conditions, section); !done) return done;
  if (const auto done = add_resolution(conditions, section); !done) return done;
  if (const auto done = add_instances(creature, conditions, section); !done) return done;
  if (const auto done = add_image_space(creature, conditions, section); !done) return done;
  for (const auto& measure : {time_split, cell_sizes, leaf_sizes, agreement}) {
    auto table = measure(creature, conditions);
    if (!table) return table.error();
    section.tables.push_back(std::move(*table));
  }
  auto clip = clip_table(conditions);
  if (!clip) return clip.error();
  section.tables.push_back(std::move(*clip));
  return {};
}

}  // namespace

Result<Section> comparison(const Conditions& conditions) {
  const auto creature = scenes::generate_character(scenes::kCreature);
  if (!creature) return creature.error();
  Section section;
  if (const auto done = measure_all(*creature, conditions, section); !done) return done.error();
  section.text = {
      "Every method gets the same joint palettes and finds the same contacts, which are compared "
      "before any time is measured. The skinning that a method needs counts as its time. All use "
      "the same exact test of triangles, eight at a time, so the comparison is about finding "
      "pairs. All times are for one thread."};
  for (std::string& answer : answers_of(section)) section.text.push_back(std::move(answer));
  return section;
}

}  // namespace pelt::reproduce

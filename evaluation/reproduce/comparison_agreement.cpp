/// Compares the answers of all methods of the comparison.

#include "evaluation/reproduce/comparison_methods.hpp"
#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/facing_pair.hpp"
#include "evaluation/reproduce/method_title.hpp"
#include "evaluation/rivals/hash_crowd.hpp"

#include <algorithm>
#include <iterator>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

struct Asked {
  std::string title;
  tools::bench::BenchMethod method;
  double missing = 0, extra = 0;
};

std::vector<Asked> all_methods() {
  std::vector<Asked> all;
  for (const MethodKind method : kCompared)
    all.push_back({title_of(method), tools::bench::method_of(method)});
  all.push_back({title_of(lab::kHash) + " in one grid",
                 rival_method("hash_crowd", [] { return rivals::make_hash_crowd(); })});
  return all;
}

/// Number of contacts of `a` that are not in `b`. Both are in ascending order, as for the contacts
/// of one pair.
double without(std::span<const Contact> a, std::span<const Contact> b) {
  std::vector<Contact> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return static_cast<double>(rest.size());
}

Result<std::vector<Contact>> contacts_of(const tools::bench::BenchMethod& method,
                                         std::span<const tools::scene::Collider> colliders,
                                         const tools::scene::Palettes& palettes) {
  tools::bench::Runner runner(colliders, method);
  if (const auto posed = runner.pose(palettes); !posed) return posed.error();
  runner.ask(Question::all);
  return runner.found().contacts;
}

/// Adds the differences between the answers about one pair. Returns the number of contacts of brute
/// force.
Result<double> compare(const scenes::Scene& scene, std::vector<Asked>& methods) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(scene, 0, scratch, palettes);
  const auto exact = contacts_of(tools::bench::method_of(methods::kBrute), *colliders, palettes);
  if (!exact) return exact.error();
  for (Asked& asked : methods) {
    const auto found = contacts_of(asked.method, *colliders, palettes);
    if (!found) return found.error();
    asked.missing += without(*exact, *found);
    asked.extra += without(*found, *exact);
  }
  return static_cast<double>(exact->size());
}

}  // namespace

Result<Table> agreement(const scenes::Character& creature, const Conditions& conditions) {
  std::vector<double> distances = {0.9, 0.8, kTouching, 0.6, 0.45, kDeep, 0.15, 0.0};
  if (conditions.is_quick) distances = {kTouching, kDeep};
  std::vector<Asked> methods = all_methods();
  double contacts = 0;
  for (const double at : distances) {
    const auto found = compare(facing_pair(creature, at), methods);
    if (!found) return found.error();
    contacts += *found;
  }
  Table table = {
      "agreement",
      "Differences between the contacts of each method and those of brute force",
      {{"method", "method"}, {"contacts", "contacts"}, {"missing", "missing"}, {"extra", "extra"}},
      {},
      "For two creatures; sums over " + std::to_string(distances.size()) +
          " distances. The other tables are not written either if two methods give different "
          "answers."};
  for (const Asked& asked : methods)
    table.rows.push_back({asked.title, contacts, asked.missing, asked.extra});
  return table;
}

}  // namespace pelt::reproduce

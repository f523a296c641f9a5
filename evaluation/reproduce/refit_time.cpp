#include "evaluation/reproduce/refit_time.hpp"

#include "paper/counted_refit.hpp"
#include "scenes/creature/random.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::SphereModel;

/// Limits of the nodes of a class. At least kFewest, because the clock is read once for all of
/// them. Times at most kMax, so that they stay in the caches.
constexpr std::size_t kFewest = 8, kMax = 256;

/// Counts the vertices of nodes, each once.
class VertexCounter {
 public:
  explicit VertexCounter(const detail::SkinnedMesh& mesh)
      : mesh_(mesh), last_node_(mesh.vertex_count(), UINT32_MAX) {}

  double count(std::uint32_t node, std::span<const std::uint32_t> triangles) {
    std::uint32_t count = 0;
    for (const std::uint32_t triangle : triangles)
      for (const std::uint32_t vertex : mesh_.triangles[triangle])
        count += std::exchange(last_node_[vertex], node) != node;
    return count;
  }

 private:
  const detail::SkinnedMesh& mesh_;
  std::vector<std::uint32_t> last_node_;  // by vertex: the last node that counted it
};

/// Half octaves: 1, 2, 3, 4 to 5, 6 to 7, 8 to 11, ...
double class_of(double fact) {
  const double octave = std::floor(std::log2(fact)), whole = std::exp2(octave);
  return 2 * octave + (fact >= 1.5 * whole ? 1 : 0);
}

std::vector<std::uint32_t> evenly_chosen(const std::vector<std::uint32_t>& nodes) {
  if (nodes.size() <= kMax) return nodes;
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < kMax; ++i) chosen.push_back(nodes[i * nodes.size() / kMax]);
  return chosen;
}

/// Nodes that are refitted one after the other, without the root.
struct Sample {
  std::vector<std::uint32_t> nodes;
  std::vector<double> microseconds;
};

/// Refits all samples in turn, so that changes in the load of the machine affect all alike.
void time_in_turn(const SphereModel& model, const Palette& palette, std::uint32_t repetitions,
                  std::vector<Sample>& samples) {
  paper::Refit refit(model, static_cast<std::uint32_t>(palette.joints().size()));
  for (std::uint32_t r = 0; r < repetitions; ++r)
    for (Sample& sample : samples) {
      refit.invalidate();
      refit.refit(0, palette);  // the first refit after a change visits all joints
      tools::bench::Stopwatch watch;
      for (const std::uint32_t node : sample.nodes) refit.refit(node, palette);
      watch.stop();
      sample.microseconds.push_back(watch.microseconds());
    }
}

NodeFacts mean_of(std::span<const NodeFacts> facts, const std::vector<std::uint32_t>& nodes) {
  NodeFacts mean;
  for (double NodeFacts::*fact :
       {&NodeFacts::joints, &NodeFacts::corners, &NodeFacts::flops, &NodeFacts::vertices}) {
    for (const std::uint32_t node : nodes) mean.*fact += facts[node].*fact;
    mean.*fact /= static_cast<double>(nodes.size());
  }
  return mean;
}

}  // namespace

std::vector<NodeFacts> facts_of(const SphereModel& model, const detail::SkinnedMesh& mesh) {
  VertexCounter vertices(mesh);
  std::vector<NodeFacts> all;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
    const std::span<const paper::JointSet> sets = model.bounds.sets_of(n);
    NodeFacts facts;
    for (const paper::JointSet& set : sets) {
      facts.joints += set.joint_count;
      facts.corners += set.corner_count;
    }
    facts.flops = paper::stated_flops(sets).total();
    facts.vertices = vertices.count(n, model.tree.triangles_of(model.tree.nodes[n]));
    all.push_back(facts);
  }
  return all;
}

std::vector<NodeClass> time_classes(const SphereModel& model, const Palette& palette,
                                    std::span<const NodeFacts> facts, double NodeFacts::*fact,
                                    std::uint32_t repetitions) {
  std::map<double, std::vector<std::uint32_t>> nodes_of;
  for (std::uint32_t n = 1; n < facts.size(); ++n) nodes_of[class_of(facts[n].*fact)].push_back(n);
  std::vector<Sample> samples;
  std::vector<NodeClass> classes;
  for (const auto& [number, nodes] : nodes_of) {
    if (nodes.size() < kFewest) continue;
    samples.push_back({evenly_chosen(nodes), {}});
    classes.push_back({static_cast<double>(nodes.size()), mean_of(facts, samples.back().nodes), 0});
  }
  time_in_turn(model, palette, repetitions, samples);
  for (std::size_t i = 0; i < classes.size(); ++i)
    classes[i].nanoseconds = 1000 * tools::output::median(samples[i].microseconds) /
                             static_cast<double>(samples[i].nodes.size());
  return classes;
}

detail::SkinnedMesh with_one_joint_set(const detail::SkinnedMesh& mesh) {
  detail::SkinnedMesh other = mesh;
  other.influences.clear();
  other.influence_begin = {0};
  scenes::SplitMix64 random(1);
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    const auto weight = static_cast<float>(random.between(0.25, 0.75));
    other.influences.push_back({0, weight});
    other.influences.push_back({1, 1 - weight});
    other.influence_begin.push_back(static_cast<std::uint32_t>(other.influences.size()));
  }
  return other;
}

}  // namespace pelt::reproduce

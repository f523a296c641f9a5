#include "evaluation/reproduce/subdivide.hpp"

#include "base/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pelt::reproduce {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // lower vertex first
using Weights = std::map<std::uint16_t, float>;        // of joints

/// The edges in the order in which triangles first use them: new vertex V + i is on edge i.
struct Edges {
  explicit Edges(std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge = std::minmax(t[i], t[(i + 1) % 3]);
        if (number.emplace(edge, list.size()).second) list.push_back(edge);
      }
  }

  std::vector<Edge> list;
  std::map<Edge, std::size_t> number;
};

Weights weights_of(const asset::Asset& asset, std::uint32_t vertex) {
  Weights weights;
  const std::size_t slots = asset.influences_per_vertex;
  for (std::size_t i = slots * vertex; i < slots * (vertex + 1); ++i)
    if (asset.weights[i] > 0) weights[asset.joint_indices[i]] += asset.weights[i];
  return weights;
}

Weights mean(const Weights& a, const Weights& b) {
  Weights all;
  for (const Weights* one : {&a, &b})
    for (const auto& [joint, weight] : *one) all[joint] += 0.5f * weight;
  return all;
}

void set_weights(const std::vector<Weights>& of_vertices, asset::Asset& asset) {
  std::size_t slots = 1;
  for (const Weights& weights : of_vertices) slots = std::max(slots, weights.size());
  asset.influences_per_vertex = static_cast<std::uint32_t>(slots);
  asset.joint_indices.assign(slots * of_vertices.size(), 0);
  asset.weights.assign(slots * of_vertices.size(), 0);
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    std::size_t slot = slots * v;
    for (const auto& [joint, weight] : of_vertices[v]) {
      asset.joint_indices[slot] = joint;
      asset.weights[slot++] = weight;
    }
  }
}

std::vector<Triangle> cut(std::span<const Triangle> triangles, const Edges& edges,
                          std::size_t vertex_count) {
  std::vector<Triangle> fine;
  for (const Triangle& t : triangles) {
    std::array<std::uint32_t, 3> middle;
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] = static_cast<std::uint32_t>(vertex_count +
                                             edges.number.at(std::minmax(t[i], t[(i + 1) % 3])));
    for (std::size_t i = 0; i < 3; ++i) fine.push_back({t[i], middle[i], middle[(i + 2) % 3]});
    fine.push_back({middle[0], middle[1], middle[2]});
  }
  return fine;
}

detail::Vec3d posed(const asset::Asset& asset, std::uint32_t vertex,
                    std::span<const Matrix4> palette) {
  const detail::Vec3d p(asset.rest_positions[vertex]);
  detail::Vec3d sum(0, 0, 0);
  for (const auto& [joint, weight] : weights_of(asset, vertex)) {
    const auto& m = palette[joint].m;
    const auto row = [&](std::size_t r) {
      const auto at = [&](std::size_t column) { return static_cast<double>(m[4 * column + r]); };
      return at(0) * p.x + at(1) * p.y + at(2) * p.z + at(3);
    };
    sum = sum + static_cast<double>(weight) * detail::Vec3d(row(0), row(1), row(2));
  }
  return sum;
}

}  // namespace

asset::Asset subdivided(const asset::Asset& asset) {
  const Edges edges(asset.triangles);
  asset::Asset fine = asset;
  std::vector<Weights> weights;
  for (std::uint32_t v = 0; v < asset.rest_positions.size(); ++v)
    weights.push_back(weights_of(asset, v));
  for (const auto& [a, b] : edges.list) {
    const Vec3 &p = asset.rest_positions[a], &q = asset.rest_positions[b];
    fine.rest_positions.push_back({0.5f * (p.x + q.x), 0.5f * (p.y + q.y), 0.5f * (p.z + q.z)});
    weights.push_back(mean(weights[a], weights[b]));
  }
  set_weights(weights, fine);
  fine.triangles = cut(asset.triangles, edges, asset.rest_positions.size());
  for (asset::Part& part : fine.parts) {
    part.first_triangle *= 4;
    part.triangle_count *= 4;
  }
  return fine;
}

double drift_of(const asset::Asset& coarse, const asset::Asset& fine,
                std::span<const Matrix4> palette) {
  const Edges edges(coarse.triangles);
  double largest = 0;
  for (std::uint32_t i = 0; i < edges.list.size(); ++i) {
    const auto [a, b] = edges.list[i];
    const detail::Vec3d middle = 0.5 * (posed(coarse, a, palette) + posed(coarse, b, palette));
    const auto vertex = static_cast<std::uint32_t>(coarse.rest_positions.size() + i);
    largest = std::max(largest, std::sqrt(squared_length(posed(fine, vertex, palette) - middle)));
  }
  return largest;
}

}  // namespace pelt::reproduce

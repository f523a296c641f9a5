#pragma once

/// Subdivided meshes.

#include <pelt/asset.hpp>

namespace pelt::reproduce {

/// Cuts every triangle into four at the middles of its edges (Kavan & Zara 2005, section 5). At
/// rest, a new vertex is halfway between the ends of its edge, and its weights are the mean of
/// their weights. In other poses the vertex leaves the straight edge if these weights differ: see
/// `drift_of`.
asset::Asset subdivided(const asset::Asset& asset);

/// The largest distance of a new vertex of `fine`, subdivided from `coarse`, from the middle of its
/// edge, posed by `palette`.
double drift_of(const asset::Asset& coarse, const asset::Asset& fine,
                std::span<const Matrix4> palette);

}  // namespace pelt::reproduce

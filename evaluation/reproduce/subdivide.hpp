#pragma once

#include <pelt/asset.hpp>

namespace pelt::reproduce {

/// Every triangle cut into four at the middles of its edges (Kavan & Zara 2005, section 5). A new
/// vertex lies half way between the ends of its edge at rest, and has the mean of their weights. In
/// other poses it leaves the straight edge a little where these weights differ: see `drift_of`.
asset::Asset subdivided(const asset::Asset& asset);

/// How far the new vertices of `fine`, subdivided from `coarse`, lie from the middles of their
/// edges, posed by `palette`: the largest distance.
double drift_of(const asset::Asset& coarse, const asset::Asset& fine,
                std::span<const Matrix4> palette);

}  // namespace pelt::reproduce

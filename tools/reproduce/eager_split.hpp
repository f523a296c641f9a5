#pragma once

#include "tools/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// Where the time of eager methods goes: skinning, refit and query, of two men and of two creatures
/// who walk, on at most so many frames of each, evenly over all (in a quick run a
/// fourth of that).
Result<Table> eager_split_table(std::uint32_t most_frames, const Conditions& conditions);

}  // namespace pelt::reproduce

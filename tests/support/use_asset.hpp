#pragma once

#include <pelt/asset.hpp>

namespace pelt::test {

/// Uses a loaded file as a program would, whatever its content: builds the model, samples its
/// clips, poses it. Returns true if all steps succeed.
bool use_asset(const asset::Asset& asset);

}  // namespace pelt::test

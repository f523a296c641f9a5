#pragma once

#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace pelt::asset {

/// All bytes of a regular file.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

}  // namespace pelt::asset

#pragma once

#include <pelt/result.hpp>

#include "base/exceptions.hpp"

#include <cstddef>
#include <filesystem>
#include <new>
#include <type_traits>
#include <vector>

namespace pelt::asset {

/// Returns the error for a file that needs more memory than is available.
Error out_of_memory(const std::filesystem::path& path);

/// Calls `read`, which returns a Result made from the file at `path`. If memory runs out meanwhile,
/// returns an error that names the file.
template <typename Read>
std::invoke_result_t<Read> within_memory(const std::filesystem::path& path, const Read& read) {
  PELT_TRY { return read(); }
  PELT_CATCH(std::bad_alloc) { return out_of_memory(path); }
}

/// Reads all bytes of a regular file. A file larger than the free memory is an error.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

}  // namespace pelt::asset

#pragma once

#include <pelt/result.hpp>

#include "base/exceptions.hpp"

#include <cstddef>
#include <filesystem>
#include <new>
#include <span>
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

/// Validates the beginning of a file: its first `kBeginning` bytes, or all of a shorter file.
using CheckBeginning = Result<void>(std::span<const std::byte> beginning);
inline constexpr std::size_t kBeginning = 4096;

/// Reads all bytes of a regular file. A file larger than the free memory is an error, and so is an
/// error of `check`, which is called before the rest of the file is read.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path,
                                         CheckBeginning* check = nullptr);

}  // namespace pelt::asset

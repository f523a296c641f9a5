#pragma once

/// Lack of memory as an error message. By default, Linux grants more memory than there is, and
/// kills a process that uses it.

#include <cstdint>
#include <filesystem>

namespace pelt::tools::arguments {

/// Returns the number of bytes that the process can still use: the least of what is available on
/// the machine, including swap, and of what its memory cgroups (version 1 or 2) leave to it.
/// Memory of files in the page cache counts as free. Reads /proc and /sys/fs/cgroup under `root`;
/// returns the largest number if they are absent.
std::uint64_t free_memory(const std::filesystem::path& root = "/");

/// Makes allocations beyond about `free_memory()` throw `std::bad_alloc` from now on, in this
/// process and its children. Does nothing except on Linux.
void limit_memory();

}  // namespace pelt::tools::arguments

#pragma once

/// Files that `pelt prepare` wrote.

#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace pelt::tools::prepared {

/// load_model; the message of an error begins with `name`.
Result<SkinnedModel> load_named_model(const std::string& name, std::span<const std::byte> file);

/// Whether there is such a file and begins like a prepared model.
bool is_prepared_file(const std::filesystem::path& path);

}  // namespace pelt::tools::prepared

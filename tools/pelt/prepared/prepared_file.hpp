#pragma once

/// Files of `pelt prepare`.

#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace pelt::tools::prepared {

/// Calls load_model. Error messages start with `name`.
Result<SkinnedModel> load_named_model(const std::string& name, std::span<const std::byte> file);

/// Whether the file exists and starts like a prepared model.
bool is_prepared_file(const std::filesystem::path& path);

enum class InfoStyle { text, json };

/// Prints the contents of a prepared model to standard output.
Result<void> print_prepared_info(const std::string& path, InfoStyle style);

}  // namespace pelt::tools::prepared

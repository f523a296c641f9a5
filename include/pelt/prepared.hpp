#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pelt {

/// Returns the model as bytes. `load_model` reads these bytes more than ten times faster than
/// `build_model` builds the model. Equal models give equal bytes. docs/prepared-format.md describes
/// the format. A new version of Pelt may support only a new version of the format, so keep the data
/// that the model was built from.
///
/// Cost: O(bytes). Allocates.
PELT_API std::vector<std::byte> save_model(const SkinnedModel& model);

/// Reads a model written by `save_model`. Queries give the same answers and do the same work.
///
/// The bytes are treated as hostile: everything that queries rely on is validated, and memory stays
/// within a small multiple of the size of `file`. A file with carefully forged bounds can make
/// queries miss contacts, but cannot cause anything worse.
///
/// Cost: O(bytes). Allocates. Returns an error that says what is invalid.
PELT_API Result<SkinnedModel> load_model(std::span<const std::byte> file);

/// Returns whether the bytes start like a prepared model. `load_model` may still return an error.
/// O(1).
PELT_API bool is_prepared_model(std::span<const std::byte> file);

}  // namespace pelt

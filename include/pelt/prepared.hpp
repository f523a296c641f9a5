#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pelt {

/// Returns the model as bytes. `load_model` of these bytes is more than ten times as fast as
/// `build_model`. Equal models give equal bytes. docs/prepared-format.md describes the format. A
/// later version of Pelt may reject this format, so keep the data from which the model was built.
///
/// Cost: O(bytes). Allocates.
PELT_API std::vector<std::byte> save_model(const SkinnedModel& model);

/// Reads a model written by `save_model`. Queries of the loaded model give the same answers and do
/// the same work as queries of the saved model.
///
/// The bytes are treated as hostile: `load_model` rejects everything that could make queries read
/// outside their memory or run forever. `load_model` does not check that bounds enclose the
/// vertices: a file with forged bounds can make queries miss contacts, but cannot cause anything
/// worse.
///
/// Cost: O(bytes). Allocates at most a small multiple of the size of `file`.
///
/// Returns an error that says what is invalid.
PELT_API Result<SkinnedModel> load_model(std::span<const std::byte> file);

/// Returns whether the bytes start like a prepared model. `load_model` may still return an error.
///
/// Cost: O(1).
PELT_API bool is_prepared_model(std::span<const std::byte> file);

}  // namespace pelt

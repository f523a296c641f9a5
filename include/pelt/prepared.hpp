#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/model.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pelt {

/// The model as bytes, to be written to a file and read back by `load_model`, which is more than
/// ten times faster than `build_model`. The same model gives the same bytes. The format stands in
/// docs/prepared-format.md; a new version of Pelt may read another version of it only, so what was
/// built from can not be thrown away. O(bytes); allocates.
PELT_API std::vector<std::byte> save_model(const SkinnedModel& model);

/// The model that `save_model` wrote: its queries give the same answers and do the same work.
///
/// The bytes are treated as hostile. Whatever queries rely on is checked, and the message names
/// what is wrong; memory stays within a small multiple of `file`. Bounds that have been forged with
/// care can make a model miss contacts, but nothing worse. O(bytes); allocates.
PELT_API Result<SkinnedModel> load_model(std::span<const std::byte> file);

/// Whether the bytes begin like a prepared model; `load_model` may still refuse them.
PELT_API bool is_prepared_model(std::span<const std::byte> file);

}  // namespace pelt

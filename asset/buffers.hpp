#pragma once

#include "asset/budget.hpp"
#include "asset/document.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <span>

namespace pelt::asset {

/// The bytes of a document's buffers and views. They are read at their first use. Buffers that no
/// mesh or clip uses are never read, and may be missing.
class Buffers {
 public:
  /// Borrows all its arguments. `folder`: where external files are looked up; empty if there are
  /// none.
  Buffers(const GltfDocument& document, std::optional<std::span<const std::byte>> binary_chunk,
          const std::filesystem::path& folder, Budget& budget);

  /// Returns the decompressed bytes of a view. `what` names the user of the view in messages.
  Result<std::span<const std::byte>> view(std::uint32_t view, const std::string& what);

  /// Returns the bytes of a view as they are in its buffer, which may be compressed.
  Result<std::span<const std::byte>> stored_view(std::uint32_t view, const std::string& what);

  /// The views that `view` was called for.
  const std::set<std::uint32_t>& views_read() const { return views_read_; }

 private:
  using Bytes = std::span<const std::byte>;

  Result<Bytes> buffer(std::uint32_t buffer);
  Result<Bytes> fetch(std::uint32_t buffer);
  Result<Bytes> fetch_uri(std::uint32_t buffer);
  Result<Bytes> fetch_file(std::uint32_t buffer);
  Result<Bytes> compressed_view(std::uint32_t view, const std::string& what);
  Result<Bytes> range(std::uint32_t buffer, std::uint64_t offset, std::uint64_t length,
                      const std::string& what);

  const GltfDocument& document_;
  std::optional<Bytes> binary_chunk_;
  const std::filesystem::path& folder_;
  Budget& budget_;
  std::set<std::uint32_t> views_read_;
  std::map<std::uint32_t, Bytes> fetched_;
  std::map<std::uint32_t, std::vector<std::byte>> data_uris_;
  std::map<std::filesystem::path, std::vector<std::byte>> files_;
  std::map<std::uint32_t, std::vector<std::byte>> decompressed_;
};

}  // namespace pelt::asset

#include "asset/buffers.hpp"
#include "asset/file_bytes.hpp"
#include "asset/meshopt.hpp"
#include "asset/uri.hpp"
#include "text/message.hpp"

namespace pelt::asset {

Buffers::Buffers(const GltfDocument& document, std::optional<Bytes> binary_chunk,
                 const std::filesystem::path& folder, Budget& budget)
    : document_(document), binary_chunk_(binary_chunk), folder_(folder), budget_(budget) {}

Result<Buffers::Bytes> Buffers::view(std::uint32_t view, const std::string& what) {
  views_read_.insert(view);
  const std::string name = what + ": " + text::label("bufferView", view);
  return document_.views[view].meshopt ? compressed_view(view, name) : stored_view(view, name);
}

Result<Buffers::Bytes> Buffers::stored_view(std::uint32_t view, const std::string& what) {
  const GltfView& source = document_.views[view];
  if (!source.meshopt) return range(source.buffer, source.offset, source.length, what);
  const GltfMeshopt& meshopt = *source.meshopt;
  return range(meshopt.buffer, meshopt.offset, meshopt.length, what);
}

Result<Buffers::Bytes> Buffers::compressed_view(std::uint32_t view, const std::string& what) {
  const auto known = decompressed_.find(view);
  if (known != decompressed_.end()) return Bytes(known->second);
  const GltfMeshopt& meshopt = *document_.views[view].meshopt;
  const Result<Bytes> compressed = stored_view(view, what);
  if (!compressed) return compressed.error();
  Result<std::vector<std::byte>> bytes = decode_meshopt(meshopt, *compressed, budget_, what);
  if (!bytes) return bytes.error();
  if (bytes->size() != document_.views[view].length) {
    return text::malformed(what +
                           ": byteLength is not count * byteStride of EXT_meshopt_compression");
  }
  return Bytes(decompressed_[view] = *std::move(bytes));
}

Result<Buffers::Bytes> Buffers::range(std::uint32_t buffer_index, std::uint64_t offset,
                                      std::uint64_t length, const std::string& what) {
  const Result<Bytes> bytes = buffer(buffer_index);
  if (!bytes) return text::prefixed(what, bytes.error());
  if (offset > bytes->size() || length > bytes->size() - offset) {
    return text::malformed(what + ": " + std::to_string(length) + " bytes at " +
                           std::to_string(offset) + " reach beyond the " +
                           std::to_string(bytes->size()) + " bytes of " +
                           text::label("buffer", buffer_index));
  }
  return bytes->subspan(offset, length);
}

Result<Buffers::Bytes> Buffers::buffer(std::uint32_t buffer) {
  const auto known = fetched_.find(buffer);
  if (known != fetched_.end()) return known->second;
  const Result<Bytes> bytes = fetch(buffer);
  if (!bytes) return text::prefixed(text::label("buffer", buffer), bytes.error());
  const std::uint64_t length = document_.buffers[buffer].length;
  if (bytes->size() < length) {
    return text::malformed(text::label("buffer", buffer) + ": byteLength is " +
                           std::to_string(length) + ", but there are only " +
                           std::to_string(bytes->size()) + " bytes");
  }
  return fetched_[buffer] = bytes->first(length);
}

Result<Buffers::Bytes> Buffers::fetch(std::uint32_t buffer) {
  if (document_.buffers[buffer].uri) return fetch_uri(buffer);
  if (document_.buffers[buffer].meshopt_fallback) {
    return text::malformed("is the fallback of compressed views and has no bytes of its own");
  }
  if (buffer == 0 && binary_chunk_) return *binary_chunk_;
  return text::malformed("has neither a uri nor the binary chunk of a .glb");
}

Result<Buffers::Bytes> Buffers::fetch_uri(std::uint32_t buffer) {
  const std::string& uri = *document_.buffers[buffer].uri;
  if (!is_data_uri(uri)) return fetch_file(buffer);
  Result<std::vector<std::byte>> bytes = decode_data_uri(uri);
  if (!bytes) return bytes.error();
  return Bytes(data_uris_[buffer] = *std::move(bytes));
}

Result<Buffers::Bytes> Buffers::fetch_file(std::uint32_t buffer) {
  const Result<std::filesystem::path> path =
      resolve_file_uri(*document_.buffers[buffer].uri, folder_);
  if (!path) return path.error();
  const auto known = files_.find(*path);
  if (known != files_.end()) return Bytes(known->second);
  Result<std::vector<std::byte>> bytes = read_file(*path);
  if (!bytes) return bytes.error();
  budget_.grant(bytes->size());
  return Bytes(files_[*path] = *std::move(bytes));
}

}  // namespace pelt::asset

#include "asset/container.hpp"
#include "asset/little_endian.hpp"
#include "text/message.hpp"

#include <algorithm>

namespace pelt::asset {

namespace {

constexpr std::uint32_t kMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;  // "BIN\0"

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Error cut_short(const std::string& how) {
  return text::malformed("the .glb is truncated: " + how + ": copy or export it again");
}

/// Returns the text without the mark of UTF-8 and white space at its start.
std::string_view without_space(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.substr(0, kMark.size()) == kMark) text.remove_prefix(kMark.size());
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

Error not_gltf() {
  return text::malformed(
      std::string("the file starts neither like a .glb nor like the JSON object of a .gltf") +
      kExportGltf2);
}

bool begins_like_glb(std::span<const std::byte> file) {
  return file.size() >= 4 && load<std::uint32_t>(file.data()) == kMagic;
}

/// Reads a .gltf file.
Result<Container> read_text(std::string_view text) {
  if (without_space(text).starts_with('{')) return Container{text, {}};
  if (text.empty()) return text::malformed("the file is empty: copy or export it again");
  return not_gltf();
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};

/// Cuts the first chunk off `rest`.
Result<Chunk> next_chunk(std::span<const std::byte>& rest) {
  constexpr std::size_t kHeader = 8;
  if (rest.size() < kHeader) return cut_short("it ends inside the header of a chunk");
  const auto length = load<std::uint32_t>(rest.data());
  if (length > rest.size() - kHeader) {
    return cut_short("a chunk of " + std::to_string(length) + " bytes has only " +
                     std::to_string(rest.size() - kHeader));
  }
  const Chunk chunk{load<std::uint32_t>(rest.data() + 4), rest.subspan(kHeader, length)};
  rest = rest.subspan(kHeader + length);
  return chunk;
}

Result<Container> read_chunks(std::span<const std::byte> rest) {
  const Result<Chunk> json = next_chunk(rest);
  if (!json) return json.error();
  if (json->type != kJson)
    return text::malformed(std::string("the first chunk of the .glb must be the JSON text") +
                           kExportGltf2);
  Container container{as_text(json->bytes), {}};
  while (!rest.empty()) {
    const Result<Chunk> chunk = next_chunk(rest);
    if (!chunk) return chunk.error();
    if (chunk->type == kBinary && !container.binary) container.binary = chunk->bytes;
  }
  return container;
}

}  // namespace

Result<Container> open_container(std::span<const std::byte> file) {
  constexpr std::size_t kHeader = 12;
  if (!begins_like_glb(file)) return read_text(as_text(file));
  if (file.size() < kHeader) return cut_short("it ends inside its header");
  const auto version = load<std::uint32_t>(file.data() + 4);
  const auto length = load<std::uint32_t>(file.data() + 8);
  if (version != 2) {
    return text::unsupported("Pelt reads .glb version 2, this is version " +
                             std::to_string(version) + kExportGltf2);
  }
  if (length < kHeader) {
    return text::malformed("the .glb says that it has " + std::to_string(length) +
                           " bytes, less than its header: export it again");
  }
  if (length > file.size()) {
    return cut_short("it says that it has " + std::to_string(length) + " bytes, it has " +
                     std::to_string(file.size()));
  }
  return read_chunks(file.subspan(kHeader, length - kHeader));
}

Result<void> check_beginning(std::span<const std::byte> beginning) {
  const std::string_view text = without_space(as_text(beginning));
  if (begins_like_glb(beginning) || text.empty() || text.starts_with('{')) return {};
  return not_gltf();
}

}  // namespace pelt::asset

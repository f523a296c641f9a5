#include "asset/file_bytes.hpp"

#include "text/message.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace pelt::asset {

namespace {

Error unreadable(const std::filesystem::path& path, const char* why) {
  return {ErrorCode::unreadable_file, path.string() + ": " + why};
}

Result<std::ifstream> open_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable(path, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) return unreadable(path, "is not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unreadable(path, "cannot be opened for reading");
  return stream;
}

Result<void> fill(std::ifstream& stream, const std::filesystem::path& path,
                  std::span<std::byte> bytes) {
  const auto size = static_cast<std::streamsize>(bytes.size());
  stream.read(reinterpret_cast<char*>(bytes.data()), size);
  if (stream.gcount() != size) return unreadable(path, "was truncated while it was read");
  return {};
}

Result<void> check_file(std::ifstream& stream, const std::filesystem::path& path,
                        std::uintmax_t size, CheckBeginning* check) {
  std::array<std::byte, kBeginning> room;
  const auto beginning =
      std::span(room).first(static_cast<std::size_t>(std::min<std::uintmax_t>(size, kBeginning)));
  if (const Result<void> filled = fill(stream, path, beginning); !filled) return filled;
  if (const Result<void> checked = check(beginning); !checked)
    return text::prefixed(path.string(), checked.error());
  stream.seekg(0);
  return {};
}

Result<std::vector<std::byte>> read_regular_file(const std::filesystem::path& path,
                                                 CheckBeginning* check) {
  Result<std::ifstream> stream = open_regular_file(path);
  if (!stream) return stream.error();
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return unreadable(path, "cannot be opened for reading");
  if (check) {
    const Result<void> checked = check_file(*stream, path, size, check);
    if (!checked) return checked.error();
  }
  if (size > std::vector<std::byte>().max_size()) return out_of_memory(path);
  std::vector<std::byte> bytes(size);
  const Result<void> filled = fill(*stream, path, bytes);
  if (!filled) return filled.error();
  return bytes;
}

}  // namespace

Error out_of_memory(const std::filesystem::path& path) {
  return unreadable(path, "needs more memory than there is: free some, or make the file smaller");
}

Result<std::vector<std::byte>> read_file(const std::filesystem::path& path, CheckBeginning* check) {
  return within_memory(path, [&] { return read_regular_file(path, check); });
}

}  // namespace pelt::asset

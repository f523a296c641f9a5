#include "asset/file_bytes.hpp"

#include <fstream>
#include <string>

namespace pelt::asset {

namespace {

Error unreadable(const std::filesystem::path& path, const char* why) {
  return {ErrorCode::unreadable_file, path.string() + ": " + why};
}

Result<std::vector<std::byte>> read_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable(path, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) return unreadable(path, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) return unreadable(path, "cannot be opened for reading");
  if (size > std::vector<std::byte>().max_size()) return out_of_memory(path);
  std::vector<std::byte> bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size)
    return unreadable(path, "was truncated while it was read");
  return bytes;
}

}  // namespace

Error out_of_memory(const std::filesystem::path& path) {
  return unreadable(path, "needs more memory than there is: free some, or make the file smaller");
}

Result<std::vector<std::byte>> read_file(const std::filesystem::path& path) {
  return within_memory(path, [&] { return read_regular_file(path); });
}

}  // namespace pelt::asset

#include "tools/pelt/prepared/prepared_file.hpp"

#include <pelt/model.hpp>

#include "asset/file_bytes.hpp"
#include "asset/message.hpp"

#include <array>
#include <fstream>

namespace pelt::tools::prepared {

Result<SkinnedModel> load_named_model(const std::string& name, std::span<const std::byte> file) {
  Result<SkinnedModel> model = asset::within_memory(name, [&] { return load_model(file); });
  if (model || model.error().code == ErrorCode::unreadable_file) return model;
  return asset::prefixed(name, model.error());
}

bool is_prepared_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;  // a pipe is read only once
  std::array<char, 8> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return is_prepared_model(std::as_bytes(std::span(begin)));
}

}  // namespace pelt::tools::prepared

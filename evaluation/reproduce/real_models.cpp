#include "evaluation/reproduce/real_models.hpp"

#include <algorithm>
#include <system_error>

namespace pelt::reproduce {

std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".glb") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace pelt::reproduce

#include "asset/budget.hpp"

#include "text/message.hpp"

#include <algorithm>

namespace pelt::asset {

void Budget::grant(std::uint64_t bytes) {
  const std::uint64_t room = (kMax - granted_) / kExpansion;
  const std::uint64_t more = std::min(bytes, room) * kExpansion;
  granted_ += more;
  left_ += more;
}

Result<void> Budget::take(std::uint64_t count, std::uint64_t size, const std::string& what) {
  if (count > left_ / size) {
    const std::string most = granted_ < kMax - kExpansion
                                 ? std::to_string(kExpansion) + " times its size in memory"
                                 : std::to_string(kMax >> 20) + " MiB of memory";
    return text::malformed(what + ": " + std::to_string(count) +
                           " elements are out of proportion: the file would take more than " +
                           most);
  }
  left_ -= count * size;
  return {};
}

}  // namespace pelt::asset

#pragma once

/// What touched in an earlier check, for `pelt check --baseline`.

#include "tools/pelt/touch_name.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace pelt::tools {

/// What a check was asked, as far as its touches depend on that.
struct CheckQuestion {
  std::string by;  ///< "instance" or "part"
  std::optional<double> clearance;
};

class KnownTouches {
 public:
  /// `text` is what `pelt check --jsonl` wrote; `path` is for messages. Refuses the answer to
  /// another question, and one that a limit cut short.
  static Result<KnownTouches> parse(const std::string& path, std::string_view text,
                                    const CheckQuestion& question);

  static Result<KnownTouches> read(const std::string& path, const CheckQuestion& question);

  /// The most contacts of one frame; 0 if they did not touch.
  std::uint64_t worst(const TouchName& a, const TouchName& b) const;

  std::size_t size() const { return worst_.size(); }

 private:
  std::map<std::pair<TouchName, TouchName>, std::uint64_t> worst_;
};

}  // namespace pelt::tools

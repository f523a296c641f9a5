#pragma once

/// Whether a check has failed: on what was found, or on what is worse than in an earlier check.

#include "tools/pelt/known_touches.hpp"

#include <optional>
#include <span>
#include <vector>

namespace pelt::tools {

enum class FailOn {
  contact,  ///< any contact
  grown,    ///< a touch that is new, or has more contacts in its worst frame than it had
  newly,    ///< a touch that is new
  never,
};

/// Nothing for an unknown name.
std::optional<FailOn> find_fail_on(std::string_view name);
const char* name_of(FailOn fail_on);

/// A touch that is worse than it was.
struct Worse {
  Touch touch;
  std::uint64_t known = 0;  ///< contacts of its worst frame then; 0: it is new
};

/// What has become worse since `known`, most contacts first.
std::vector<Worse> find_worse(const scenes::Scene& scene, std::span<const Touch> touches,
                              const KnownTouches& known);

struct Verdict {
  FailOn fail_on = FailOn::contact;
  bool is_failed = false;
  bool has_baseline = false;
  std::vector<Worse> worse;  ///< since the baseline
};

/// `known` may be null only where `fail_on` asks for nothing that was known.
Verdict judge(const scenes::Scene& scene, std::span<const Touch> touches, const KnownTouches* known,
              FailOn fail_on);

}  // namespace pelt::tools

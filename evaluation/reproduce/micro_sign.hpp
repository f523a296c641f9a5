#pragma once

#include <string>

namespace pelt::reproduce {

/// `text` for a page, where the unit "us" has its Greek letter, UTF-8: "query [us]", "12.5 us".
std::string with_micro_signs(const std::string& text);

}  // namespace pelt::reproduce

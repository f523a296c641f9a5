#pragma once

#include <string>

namespace pelt::reproduce {

/// `text` for a page, with the Greek letter (UTF-8) in the unit "us": "query [us]", "12.5 us".
std::string with_micro_signs(const std::string& text);

}  // namespace pelt::reproduce

#pragma once

#include <string>

namespace pelt::tools::output {

/// Bytes as text (RFC 4648, section 4), to stand inside a page.
std::string base64(const std::string& bytes);

}  // namespace pelt::tools::output

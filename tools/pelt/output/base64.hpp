#pragma once

#include <string>

namespace pelt::tools::output {

/// Encodes bytes as text (RFC 4648, section 4), for embedding in a page.
std::string base64(const std::string& bytes);

}  // namespace pelt::tools::output

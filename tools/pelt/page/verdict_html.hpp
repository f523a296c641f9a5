#pragma once

/// The result of a check for readers whose browser does not run the page's script.

#include "tools/pelt/page/page_data.hpp"

#include <string>

namespace pelt::tools::page {

/// Result and command in two sentences, as HTML; empty without an answer.
std::string verdict_html(const PageData& data);

}  // namespace pelt::tools::page

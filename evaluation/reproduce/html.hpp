#pragma once

/// The report as a single self-contained page.

#include "evaluation/reproduce/report.hpp"

#include <map>
#include <string>

namespace pelt::reproduce {

/// The page. `images` has the bytes of charts (SVG) and pictures (PNG) by id; the page says which
/// are missing. `provenance` has lines about machine, build and date.
std::string html_page(const std::vector<Section>& sections,
                      const std::vector<std::string>& provenance,
                      const std::map<std::string, std::string>& images);

}  // namespace pelt::reproduce

#pragma once

/// The report on disk: report.html, results.json, and in folders csv, charts and pictures what they
/// are made of.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>
#include <iosfwd>

namespace pelt::reproduce {

struct Report {
  std::vector<std::string> provenance;  ///< machine, build, date: a line each
  std::vector<Section> sections;
};

std::string csv_of(const Table& table);
std::string json_of(const Report& report);

/// Makes the folder with those inside it, or says why not: before minutes of work, not after.
Result<void> make_folders(const std::filesystem::path& folder);

/// Writes everything into `folder`. Precondition: its folders have been made. Charts and pictures
/// whose program is missing are left out, and `messages` says what to install.
Result<void> write_report(const Report& report, const std::filesystem::path& folder,
                          std::ostream& messages);

}  // namespace pelt::reproduce

#pragma once

/// The report on disk: report.html, results.json, and their sources in the folders csv, charts and
/// pictures.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace pelt::reproduce {

struct Report {
  std::vector<std::string> provenance;  ///< machine, build, date: one line each
  std::vector<Section> sections;
};

std::string csv_of(const Table& table);
std::string json_of(const Report& report);

/// Creates the folder and its subfolders. Called before the experiments, so that an error costs no
/// minutes of work.
Result<void> make_folders(const std::filesystem::path& folder);

/// Returns the files of an earlier report in `folder`, and other files that a report may replace.
std::vector<std::filesystem::path> replaced_files(const std::filesystem::path& folder);

/// Writes all files into `folder`. Leaves out charts and pictures whose program is missing;
/// `messages` then says what to install. Precondition: make_folders has succeeded.
Result<void> write_report(const Report& report, const std::filesystem::path& folder,
                          std::ostream& messages);

}  // namespace pelt::reproduce

#include "tools/pelt/output/line_output.hpp"

#include "tools/pelt/output/output.hpp"

#include <iostream>
#include <utility>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;

}  // namespace

LineOutput::~LineOutput() {
  if (partial_.empty()) return;
  file_.close();
  std::error_code ignored;
  fs::remove(partial_, ignored);
}

Result<void> LineOutput::open(const std::string& path) {
  path_ = path;
  if (path.empty()) return {};
  const bool standard = path == kStandardOutput;
  if (!standard) open_file();
  stream_ = standard ? &std::cout : &file_;
  return *stream_ ? Result<void>() : unwritable(path_);
}

void LineOutput::open_file() {
  std::error_code error;
  const bool exists = fs::exists(path_, error);
  place_ = exists ? fs::canonical(path_, error) : fs::path(path_);
  if (!exists || fs::is_regular_file(place_, error)) {
    fs::path partial = place_;
    partial += ".partial";
    file_.open(partial, std::ios::binary);
    if (file_) partial_ = std::move(partial);
  }
  // A file can be open to writing where its folder is not.
  if (partial_.empty()) file_.open(path_, std::ios::binary);
}

Result<void> LineOutput::close() {
  if (stream_ == nullptr) return {};
  stream_->flush();
  return *stream_ && move_into_place() ? Result<void>() : unwritable(path_);
}

bool LineOutput::move_into_place() {
  if (partial_.empty()) return true;
  file_.close();
  std::error_code error;
  const fs::file_status known = fs::status(place_, error);
  if (fs::exists(known)) fs::permissions(partial_, known.permissions(), error);
  fs::rename(partial_, place_, error);
  if (error) return false;
  partial_.clear();
  return true;
}

std::ostream& words_beside(const std::string& jsonl) {
  return jsonl == kStandardOutput ? std::cerr : std::cout;
}

}  // namespace pelt::tools::output

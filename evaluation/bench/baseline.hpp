#pragma once

/// Figures of an earlier run, read from a file of --json. Errors name the file, the value and the
/// remedy.

#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/bench/table.hpp"

#include <pelt/result.hpp>

#include <string_view>

namespace pelt::lab {

/// A value that is compared.
struct Field {
  enum class Kind {
    text,   ///< not empty
    name,   ///< one of `names`
    count,  ///< a whole number
    hash,   ///< 16 hexadecimal digits
    time,   ///< positive, because it is a divisor
  };

  const char* name;
  Kind kind;
  std::vector<const char*> names = {};
  const char* former = nullptr;  ///< name in version 0.1, if it was another
};

/// A kind of file.
struct FiguresFormat {
  const char* name;     ///< the value of `format`
  const char* command;  ///< which writes it
  std::vector<Field> scene, method;
};

/// What `pelt bench` and `pelt-lab bench` write.
extern const FiguresFormat kFramesFormat;

/// What `pelt-lab bench --moving` writes.
extern const FiguresFormat kStepsFormat;

struct Baseline {
  std::string path;  ///< as given by the user
  tools::bench::Machine machine;
  std::vector<tools::bench::Row> scenes;  ///< only compared values, and the rows "methods"
};

/// `path` is for messages.
Result<Baseline> parse_baseline(const std::string& path, std::string_view text,
                                const FiguresFormat& format);

Result<Baseline> read_baseline(const std::string& path, const FiguresFormat& format);

}  // namespace pelt::lab

#include "evaluation/bench/against.hpp"

#include "text/format.hpp"
#include "text/printable.hpp"

#include <algorithm>
#include <iomanip>
#include <set>

namespace pelt::lab {
namespace {

using text::counted;
using tools::bench::find_row;
using tools::bench::Row;
using tools::bench::Yardstick;

constexpr int kKey = 13, kNumber = 10, kMark = 7;

std::span<const Row> methods_of(const Row& scene) {
  return scene["methods"].get_ref<const Row::array_t&>();
}

std::string text_in(const Row& row, const char* name) { return row[name].get<std::string>(); }

std::string in_words(const Row& ratio) {
  return ratio.is_null() ? "-" : text::fixed(ratio.get<double>(), 2);
}

/// The query and the method of each row, in words.
std::set<std::string> names_in(const Row& scene) {
  std::set<std::string> names;
  for (const Row& row : methods_of(scene)) {
    std::string query = "query " + text_in(row, "query"), method = text_in(row, "method");
    if (row.contains("cache")) query += " with " + text_in(row, "cache") + " caches";
    const bool is_crowd = row.contains("asked") && row["asked"] == "crowd";
    names.insert(query);
    names.insert(is_crowd ? "crowd of " + method + " on " +
                                counted(row["threads"].get<std::uint64_t>(), "thread")
                          : "method " + method);
  }
  return names;
}

/// Another hash of the same query in `then`, or null.
const Row* other_hash(const Row& then, const Row& now) {
  for (const Row& row : methods_of(then))
    if (row["query"] == now["query"] && row["hash"] != now["hash"]) return &row["hash"];
  return nullptr;
}

/// Compares scenes with those of a baseline, and prints the result.
class Comparer {
 public:
  Comparer(const ComparedFigures& compared, const Baseline& baseline, std::uint32_t margin_percent,
           std::ostream& out)
      : compared_(compared),
        baseline_(baseline),
        path_(text::printable(baseline.path)),
        count_(compared.unit + std::string("s")),
        limit_(1 + margin_percent / 100.0),
        out_(out) {}

  void compare(const Row& now) {
    const Row* then = find_row(baseline_.scenes, {{"scene", now["scene"]}});
    const auto count = now[count_].get<std::uint64_t>();
    out_ << '\n' << text::printable(text_in(now, "scene")) << ": ";
    if (!then)
      out_ << path_ << " does not contain this scene\n";
    else if ((*then)[count_] != count)
      out_ << counted(count, compared_.unit) << ", not the "
           << text::with_commas((*then)[count_].get<std::uint64_t>()) << " of " << path_
           << ": not compared\n";
    else
      compare(*then, now);
  }

  const Comparison& result() const { return result_; }

 private:
  void compare(const Row& then, const Row& now) {
    out_ << counted(now[count_].get<std::uint64_t>(), compared_.unit);
    if (now.contains("time")) {
      out_ << ", " << text_in(now, "time") << " time";
      if (then["time"] != now["time"]) out_ << ", " << text_in(then, "time") << " time then";
    }
    out_ << '\n';
    print_lacking(then, now);
    const std::set<std::string> different = print_different_answers(then, now);
    const std::vector<Yardstick> yardsticks = yardsticks_of(now);
    print_head(yardsticks);
    const auto& left_out = compared_.left_out;
    for (const Row& row : methods_of(now))
      if (different.count(text_in(row, "query")) == 0 &&
          std::find(left_out.begin(), left_out.end(), row["method"]) == left_out.end())
        print_row(then, now, row, yardsticks);
  }

  void print_lacking(const Row& then, const Row& now) {
    const std::set<std::string> known = names_in(then);
    for (const std::string& name : names_in(now))
      if (known.count(name) == 0) out_ << path_ << " has no " << text::printable(name) << '\n';
  }

  /// Figures for different answers cannot be compared. Returns their queries.
  std::set<std::string> print_different_answers(const Row& then, const Row& now) {
    std::set<std::string> different;
    for (const Row& row : methods_of(now)) {
      const Row* hash = other_hash(then, row);
      if (!hash || !different.insert(text_in(row, "query")).second) continue;
      out_ << "query " << text_in(row, "query") << ": different answers: hash "
           << hash->get<std::string>() << " then, " << text_in(row, "hash")
           << " now: not compared\n";
      ++result_.different_answers;
    }
    return different;
  }

  /// Those that the tables of times show.
  std::vector<Yardstick> yardsticks_of(const Row& scene) const {
    std::vector<Yardstick> shown;
    for (const Yardstick& yardstick : compared_.yardsticks)
      if (find_row(methods_of(scene), {{"method", yardstick.method}}) ||
          (yardstick.is_for_pairs && !scene.contains("sequence")))
        shown.push_back(yardstick);
    return shown;
  }

  void print_head(std::span<const Yardstick> yardsticks) {
    out_ << std::string(kKey * compared_.keys.size(), ' ');
    for (const Yardstick& yardstick : yardsticks)
      out_ << std::setw(3 * kNumber) << yardstick.title << std::string(kMark, ' ');
    out_ << '\n';
    for (const char* key : compared_.keys) print_key(key);
    for (std::size_t i = 0; i < yardsticks.size(); ++i)
      out_ << std::setw(kNumber) << "then" << std::setw(kNumber) << "now" << std::setw(kNumber)
           << "now/then" << std::string(kMark, ' ');
    out_ << '\n';
  }

  void print_key(const std::string& text) {
    out_ << std::left << std::setw(kKey) << text << std::right;
  }

  void print_row(const Row& then, const Row& now, const Row& row,
                 std::span<const Yardstick> yardsticks) {
    Row like;
    for (const char* key : compared_.keys) {
      like[key] = row[key];
      print_key(row[key].is_string() ? text_in(row, key) : row[key].dump());
    }
    const Row* before = find_row(methods_of(then), like);
    for (const Yardstick& yardstick : yardsticks) {
      const bool is_itself = row["method"] == yardstick.method &&
                             (!yardstick.query || row["query"] == yardstick.query);
      const auto ratio = [&](const Row& scene, const Row* of) {
        return of && !is_itself ? ratio_to(yardstick, methods_of(scene), *of) : Row();
      };
      print_ratio(ratio(then, before), ratio(now, &row), yardstick.is_cost);
    }
    out_ << '\n';
  }

  void print_ratio(const Row& then, const Row& now, bool is_cost) {
    Row change;
    if (!then.is_null() && !now.is_null()) change = now.get<double>() / then.get<double>();
    const bool is_worse =
        !change.is_null() && (is_cost ? change.get<double>() : 1 / change.get<double>()) > limit_;
    for (const Row& number : {then, now, change}) out_ << std::setw(kNumber) << in_words(number);
    out_ << std::left << std::setw(kMark) << (is_worse ? " worse" : "") << std::right;
    result_.ratios += !change.is_null();
    result_.worse += is_worse;
  }

  const ComparedFigures& compared_;
  const Baseline& baseline_;
  std::string path_, count_;
  double limit_;
  std::ostream& out_;
  Comparison result_;
};

}  // namespace

Comparison print_comparison(const ComparedFigures& compared, const Baseline& then,
                            std::span<const Row> now, std::uint32_t margin_percent,
                            std::ostream& out) {
  Comparer comparer(compared, then, margin_percent, out);
  out << "against " << text::printable(then.path) << ": "
      << text::printable(tools::bench::in_words(then.machine)) << '\n';
  for (const Row& scene : now) comparer.compare(scene);
  const Comparison& result = comparer.result();
  out << '\n'
      << result.worse << " of " << counted(result.ratios, "ratio") << " worse by more than "
      << margin_percent << " %\n";
  return result;
}

}  // namespace pelt::lab

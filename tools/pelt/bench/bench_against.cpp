#include "tools/pelt/bench/bench_against.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <iomanip>
#include <set>

namespace pelt::tools::bench {
namespace {

constexpr int kQuery = 7, kCache = 6, kMethod = 13, kThreads = 8, kNumber = 10, kMark = 7;

enum class Better { higher, lower };

/// A ratio, and the method that it refers to.
struct Column {
  const char* title;
  const char* yardstick;
  std::optional<double> Ratios::*ratio;
  Better better;
};

constexpr Column kColumns[] = {{"vs paper", "paper", &Ratios::vs_paper, Better::higher},
                               {"vs eager", "eager", &Ratios::vs_eager, Better::higher},
                               {"of rigid", "rigid", &Ratios::of_rigid, Better::lower},
                               {"of boxes", "boxes", &Ratios::of_boxes, Better::lower}};

/// Speed-ups over the methods of pairs, and costs over the methods that were measured.
std::vector<Column> columns_of(const SceneFigures& scene) {
  std::vector<Column> columns(std::begin(kColumns), std::end(kColumns));
  std::erase_if(columns, [&](const Column& column) {
    const bool is_of_pairs = column.better == Better::higher && !scene.self_filters;
    return !is_of_pairs && !has_method(scene, column.yardstick);
  });
  return columns;
}

/// These rows would repeat the other rows with the opposite meaning: worse if another method has
/// become faster.
bool is_yardstick_only(const Figures& figures) {
  return figures.method == "paper" || figures.method == "rigid" || figures.asked == Asked::none;
}

std::string variant_name(const Variant& variant) {
  return std::string("query ") + name_of(variant.question) + " with " + name_of(variant.cache) +
         " caches";
}

std::string method_name(const Figures& figures) {
  if (figures.asked != Asked::crowd) return "method " + figures.method;
  return "crowd of " + figures.method + " on " + output::counted(figures.threads, "thread");
}

std::set<std::string> names_in(const SceneFigures& scene) {
  std::set<std::string> names;
  for (const Figures& figures : scene.figures) {
    names.insert(variant_name(figures.variant));
    names.insert(method_name(figures));
  }
  return names;
}

/// Another hash of the same query in `then`; nullopt if all hashes equal that of `now`.
std::optional<std::uint64_t> other_hash(const SceneFigures& then, const Figures& now) {
  for (const Figures& figures : then.figures)
    if (figures.variant.question == now.variant.question && figures.answer.hash != now.answer.hash)
      return figures.answer.hash;
  return std::nullopt;
}

/// Compares scenes with those of a baseline, and prints the result.
class Comparer {
 public:
  Comparer(const Baseline& baseline, std::uint32_t margin_percent, std::ostream& out)
      : baseline_(baseline), limit_(1 + margin_percent / 100.0), out_(out) {}

  void compare(const SceneFigures& now) {
    const auto& scenes = baseline_.scenes;
    const auto then = std::find_if(scenes.begin(), scenes.end(),
                                   [&](const SceneFigures& s) { return s.scene == now.scene; });
    out_ << '\n' << asset::printable(now.scene) << ": ";
    if (then == scenes.end())
      out_ << asset::printable(baseline_.path) << " does not contain this scene\n";
    else if (then->frames != now.frames)
      out_ << output::counted(now.frames, "frame") << ", not the "
           << output::with_commas(then->frames) << " of " << asset::printable(baseline_.path)
           << ": not compared\n";
    else
      compare(*then, now);
  }

  const BenchComparison& result() const { return result_; }

 private:
  void compare(const SceneFigures& then, const SceneFigures& now) {
    out_ << output::counted(now.frames, "frame") << ", " << name_of(now.time) << " time";
    if (then.time != now.time) out_ << ", " << name_of(then.time) << " time then";
    out_ << '\n';
    print_lacking(then, now);
    const std::set<Question> different = print_different_answers(then, now);
    print_head(now);
    for (const Figures& figures : now.figures)
      if (!is_yardstick_only(figures) && different.count(figures.variant.question) == 0)
        print_row(then, now, figures);
  }

  void print_lacking(const SceneFigures& then, const SceneFigures& now) {
    const std::set<std::string> known = names_in(then);
    for (const std::string& name : names_in(now))
      if (known.count(name) == 0)
        out_ << asset::printable(baseline_.path) << " has no " << asset::printable(name) << '\n';
  }

  /// Figures for different answers cannot be compared.
  std::set<Question> print_different_answers(const SceneFigures& then, const SceneFigures& now) {
    std::set<Question> different;
    for (const Figures& figures : now.figures) {
      const std::optional<std::uint64_t> hash = other_hash(then, figures);
      if (!hash || !different.insert(figures.variant.question).second) continue;
      out_ << "query " << name_of(figures.variant.question) << ": different answers: hash "
           << output::hex16(*hash) << " then, " << output::hex16(figures.answer.hash)
           << " now: not compared\n";
      ++result_.different_answers;
    }
    return different;
  }

  void print_head(const SceneFigures& now) {
    const std::vector<Column> columns = columns_of(now);
    out_ << std::string(kQuery + kCache + kMethod + kThreads, ' ');
    for (const Column& column : columns)
      out_ << std::setw(3 * kNumber) << column.title << std::string(kMark, ' ');
    out_ << '\n';
    print_names("query", "cache", "method", "threads");
    for (std::size_t i = 0; i < columns.size(); ++i)
      out_ << std::setw(kNumber) << "then" << std::setw(kNumber) << "now" << std::setw(kNumber)
           << "now/then" << std::string(kMark, ' ');
    out_ << '\n';
  }

  void print_names(const char* query, const char* cache, const std::string& method,
                   const std::string& threads) {
    out_ << std::left << std::setw(kQuery) << query << std::setw(kCache) << cache
         << std::setw(kMethod) << method << std::right << std::setw(kThreads) << threads;
  }

  void print_row(const SceneFigures& then, const SceneFigures& now, const Figures& figures) {
    const Variant& variant = figures.variant;
    const Figures* before = find_figures(then, figures.method, figures.threads, variant);
    const Ratios old = before ? ratios_of(then, *before) : Ratios();
    const Ratios current = ratios_of(now, figures);
    print_names(name_of(variant.question), name_of(variant.cache), figures.method,
                std::to_string(figures.threads));
    for (const Column& column : columns_of(now)) {
      const bool is_itself = figures.method == column.yardstick;
      print_ratio(is_itself ? std::nullopt : old.*column.ratio,
                  is_itself ? std::nullopt : current.*column.ratio, column.better);
    }
    out_ << '\n';
  }

  void print_ratio(const std::optional<double>& then, const std::optional<double>& now,
                   Better better) {
    const std::optional<double> change = ratio(now ? &*now : nullptr, then ? &*then : nullptr);
    const bool is_worse = change && (better == Better::lower ? *change : 1 / *change) > limit_;
    for (const std::optional<double>& number : {then, now, change})
      out_ << std::setw(kNumber) << in_words(number);
    out_ << std::left << std::setw(kMark) << (is_worse ? " worse" : "") << std::right;
    result_.ratios += change.has_value();
    result_.worse += is_worse;
  }

  const Baseline& baseline_;
  double limit_;
  std::ostream& out_;
  BenchComparison result_;
};

}  // namespace

BenchComparison print_comparison(const Baseline& then, std::span<const SceneFigures> now,
                                 std::uint32_t margin_percent, std::ostream& out) {
  Comparer comparer(then, margin_percent, out);
  print_comparison_head(then.path, then.machine, out);
  for (const SceneFigures& scene : now) comparer.compare(scene);
  print_comparison_result(comparer.result(), margin_percent, out);
  return comparer.result();
}

void print_comparison_head(const std::string& path, const Machine& machine, std::ostream& out) {
  out << "against " << asset::printable(path) << ": " << asset::printable(in_words(machine))
      << '\n';
}

void print_comparison_result(const BenchComparison& result, std::uint32_t margin_percent,
                             std::ostream& out) {
  out << '\n'
      << result.worse << " of " << output::counted(result.ratios, "ratio") << " worse by more than "
      << margin_percent << " %\n";
}

}  // namespace pelt::tools::bench

#include "tools/pelt/bench/moving_against.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/bench/moving_ratios.hpp"
#include "tools/pelt/methods/moving_methods.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <iomanip>
#include <set>

namespace pelt::tools::bench {
namespace {

constexpr int kQueryWidth = 9, kMethodWidth = 12, kRatioWidth = 10, kMarkWidth = 7;

/// Compares scenes with those of a baseline, and prints the result.
class MovingComparer {
 public:
  MovingComparer(const MovingBaseline& baseline, std::uint32_t margin_percent, std::ostream& out)
      : baseline_(baseline), limit_(1 + margin_percent / 100.0), out_(out) {}

  void compare(const MovingSceneFigures& now) {
    const auto& scenes = baseline_.scenes;
    const auto then = std::find_if(scenes.begin(), scenes.end(), [&](const MovingSceneFigures& s) {
      return s.scene == now.scene;
    });
    out_ << '\n' << asset::printable(now.scene) << ": ";
    if (then == scenes.end())
      out_ << asset::printable(baseline_.path) << " does not contain this scene\n";
    else if (then->steps != now.steps)
      out_ << output::counted(now.steps, "step") << ", not the " << output::with_commas(then->steps)
           << " of " << asset::printable(baseline_.path) << ": not compared\n";
    else
      compare(*then, now);
  }

  const BenchComparison& result() const { return result_; }

 private:
  void compare(const MovingSceneFigures& then, const MovingSceneFigures& now) {
    out_ << output::counted(now.steps, "step") << '\n';
    const std::set<MovingQuestion> different = print_different_answers(then, now);
    print_head();
    for (const MovingFigures& figures : now.figures)
      if (different.count(figures.question) == 0) print_row(then, now, figures);
  }

  /// Figures for different answers cannot be compared.
  std::set<MovingQuestion> print_different_answers(const MovingSceneFigures& then,
                                                   const MovingSceneFigures& now) {
    std::set<MovingQuestion> different;
    for (const MovingFigures& figures : now.figures)
      for (const MovingFigures& before : then.figures) {
        const bool is_same =
            before.question != figures.question || before.answer.hash == figures.answer.hash;
        if (is_same || !different.insert(figures.question).second) continue;
        out_ << "query " << name_of(figures.question) << ": different answers: hash "
             << output::hex16(before.answer.hash) << " then, " << output::hex16(figures.answer.hash)
             << " now: not compared\n";
        ++result_.different_answers;
      }
    return different;
  }

  void print_head() {
    out_ << std::string(kQueryWidth + kMethodWidth, ' ');
    for (const char* title : {"of collide", "of on_demand"})
      out_ << std::setw(3 * kRatioWidth) << title << std::string(kMarkWidth, ' ');
    out_ << '\n';
    print_names("query", "method");
    for (int i = 0; i < 2; ++i)
      out_ << std::setw(kRatioWidth) << "then" << std::setw(kRatioWidth) << "now"
           << std::setw(kRatioWidth) << "now/then" << std::string(kMarkWidth, ' ');
    out_ << '\n';
  }

  void print_names(const std::string& query, const std::string& method) {
    out_ << std::left << std::setw(kQueryWidth) << query << std::setw(kMethodWidth) << method
         << std::right;
  }

  /// The cost of on_demand over itself says nothing.
  void print_row(const MovingSceneFigures& then, const MovingSceneFigures& now,
                 const MovingFigures& figures) {
    const MovingFigures* before = find_figures(then, figures.method, figures.question);
    const bool is_itself = figures.method == methods::kMovingOnDemand.name;
    const bool is_collide = figures.question == MovingQuestion::collide;
    print_names(name_of(figures.question), figures.method);
    print_ratio(before && !(is_itself && is_collide) ? of_collide(then, *before) : std::nullopt,
                is_itself && is_collide ? std::nullopt : of_collide(now, figures));
    print_ratio(before && !is_itself ? of_on_demand(then, *before) : std::nullopt,
                is_itself ? std::nullopt : of_on_demand(now, figures));
    out_ << '\n';
  }

  void print_ratio(const std::optional<double>& then, const std::optional<double>& now) {
    const std::optional<double> change = ratio(now ? &*now : nullptr, then ? &*then : nullptr);
    const bool is_worse = change && *change > limit_;
    for (const std::optional<double>& number : {then, now, change})
      out_ << std::setw(kRatioWidth) << in_words(number);
    out_ << std::left << std::setw(kMarkWidth) << (is_worse ? " worse" : "") << std::right;
    result_.ratios += change.has_value();
    result_.worse += is_worse;
  }

  const MovingBaseline& baseline_;
  double limit_;
  std::ostream& out_;
  BenchComparison result_;
};

}  // namespace

BenchComparison print_moving_comparison(const MovingBaseline& then,
                                        std::span<const MovingSceneFigures> now,
                                        std::uint32_t margin_percent, std::ostream& out) {
  MovingComparer comparer(then, margin_percent, out);
  print_comparison_head(then.path, then.machine, out);
  for (const MovingSceneFigures& scene : now) comparer.compare(scene);
  print_comparison_result(comparer.result(), margin_percent, out);
  return comparer.result();
}

}  // namespace pelt::tools::bench

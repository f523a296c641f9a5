/// The conclusions from the tables of the comparison, in words. No number is written here: each is
/// a figure of a table, or a ratio of two figures.

#include "base/assert.hpp"
#include "evaluation/reproduce/comparison.hpp"
#include "evaluation/reproduce/scene_figures.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;

const Table& table_of(const Section& section, const std::string& id) {
  const auto found = std::find_if(section.tables.begin(), section.tables.end(),
                                  [&](const Table& table) { return table.id == id; });
  PELT_ASSERT(found != section.tables.end());
  return *found;
}

std::string us(double time) { return shown(time) + " us"; }

/// "0.8", with at most `decimals` decimals.
std::string brief(double figure, int decimals) {
  std::ostringstream text;
  const double unit = std::pow(10, decimals);
  text << std::round(figure * unit) / unit;
  return text.str();
}

/// "2.3 times".
std::string times(double ratio) { return brief(ratio, ratio < 10 ? 1 : 0) + " times"; }

/// A size or distance: "0.8", "100,000".
std::string size(double figure) { return figure < 100 ? brief(figure, 2) : shown(figure); }

/// "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

/// A table with sizes or distances as rows and times of methods as columns.
class Sweep {
 public:
  /// `unit` precedes a row's figure: "a distance of".
  Sweep(const Table& table, std::string unit) : table_(table), unit_(std::move(unit)) {}

  std::size_t row_count() const { return table_.rows.size(); }
  const std::string& title() const { return table_.title; }

  std::size_t row_at(double x) const {
    for (std::size_t row = 0; row < row_count(); ++row)
      if (table_.rows[row][0].figure == x) return row;
    return row_count() - 1;
  }

  std::string place(std::size_t row) const {
    return unit_ + " " + size(*table_.rows[row][0].figure);
  }

  std::optional<double> time(std::size_t row, MethodKind method) const {
    return table_.rows[row][column_of(table_, time_key(method))].figure;
  }

  /// "hash 574 us".
  std::string told(std::size_t row, MethodKind method) const {
    const auto taken = time(row, method);
    return title_of(method) + " " + (taken ? us(*taken) : "was not measured");
  }

  /// "hash 574 us, Pelt 0.5 us and ...".
  std::string told(std::size_t row, std::span<const MethodKind> methods) const {
    std::vector<std::string> parts;
    for (const MethodKind method : methods) parts.push_back(told(row, method));
    return listed(parts);
  }

  /// The factor by which `slow` takes longer than `fast`; nullopt if one of them was not measured.
  std::optional<double> ratio(std::size_t row, MethodKind slow, MethodKind fast) const {
    const auto s = time(row, slow), f = time(row, fast);
    return s && f ? std::optional(*s / *f) : std::nullopt;
  }

  /// States which of two methods is faster, and in which rows.
  std::string duel(MethodKind a, MethodKind b) const {
    std::vector<std::size_t> lost;
    double most_won = 0, most_lost = 0;
    for (std::size_t row = 0; row < row_count(); ++row) {
      const std::optional<double> lead = ratio(row, b, a);
      if (!lead) continue;
      if (*lead < 1) lost.push_back(row);
      most_won = std::max(most_won, *lead);
      most_lost = std::max(most_lost, 1 / *lead);
    }
    if (lost.empty()) return beats(a, b) + " everywhere, by up to " + times(most_won);
    if (most_won < 1) return beats(b, a) + " everywhere, by up to " + times(most_lost);
    return beats(b, a) + " at " + unit_ + " " + span_of(lost) + ", by up to " + times(most_lost) +
           ", and slower elsewhere, by up to " + times(most_won);
  }

  /// The rows in which a method is not the fastest, as text: "at ... Pelt eager by 1.03 times".
  std::vector<std::string> losses(MethodKind method, std::span<const MethodKind> rivals) const {
    std::vector<std::string> lost;
    for (std::size_t row = 0; row < row_count(); ++row) {
      const MethodKind best = fastest(row, rivals);
      if (const auto behind = ratio(row, method, best); behind && *behind > 1)
        lost.push_back(place(row) + " " + title_of(best) + " by " + brief(100 * (*behind - 1), 1) +
                       " %");
    }
    return lost;
  }

 private:
  static std::string beats(MethodKind a, MethodKind b) {
    return title_of(a) + " is faster than " + title_of(b);
  }

  /// "0.8 to 0" for rows without a gap, otherwise a list.
  std::string span_of(std::span<const std::size_t> rows) const {
    const auto x = [&](std::size_t row) { return size(*table_.rows[row][0].figure); };
    if (rows.size() > 2 && rows.back() - rows.front() + 1 == rows.size())
      return x(rows.front()) + " to " + x(rows.back());
    std::vector<std::string> parts;
    for (const std::size_t row : rows) parts.push_back(x(row));
    return listed(parts);
  }

  MethodKind fastest(std::size_t row, std::span<const MethodKind> methods) const {
    return *std::min_element(methods.begin(), methods.end(), [&](MethodKind a, MethodKind b) {
      return time(row, a).value_or(HUGE_VAL) < time(row, b).value_or(HUGE_VAL);
    });
  }

  const Table& table_;
  std::string unit_;
};

/// The tables that all paragraphs use.
struct Evidence {
  explicit Evidence(const Section& section)
      : all(table_of(section, "separation"), "a distance of"),
        first(table_of(section, "separation_first"), "a distance of"),
        resolution(table_of(section, "resolution"), "triangles of"),
        instances(table_of(section, "instances")),
        images(table_of(section, "image_space")),
        image_rivals(table_of(section, "image_space_rivals")) {}

  Sweep all, first, resolution;
  const Table &instances, &images, &image_rivals;
};

std::string trees_on_demand(const Evidence& of) {
  constexpr std::array kFamily = {methods::kOnDemand, methods::kPaper, lab::kBdTree,
                                  methods::kEager};
  const Sweep& all = of.all;
  const std::size_t apart = all.row_at(kApart), touching = all.row_at(kTouching),
                    deep = all.row_at(kDeep), last = all.row_count() - 1;
  return "Trees on demand cost only where bodies are near each other. Apart (" + all.place(apart) +
         "): " + all.told(apart, kFamily) + ". Hands that touch (" + size(kTouching) +
         "): " + all.told(touching, kFamily) + ". Deep (" + size(kDeep) +
         "): " + all.told(deep, kFamily) + ". At the same position: " + all.told(last, kFamily) +
         ". All contacts: " + all.duel(methods::kOnDemand, methods::kEager) + "; " +
         all.duel(methods::kPaper, lab::kBdTree) +
         ". First contact: " + of.first.duel(methods::kOnDemand, methods::kEager) + ".";
}

std::string eager_trees(const Evidence& of) {
  constexpr std::array kFamily = {methods::kEager, lab::kHybrid, lab::kAabbRefit, lab::kPaperEager,
                                  lab::kAabbRebuild};
  const Sweep& all = of.all;
  return "Eager trees pay for skinning and boxes even if nothing is near: " +
         all.told(all.row_at(kApart), kFamily) + " if the two are apart, " +
         all.told(all.row_at(kDeep), kFamily) +
         " in deep contact. All contacts: " + all.duel(methods::kPaper, lab::kAabbRefit) + "; " +
         all.duel(lab::kHybrid, lab::kAabbRefit) + "; " +
         all.duel(methods::kEager, lab::kAabbRefit) +
         ". Over the triangles: " + of.resolution.duel(methods::kOnDemand, methods::kEager) + "; " +
         of.resolution.duel(methods::kOnDemand, lab::kAabbRefit) + ".";
}

std::string hashing(const Evidence& of) {
  constexpr std::array kFamily = {lab::kHash, lab::kHashOverlap};
  const Sweep& all = of.all;
  return "Hashing: if the two are apart, " + all.told(all.row_at(kApart), kFamily) +
         ", in deep contact " + all.told(all.row_at(kDeep), kFamily) +
         ". All contacts: " + all.duel(methods::kOnDemand, lab::kHashOverlap) + "; " +
         all.duel(methods::kPaper, lab::kHashOverlap) + "; " +
         all.duel(methods::kPaper, lab::kHash) + "; " +
         all.duel(lab::kAabbRefit, lab::kHashOverlap) + "; " +
         all.duel(lab::kHashOverlap, lab::kHash) +
         ". First contact: " + of.first.duel(lab::kHashOverlap, lab::kHash) + ".";
}

/// Plain hashing is meant for many bodies in one grid.
std::string crowds(const Evidence& of) {
  const Table& table = of.instances;
  const std::size_t last = table.rows.size() - 1;
  const auto time = [&](const std::string& key) { return figure_at(table, last, key); };
  const double crowd = time("crowd_us"), grid = time("hash_crowd_us");
  return "Crowds: " + shown(figure_at(table, last, "instances")) + " walkers take " + us(crowd) +
         " per frame with Pelt as a crowd on one thread; hashing all in one grid takes " +
         us(grid) + " (" + times(grid / crowd) + " as long). Pair by pair, Pelt takes " +
         us(time(time_key(methods::kOnDemand))) + ", " + title_of(methods::kEager) + " " +
         us(time(time_key(methods::kEager))) + ", " + title_of(lab::kHash) + " " +
         us(time(time_key(lab::kHash))) + ", " + title_of(lab::kHashOverlap) + " " +
         us(time(time_key(lab::kHashOverlap))) + ".";
}

/// The row of the least resolution that misses nothing; otherwise of the greatest resolution.
std::size_t sufficient_row(const Table& images) {
  std::size_t row = 0;
  while (row + 1 < images.rows.size() && figure_at(images, row, "missed") > 0) ++row;
  return row;
}

std::string image_space(const Evidence& of) {
  const Table &images = of.images, &rivals = of.image_rivals;
  const std::size_t enough = sufficient_row(images);
  const double taken = figure_at(images, enough, "all_us");
  const double pelt = figure_at(rivals, 0, "all_us");
  std::vector<std::string> others;
  for (std::size_t row = 0; row < rivals.rows.size(); ++row)
    others.push_back(rivals.rows[row][0].name + " " + us(figure_at(rivals, row, "all_us")));
  return "Image space methods only answer yes or no. At " +
         shown(figure_at(images, 0, "resolution")) + " pixels per side they miss " +
         brief(figure_at(images, 0, "missed_percent"), 1) + " % of the cases in contact, at " +
         shown(figure_at(images, enough, "resolution")) + " " +
         brief(figure_at(images, enough, "missed_percent"), 1) + " %, where they take " +
         us(taken) + " with skinning, " + times(taken / pelt) +
         " as long as Pelt, whose answer is exact. The exact methods take: " + listed(others) + ".";
}

std::string where_pelt_loses(const Evidence& of) {
  std::string text;
  std::size_t rows = 0, lost = 0;
  for (const Sweep* sweep : {&of.all, &of.first, &of.resolution}) {
    const std::vector<std::string> losses = sweep->losses(methods::kOnDemand, kCompared);
    rows += sweep->row_count();
    lost += losses.size();
    if (!losses.empty()) text += " " + sweep->title() + ": at " + listed(losses) + ".";
  }
  return "Pelt is the fastest in " + std::to_string(rows - lost) + " of " + std::to_string(rows) +
         " rows of the tables of distance and of triangles." +
         (lost > 0
              ? " It is slower if nearly everything is needed, so that refitting everything wastes "
                "no work." +
                    text
              : "");
}

}  // namespace

std::vector<std::string> answers_of(const Section& section) {
  const Evidence of(section);
  return {trees_on_demand(of), eager_trees(of), hashing(of),
          crowds(of),          image_space(of), where_pelt_loses(of)};
}

}  // namespace pelt::reproduce

#include "evaluation/reproduce/summary.hpp"

#include "evaluation/reproduce/method_title.hpp"

#include <array>
#include <cstdint>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;

constexpr std::array kMethods = {methods::kOnDemand, methods::kEager,   lab::kRigid,
                                 methods::kPaper,    lab::kPaperEager,  lab::kPaperRigid,
                                 lab::kHybrid,       lab::kAabbRefit,   lab::kAabbRebuild,
                                 lab::kHash,         lab::kHashOverlap, lab::kBdTree};

Table method_table() {
  Table table = {
      "methods",
      "The methods, by their names in this report",
      {{"method", "method"}, {"what", "what it does"}},
      {},
      "All methods use the same exact test of triangles and give the same contacts. \"Rigid\" "
      "is a baseline rather than a method: building its trees is not timed."};
  for (const MethodKind method : kMethods)
    table.rows.push_back({title_of(method), description_of(method)});
  return table;
}

constexpr std::size_t kLastRow = SIZE_MAX;

/// A cell of one of the report's tables.
struct Place {
  const char* table;
  std::size_t row;
  const char* key;
};

/// The speed-up of refitting on demand over refitting bottom-up: in the paper, for the paper's
/// method here, and for Pelt over Pelt eager.
struct Claim {
  const char* what;
  Place printed, here, pelt;
};

/// A claim about a scene, from a row of its comparisons.
constexpr Claim scene_claim(const char* what, const char* table, std::size_t row) {
  return {
      what, {table, row, "paper_speed_up"}, {table, row, "speed_up"}, {table, row + 3, "speed_up"}};
}

constexpr Claim dwarves_claim(const char* what, const char* table) {
  return {what,
          {table, kLastRow, "printed_speed_up"},
          {table, kLastRow, "paper_speed_up"},
          {table, kLastRow, "speed_up"}};
}

constexpr Claim kClaims[] = {
    scene_claim("two men who walk towards each other", "two_men_ratios", 0),
    scene_claim("two creatures through each other", "worst_case_ratios", 0),
    scene_claim("the same, first contact only", "worst_case_ratios", 5),
    scene_claim("a crowd of fifty", "crowd_ratios", 0),
    dwarves_claim("dwarves apart, after the last subdivision", "dwarves_apart"),
    dwarves_claim("intersecting dwarves, after the last subdivision", "dwarves_interfering")};

const Table* find_table(std::span<const Section> sections, std::string_view id) {
  for (const Section& section : sections)
    for (const Table& table : section.tables)
      if (table.id == id) return &table;
  return nullptr;
}

Cell cell_at(const Table& table, const Place& place) {
  const std::size_t row = place.row == kLastRow ? table.rows.size() - 1 : place.row;
  return table.rows[row][column_of(table, place.key)];
}

Table claim_table(std::span<const Section> sections) {
  Table table = {"claims",
                 "Speed-up of refitting on demand over refitting everything",
                 {{"what", "scene"},
                  {"printed", "in the paper"},
                  {"here", "paper on demand against paper bottom-up, here"},
                  {"pelt", "Pelt against Pelt eager"}},
                 {},
                 "The sections below have the details of all these figures."};
  for (const Claim& claim : kClaims)
    if (const Table* const source = find_table(sections, claim.here.table))
      table.rows.push_back({claim.what, cell_at(*source, claim.printed),
                            cell_at(*source, claim.here), cell_at(*source, claim.pelt)});
  return table;
}

}  // namespace

Section summary(std::span<const Section> sections) {
  Section section;
  section.id = "summary";
  section.title = "The paper's claims today";
  section.text = {
      "The paper compares refitting on demand with bottom-up refitting of the same tree of "
      "spheres. "
      "This report measures both as described there, and both again with Pelt's tree of boxes, as "
      "fast as we can make them. The second pair shows the gain of refitting on demand today."};
  if (Table claims = claim_table(sections); !claims.rows.empty())
    section.tables.push_back(std::move(claims));
  section.tables.push_back(method_table());
  return section;
}

}  // namespace pelt::reproduce

#include "tools/pelt/check/summary_lists.hpp"

#include "scenes/takes.hpp"
#include "tools/pelt/output/text.hpp"

#include <iomanip>

namespace pelt::tools::check {

void ListLength::print_rest(std::size_t count, std::ostream& out) const {
  if (count <= most_) return;
  out << std::right << std::setw(12) << "..."
      << " and " << output::with_commas(count - most_) << " more: --list " << count << '\n';
}

void print_rows(const RowList& list, const scenes::Scene& scene, const ListLength& length,
                std::ostream& out) {
  out << '\n' << list.title << '\n';
  const std::span<const TouchTally::Row> shown = length.shown(list.rows);
  const int width = width_of(shown), width_b = width_of(shown, &TouchTally::Row::b);
  const int clip_width = width_of(shown, &TouchTally::Row::clip);
  for (const TouchTally::Row& row : shown) {
    const double percent =
        100.0 * static_cast<double>(row.contacts) / static_cast<double>(list.contacts);
    out << std::right << std::setw(12) << output::with_commas(row.contacts) << std::setw(6)
        << output::fixed(percent, 1) << " %  " << std::left;
    if (clip_width > 0) out << std::setw(clip_width) << row.clip << "  ";
    out << std::setw(width) << row.a << "  " << std::setw(width_b) << row.b << "  in "
        << output::counted(row.frames, list.noun) << ", worst " << list.noun << ' '
        << scenes::frame_in_take(scene, row.worst_frame) << '\n';
  }
  length.print_rest(list.rows.size(), out);
}

}  // namespace pelt::tools::check

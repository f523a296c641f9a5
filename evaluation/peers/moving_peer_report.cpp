#include "evaluation/peers/moving_peer_figures.hpp"
#include "text/format.hpp"

#include <iomanip>

namespace pelt::tools {
namespace {

constexpr int kMethodWidth = 18, kFigureWidth = 12;

void print_moving_row(const MovingPeerFigures& figures, double pelt_us, std::ostream& out) {
  out << std::left << std::setw(kMethodWidth) << figures.method << std::right;
  for (const double time : {figures.skinning_us, figures.update_us, figures.query_us,
                            figures.step_us, figures.step_us / pelt_us})
    out << std::setw(kFigureWidth) << text::fixed(time, 1);
  const peers::MovingDifference& difference = figures.difference;
  for (const std::size_t count : {difference.missing_later, difference.missing_at_start,
                                  difference.extra, difference.early, difference.late})
    out << std::setw(kFigureWidth) << text::with_commas(count);
  out << '\n';
}

}  // namespace

void print_moving_peers(const MovingScenePeers& scene, std::ostream& out) {
  out << scene.scene << ": " << text::with_commas(scene.triangles) << " triangles, "
      << text::counted(scene.steps, "step") << " of which " << scene.steps_in_contact
      << " in contact, " << text::with_commas(scene.contacts) << " contacts in all, "
      << text::with_commas(scene.contacts_at_start) << " of them from the start of the step\n"
      << "microseconds a step on one thread, medians of " << scene.repetitions
      << ", means over the steps; less is better\n"
      << std::left << std::setw(kMethodWidth) << "method" << std::right;
  for (const char* head : {"skinning", "update", "query", "step", "of pelt's", "missing",
                           "at start", "extra", "early", "late"})
    out << std::setw(kFigureWidth) << head;
  out << '\n';
  for (const MovingPeerFigures& figures : scene.methods)
    print_moving_row(figures, scene.methods[0].step_us, out);
  out << '\n';
}

}  // namespace pelt::tools

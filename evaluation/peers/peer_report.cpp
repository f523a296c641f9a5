#include "evaluation/peers/peer_figures.hpp"
#include "text/format.hpp"

#include <iomanip>

namespace pelt::tools {
namespace {

constexpr int kName = 18, kWord = 13, kColumn = 12;

void print_head(std::ostream& out) {
  out << std::left << std::setw(kName) << "method" << std::setw(kWord) << "update"
      << std::setw(kWord) << "narrow phase" << std::right;
  for (const char* head :
       {"skinning", "update", "all", "first", "frame", "to first", "of pelt's", "missing", "extra"})
    out << std::setw(kColumn) << head;
  out << '\n';
}

void print_row(const ScenePeers& scene, const PeerFigures& figures, std::ostream& out) {
  out << std::left << std::setw(kName) << figures.method << std::setw(kWord) << figures.update
      << std::setw(kWord) << figures.narrow_phase << std::right;
  for (const double time : {figures.skinning_us, figures.update_us, figures.all_us,
                            figures.first_us, figures.frame_us, figures.first_frame_us})
    out << std::setw(kColumn) << text::fixed(time, 1);
  out << std::setw(kColumn) << text::fixed(cost_over_pelt(scene, figures), 1);
  for (const std::size_t count : {figures.difference.missing, figures.difference.extra})
    out << std::setw(kColumn) << text::with_commas(count);
  out << '\n';
}

}  // namespace

void print_peers(const ScenePeers& scene, std::ostream& out) {
  out << scene.scene << ": " << text::with_commas(scene.triangles) << " triangles, "
      << text::counted(scene.frames, "frame") << " of which " << scene.frames_in_contact
      << " in contact, " << text::with_commas(scene.contacts) << " contacts in all\n"
      << "microseconds a frame on one thread, medians of " << scene.repetitions
      << ", means over the frames; less is better"
      << (scene.contest == Contest::self ? "; \"of pelt's\" without the skinning of others\n"
                                         : "\n");
  print_head(out);
  for (const PeerFigures& figures : scene.methods) print_row(scene, figures, out);
  out << '\n';
}

void write_peers_csv(std::span<const ScenePeers> scenes, std::ostream& out) {
  out << "scene,triangles,frames,frames_in_contact,contacts,repetitions,method,version,update,"
         "narrow_phase,skinning_us,update_us,query_all_us,query_first_us,frame_all_us,"
         "frame_first_us,missing,extra,repeated\n";
  for (const ScenePeers& scene : scenes)
    for (const PeerFigures& figures : scene.methods)
      out << scene.scene << ',' << scene.triangles << ',' << scene.frames << ','
          << scene.frames_in_contact << ',' << scene.contacts << ',' << scene.repetitions << ','
          << figures.method << ',' << figures.version << ",\"" << figures.update << "\","
          << figures.narrow_phase << ',' << figures.skinning_us << ',' << figures.update_us << ','
          << figures.all_us << ',' << figures.first_us << ',' << figures.frame_us << ','
          << figures.first_frame_us << ',' << figures.difference.missing << ','
          << figures.difference.extra << ',' << figures.difference.repeated << '\n';
}

}  // namespace pelt::tools

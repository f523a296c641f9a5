#include "evaluation/rivals/bd_tree.hpp"

namespace pelt::rivals {

QueryStats collide(BdBody& a, const Palette& palette_a, BdBody& b, const Palette& palette_b,
                   paper::Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts) {
  const std::uint64_t refits = a.refits() + b.refits();
  const std::uint64_t posed_vertices = a.posed_vertices() + b.posed_vertices();
  BdBody::Side side_a(a, palette_a), side_b(b, palette_b);
  QueryStats work = paper::descend(side_a, side_b, scratch, contacts, max_contacts);
  work.refits = a.refits() + b.refits() - refits;
  work.posed_vertices = a.posed_vertices() + b.posed_vertices() - posed_vertices;
  return work;
}

}  // namespace pelt::rivals

#include <pelt/self.hpp>
#include <pelt/solid.hpp>

// The first time, 0 to 1, at which a sword touches an arm on the way to the next frame; 2 if never.
float first_touch(pelt::Motion sword, pelt::Motion arm, pelt::Scratch& scratch) {
  std::optional<pelt::MovingContact> first;
  pelt::first_contact(sword, arm, scratch, first);
  return first ? first->time : 2;
}

// The triangles of both that touch on the way, but do not touch yet in the first frame.
std::vector<pelt::MovingContact> new_touches(pelt::Motion sword, pelt::Motion arm,
                                             pelt::Scratch& scratch) {
  std::vector<pelt::MovingContact> contacts;
  pelt::collide(sword, arm, scratch, contacts, {.leave_out_start = true});
  return contacts;
}

// The triangles of one character that do not intersect each other yet in the first frame.
std::vector<pelt::MovingContact> new_self_contacts(pelt::Motion motion,
                                                   const pelt::SelfFilter& filter,
                                                   pelt::Scratch& scratch) {
  std::vector<pelt::MovingContact> contacts;
  pelt::self_collide(motion, filter, scratch, contacts, {.leave_out_start = true});
  return contacts;
}

// The triangles of a character that get into a trigger volume on the way, and when.
std::vector<pelt::RegionEntry> entered(pelt::Motion motion, const pelt::Sphere& trigger,
                                       pelt::Scratch& scratch) {
  std::vector<pelt::RegionEntry> entries;
  pelt::collide(motion, trigger, scratch, entries, {.leave_out_start = true});
  return entries;
}

#include <pelt/self.hpp>

// For each frame, after `set_palette`.
void find_self_contacts(pelt::Pose& pose, pelt::SelfTracker& tracker, pelt::Scratch& scratch,
                        std::vector<pelt::Contact>& contacts) {
  contacts.clear();
  pelt::self_collide(pose, tracker, scratch, contacts);
}

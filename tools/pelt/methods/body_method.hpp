#pragma once

/// A method made of bodies: validates a palette for each body, sorts contacts, counts work.

#include "tools/pelt/methods/body_set.hpp"
#include "tools/pelt/methods/method.hpp"

#include <algorithm>

namespace pelt::methods {

/// Traits are those of BodySet, and have a type Scratch, the constant kUpdateCounts, and collide(a,
/// palette of a, b, palette of b, scratch, contacts, max_contacts), whose contacts may have any
/// order.
template <typename Traits>
class BodyMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override { bodies_.add(model); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_.set_morph_weights(body, weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return bodies_.set_palette(body, palette);
  }

  bool update_counts() const override { return Traits::kUpdateCounts; }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    const QueryStats work =
        Traits::collide(bodies_[a], bodies_.palette(a), bodies_[b], bodies_.palette(b), scratch_,
                        contacts, limits.max_contacts);
    std::sort(contacts.begin() + first, contacts.end());
    return work;
  }

  QueryStats update_work() const override { return bodies_.update_work(); }

 private:
  BodySet<Traits> bodies_;
  typename Traits::Scratch scratch_;
};

}  // namespace pelt::methods

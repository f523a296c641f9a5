#include "evaluation/methods/moving_methods.hpp"

#include <utility>

namespace pelt::lab {
namespace {

/// The library as its users call it.
class MovingOnDemand final : public MovingMethod {
 public:
  void add(const SkinnedModel& model) override {
    from_.emplace_back(model);
    to_.emplace_back(model);
  }

  void begin_step() override { std::swap(from_, to_); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return to_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return to_[body].set_palette(palette);
  }

  QueryStats collide_at_end(std::uint32_t a, std::uint32_t b,
                            std::vector<Contact>& contacts) override {
    return pelt::collide(to_[a], to_[b], scratch_, contacts);
  }

  MovingStats collide_moving(std::uint32_t a, std::uint32_t b, std::vector<MovingContact>& contacts,
                             const MovingOptions& options) override {
    return pelt::collide(motion(a), motion(b), scratch_, contacts, options);
  }

  MovingStats first_contact(std::uint32_t a, std::uint32_t b,
                            std::optional<MovingContact>& first) override {
    return pelt::first_contact(motion(a), motion(b), scratch_, first);
  }

  QueryStats update_work() const override { return {}; }

 private:
  Motion motion(std::uint32_t body) { return {from_[body], to_[body]}; }

  std::vector<Pose> from_, to_;
  Scratch scratch_;
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_on_demand() { return std::make_unique<MovingOnDemand>(); }

}  // namespace pelt::lab

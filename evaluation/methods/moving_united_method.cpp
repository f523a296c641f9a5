#include "evaluation/methods/moving_methods.hpp"
#include "evaluation/rivals/united_boxes.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

#include <utility>

namespace pelt::lab {
namespace {

/// Views of both poses of a step.
struct UnitedStep {
  UnitedStep(Pose& f, Pose& t) : from(f.detail().posed_tree()), to(t.detail().posed_tree()) {}

  detail::MovingTree tree() const { return {from, to}; }

  detail::PosedTree from, to;
};

class MovingUnited final : public MovingMethod {
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
    const UnitedStep step_a(from_[a], to_[a]), step_b(from_[b], to_[b]);
    const MovingStats work =
        rivals::active_collide_united()(step_a.tree(), step_b.tree(), scratch_.detail(), options);
    detail::append_sorted(scratch_.detail(), contacts);
    return work;
  }

  bool finds_first_contact() const override { return false; }

  MovingStats first_contact(std::uint32_t, std::uint32_t, std::optional<MovingContact>&) override {
    return {};
  }

  QueryStats update_work() const override { return {}; }

 private:
  std::vector<Pose> from_, to_;
  Scratch scratch_;
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_united() { return std::make_unique<MovingUnited>(); }

}  // namespace pelt::lab

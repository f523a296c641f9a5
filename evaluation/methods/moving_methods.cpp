#include "evaluation/methods/moving_methods.hpp"

#include "collide/eager.hpp"
#include "evaluation/rivals/stages.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

#include <utility>

namespace pelt::lab {

namespace {

/// The library as its users call it.
class MovingOnDemand : public MovingMethod {
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

 protected:
  Motion motion(std::uint32_t body) { return {from_[body], to_[body]}; }

  std::vector<Pose> from_, to_;
  Scratch scratch_;
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_on_demand() { return std::make_unique<MovingOnDemand>(); }

namespace {

class MovingEager final : public MovingMethod {
 public:
  void add(const SkinnedModel& model) override {
    bodies_.push_back(std::make_unique<Body>(model));
    for (detail::EagerPose* pose : {&bodies_.back()->from, &bodies_.back()->to})
      update_work_ += pose->open_all();
  }

  void begin_step() override {
    for (const auto& body : bodies_) body->is_swapped = !body->is_swapped;
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body]->end().set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    Result<void> taken = bodies_[body]->end().set_palette(palette);
    if (taken) update_work_ += bodies_[body]->end().open_all();
    return taken;
  }

  QueryStats collide_at_end(std::uint32_t a, std::uint32_t b,
                            std::vector<Contact>& contacts) override {
    return detail::collide(bodies_[a]->end(), bodies_[b]->end(), scratch_, contacts, {});
  }

  MovingStats collide_moving(std::uint32_t a, std::uint32_t b, std::vector<MovingContact>& contacts,
                             const MovingOptions& options) override {
    return detail::collide(bodies_[a]->motion(), bodies_[b]->motion(), scratch_, contacts, options);
  }

  MovingStats first_contact(std::uint32_t a, std::uint32_t b,
                            std::optional<MovingContact>& first) override {
    return detail::first_contact(bodies_[a]->motion(), bodies_[b]->motion(), scratch_, first);
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct Body {
    explicit Body(const SkinnedModel& m)
        : model(m), from(model.detail().tree), to(model.detail().tree) {}

    detail::EagerPose& end() { return is_swapped ? from : to; }
    detail::EagerMotion motion() {
      return is_swapped ? detail::EagerMotion{to, from} : detail::EagerMotion{from, to};
    }

    SkinnedModel model;
    detail::EagerPose from, to;
    bool is_swapped = false;  // `from` is the end
  };

  std::vector<std::unique_ptr<Body>> bodies_;
  detail::Scratch scratch_;
  QueryStats update_work_;
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_eager() { return std::make_unique<MovingEager>(); }

namespace {

/// Views of both poses of a step.
struct UnitedStep {
  UnitedStep(Pose& f, Pose& t) : from(f.detail().posed_tree()), to(t.detail().posed_tree()) {}

  detail::MovingTree tree() const { return {from, to}; }

  detail::PosedTree from, to;
};

class MovingUnited final : public MovingOnDemand {
 public:
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
};

}  // namespace

std::unique_ptr<MovingMethod> make_moving_united() { return std::make_unique<MovingUnited>(); }

}  // namespace pelt::lab

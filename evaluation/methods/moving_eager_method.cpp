#include "collide/eager.hpp"
#include "evaluation/methods/moving_methods.hpp"
#include "model/model.hpp"

#include <utility>

namespace pelt::lab {
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

}  // namespace pelt::lab

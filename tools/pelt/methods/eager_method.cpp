#include "collide/eager.hpp"
#include "model/model.hpp"
#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::methods {
namespace {

class EagerMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    bodies_.push_back(std::make_unique<Body>(model));
    update_work_ += bodies_.back()->pose.open_all();
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body]->pose.set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    Result<void> taken = bodies_[body]->pose.set_palette(palette);
    if (taken) update_work_ += bodies_[body]->pose.open_all();
    return taken;
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    return detail::collide(bodies_[a]->pose, bodies_[b]->pose, scratch_, contacts, limits);
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct Body {
    explicit Body(const SkinnedModel& m) : model(m), pose(model.detail().tree) {}

    SkinnedModel model;
    detail::EagerPose pose;
  };

  std::vector<std::unique_ptr<Body>> bodies_;
  detail::Scratch scratch_;
  QueryStats update_work_;
};

}  // namespace

std::unique_ptr<Method> make_eager() { return std::make_unique<EagerMethod>(); }

}  // namespace pelt::methods

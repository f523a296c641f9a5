#include <pelt/self.hpp>

#include "base/assert.hpp"
#include "model/model.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/self_methods.hpp"

#include <map>

namespace pelt::methods {
namespace {

class SelfMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    auto known = filters_.find(&model.detail());
    if (known == filters_.end()) {
      const Result<SelfFilter> filter = build_self_filter(model);
      PELT_ASSERT(filter);
      known = filters_.emplace(&model.detail(), *filter).first;
    }
    bodies_.push_back({Pose(model), known->second});
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body].pose.set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return bodies_[body].pose.set_palette(palette);
  }

  QueryStats collide(std::uint32_t a, [[maybe_unused]] std::uint32_t b,
                     std::vector<Contact>& contacts, const Limits& limits) override {
    PELT_ASSERT(a == b);
    return self_collide(bodies_[a].pose, bodies_[a].filter, scratch_, contacts, limits);
  }

  QueryStats update_work() const override { return {}; }

 private:
  struct Body {
    Pose pose;
    SelfFilter filter;
  };

  std::map<const detail::Model*, SelfFilter> filters_;
  std::vector<Body> bodies_;
  Scratch scratch_;
};

/// The update of the method eager.
class BoxesMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override { eager_->add(model); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return eager_->set_morph_weights(body, weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return eager_->set_palette(body, palette);
  }

  QueryStats collide(std::uint32_t, std::uint32_t, std::vector<Contact>&, const Limits&) override {
    return {};
  }

  QueryStats update_work() const override { return eager_->update_work(); }

 private:
  std::unique_ptr<Method> eager_ = make_eager();
};

}  // namespace

std::unique_ptr<Method> make_self() { return std::make_unique<SelfMethod>(); }

std::unique_ptr<Method> make_boxes() { return std::make_unique<BoxesMethod>(); }

}  // namespace pelt::methods

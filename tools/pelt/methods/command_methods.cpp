#include "tools/pelt/methods/command_methods.hpp"

#include <pelt/self.hpp>

#include "base/assert.hpp"
#include "collide/eager.hpp"
#include "model/model.hpp"
#include "tools/pelt/methods/paper_method.hpp"

#include <map>

namespace pelt::methods {
namespace {

/// The library as its users call it.
class OnDemandMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override { poses_.emplace_back(model); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return poses_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return poses_[body].set_palette(palette);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    return pelt::collide(poses_[a], poses_[b], scratch_, contacts, limits);
  }

  QueryStats update_work() const override { return {}; }

 private:
  std::vector<Pose> poses_;
  Scratch scratch_;
};

class EagerMethod : public Method {
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
class BoxesMethod final : public EagerMethod {
 public:
  QueryStats collide(std::uint32_t, std::uint32_t, std::vector<Contact>&, const Limits&) override {
    return {};
  }
};

}  // namespace

std::unique_ptr<Method> make_on_demand() { return std::make_unique<OnDemandMethod>(); }

std::unique_ptr<Method> make_eager() { return std::make_unique<EagerMethod>(); }

std::unique_ptr<Method> make_paper() {
  return std::make_unique<BodyMethod<PaperTraits<paper::BoundKind::optimised>>>();
}

std::unique_ptr<Method> make_self() { return std::make_unique<SelfMethod>(); }

std::unique_ptr<Method> make_boxes() { return std::make_unique<BoxesMethod>(); }

}  // namespace pelt::methods

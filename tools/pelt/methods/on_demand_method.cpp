#include "tools/pelt/methods/command_methods.hpp"

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

}  // namespace

std::unique_ptr<Method> make_on_demand() { return std::make_unique<OnDemandMethod>(); }

}  // namespace pelt::methods

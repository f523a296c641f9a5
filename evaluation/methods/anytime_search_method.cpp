#include <pelt/search.hpp>

#include "evaluation/methods/anytime_methods.hpp"

#include <optional>

namespace pelt::lab {
namespace {

/// The library as its users call it.
class AnytimeSearch final : public AnytimeMethod {
 public:
  explicit AnytimeSearch(SearchOrder order) : order_(order) {}

  void add(const SkinnedModel& model) override { poses_.emplace_back(model); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return poses_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return poses_[body].set_palette(palette);
  }

  void select(std::uint32_t a, std::uint32_t b) override {
    search_.emplace(poses_[a], poses_[b], order_);
  }

  void restart() override { search_->restart(); }

  /// More than one call if the search has stopped at the first contact.
  void advance_to(std::uint64_t work) override {
    while (!search_->is_complete() && search_->work_done() < work)
      search_->advance(work - search_->work_done(), scratch_);
  }

  bool is_complete() const override { return search_->is_complete(); }
  std::uint64_t work_done() const override { return search_->work_done(); }
  std::uint64_t longest_step() const override { return search_->longest_step(); }

  Known known() const override {
    return {search_->contacts().size(), search_->undecided_pairs(), search_->resolution()};
  }

  std::span<const Contact> contacts() const override { return search_->contacts(); }

 private:
  SearchOrder order_;
  std::vector<Pose> poses_;
  Scratch scratch_;
  std::optional<CollisionSearch> search_;
};

}  // namespace

std::unique_ptr<AnytimeMethod> make_anytime_contacts() {
  return std::make_unique<AnytimeSearch>(SearchOrder::contacts);
}

std::unique_ptr<AnytimeMethod> make_anytime_resolution() {
  return std::make_unique<AnytimeSearch>(SearchOrder::resolution);
}

std::unique_ptr<AnytimeMethod> make_anytime_first_contact() {
  return std::make_unique<AnytimeSearch>(SearchOrder::first_contact);
}

}  // namespace pelt::lab

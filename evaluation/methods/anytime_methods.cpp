#include "evaluation/methods/anytime_methods.hpp"

#include <pelt/search.hpp>

#include "tools/pelt/methods/paper_method.hpp"

#include <algorithm>
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

namespace {

using Traits = methods::PaperTraits<paper::BoundKind::optimised>;
using Side = paper::OnDemandBody::Side;

/// Longest side of the box around the region that two spheres share.
double longest_side(const detail::Float4& a, const detail::Float4& b) {
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::max(double{a[axis]} - a[3], double{b[axis]} - b[3]);
    const double high = std::min(double{a[axis]} + a[3], double{b[axis]} + b[3]);
    longest = std::max(longest, high - low);
  }
  return longest;
}

/// The breadth-first descent of two bodies under one palette each.
struct PaperSearch {
  PaperSearch(methods::BodyMethod<Traits>& bodies, std::uint32_t first, std::uint32_t second,
              paper::Scratch& scratch, std::vector<Contact>& contacts)
      : body_a(bodies.body(first)),
        body_b(bodies.body(second)),
        side_a(body_a, bodies.palette(first)),
        side_b(body_b, bodies.palette(second)),
        refits(body_a.refits() + body_b.refits()),
        posed_vertices(body_a.posed_vertices() + body_b.posed_vertices()),
        descent(side_a, side_b, scratch, contacts) {}

  std::uint64_t work_done() const {
    QueryStats work = descent.stats();
    work.refits = body_a.refits() + body_b.refits() - refits;
    work.posed_vertices = body_a.posed_vertices() + body_b.posed_vertices() - posed_vertices;
    return work_of(work);
  }

  paper::OnDemandBody &body_a, &body_b;
  Side side_a, side_b;
  std::uint64_t refits, posed_vertices;  ///< at the start
  paper::BreadthFirst<Side, Side> descent;
};

class AnytimePaper final : public AnytimeMethod {
 public:
  void add(const SkinnedModel& model) override { bodies_.add(model); }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_.set_morph_weights(body, weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return bodies_.set_palette(body, palette);
  }

  void select(std::uint32_t a, std::uint32_t b) override {
    a_ = a;
    b_ = b;
  }

  void restart() override {
    bodies_.body(a_).invalidate();
    bodies_.body(b_).invalidate();
    contacts_.clear();
    longest_step_ = 0;
    search_.emplace(bodies_, a_, b_, scratch_, contacts_);
    done_ = search_->work_done();
  }

  void advance_to(std::uint64_t work) override {
    while (!search_->descent.is_complete() && done_ < work) {
      search_->descent.step();
      const std::uint64_t done = search_->work_done();
      longest_step_ = std::max(longest_step_, done - done_);
      done_ = done;
    }
  }

  bool is_complete() const override { return search_->descent.is_complete(); }
  std::uint64_t work_done() const override { return done_; }
  std::uint64_t longest_step() const override { return longest_step_; }

  Known known() const override {
    Known known = {contacts_.size(), 0, 0};
    const paper::SphereTree &tree_a = search_->side_a.tree(), &tree_b = search_->side_b.tree();
    search_->descent.each_open([&](std::uint32_t a, std::uint32_t b) {
      known.undecided_pairs +=
          std::uint64_t{tree_a.nodes[a].triangle_count} * tree_b.nodes[b].triangle_count;
      known.resolution = std::max(
          known.resolution, longest_side(search_->side_a.sphere(a), search_->side_b.sphere(b)));
    });
    return known;
  }

  std::span<const Contact> contacts() const override { return contacts_; }

 private:
  methods::BodyMethod<Traits> bodies_;
  paper::Scratch scratch_;
  std::vector<Contact> contacts_;
  std::uint32_t a_ = 0, b_ = 0;
  std::optional<PaperSearch> search_;
  std::uint64_t done_ = 0, longest_step_ = 0;
};

}  // namespace

std::unique_ptr<AnytimeMethod> make_anytime_paper() { return std::make_unique<AnytimePaper>(); }

}  // namespace pelt::lab

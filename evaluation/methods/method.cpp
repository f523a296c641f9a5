#include "evaluation/methods/method.hpp"

#include "base/assert.hpp"
#include "evaluation/methods/brute_force.hpp"
#include "evaluation/methods/eager_method.hpp"
#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "evaluation/methods/rigid_method.hpp"
#include "evaluation/paper/eager.hpp"
#include "evaluation/paper/on_demand.hpp"
#include "evaluation/paper/rigid.hpp"
#include "evaluation/rivals/aabb.hpp"
#include "evaluation/rivals/bd_tree.hpp"
#include "evaluation/rivals/hash.hpp"
#include "evaluation/rivals/hash_overlap.hpp"
#include "evaluation/rivals/hybrid.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace pelt::bench {
namespace {

using detail::Palette;
using detail::SkinnedMesh;
using detail::unpack_mesh;

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
                     const CollideOptions& options) override {
    return pelt::collide(poses_[a], poses_[b], scratch_, contacts, options);
  }

  QueryStats update_work() const override { return {}; }

 private:
  std::vector<Pose> poses_;
  Scratch scratch_;
};

/// What the methods below share: a checked palette for each body, contacts sorted, work counted.
/// `Body` has update(palette) and collide(other, ...); `Prepared` is built once for each model.
template <typename Traits>
class BodyMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    auto& prepared = prepared_[&model.detail()];
    if (!prepared) prepared = std::make_unique<PreparedModel>(model);
    const SkinnedMesh& mesh = prepared->mesh;
    palettes_.emplace_back(mesh.joint_count, mesh.rest_extent, mesh.morph_extents);
    bodies_.push_back(Traits::make_body(mesh, prepared->prepared));
    update_work_ += Traits::update(*bodies_.back(), palettes_.back());
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    const bool any = std::any_of(weights.begin(), weights.end(), [](float w) { return w != 0; });
    if (any && !Traits::kMorphs)
      return Error{ErrorCode::unsupported,
                   "this method has no bounds for morph targets: choose another method"};
    return palettes_[body].set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    Result<void> taken = palettes_[body].set(palette);
    if (taken) update_work_ += Traits::update(*bodies_[body], palettes_[body]);
    return taken;
  }

  bool update_counts() const override { return Traits::kUpdateCounts; }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const CollideOptions& options) override {
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    const QueryStats work = Traits::collide(*bodies_[a], palettes_[a], *bodies_[b], palettes_[b],
                                            scratch_, contacts, options.max_contacts);
    std::sort(contacts.begin() + first, contacts.end());
    return work;
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct PreparedModel {
    explicit PreparedModel(const SkinnedModel& m)
        : model(m), mesh(unpack_mesh(m.detail().tree)), prepared(Traits::prepare(mesh)) {}

    SkinnedModel model;
    SkinnedMesh mesh;
    typename Traits::Prepared prepared;
  };

  std::map<const detail::Model*, std::unique_ptr<PreparedModel>> prepared_;
  std::vector<Palette> palettes_;
  std::vector<std::unique_ptr<typename Traits::Body>> bodies_;
  paper::Scratch scratch_;
  QueryStats update_work_;
};

/// Bodies that need their palette while they are asked.
template <typename Body_, typename Prepared_>
struct OnDemandTraits {
  using Prepared = Prepared_;
  using Body = Body_;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = false;

  static QueryStats update(Body& body, const Palette&) {
    body.invalidate();
    return {};
  }
  static QueryStats collide(Body& a, const Palette& palette_a, Body& b, const Palette& palette_b,
                            paper::Scratch& scratch, std::vector<Contact>& contacts,
                            std::uint32_t max_contacts) {
    using paper::collide;
    return collide(a, palette_a, b, palette_b, scratch, contacts, max_contacts);
  }
};

template <paper::BoundKind kBound>
struct PaperTraits : OnDemandTraits<paper::OnDemandBody, paper::SphereModel> {
  static Prepared prepare(const SkinnedMesh& mesh) {
    return paper::build_sphere_model(mesh, kBound);
  }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Prepared& model) {
    return std::make_unique<Body>(mesh, model);
  }
};

struct BdTraits : OnDemandTraits<rivals::BdBody, rivals::BdModel> {
  static Prepared prepare(const SkinnedMesh& mesh) { return Prepared(mesh); }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Prepared& model) {
    return std::make_unique<Body>(model, mesh.joint_count);
  }
};

/// Bodies that are all done once their palette has been taken.
template <typename Body_, typename Prepared_>
struct UpdatedTraits {
  using Prepared = Prepared_;
  using Body = Body_;
  static constexpr bool kUpdateCounts = true;
  static constexpr bool kMorphs = true;

  static QueryStats update(Body& body, const Palette& palette) { return body.update(palette); }
  static QueryStats collide(Body& a, const Palette&, Body& b, const Palette&,
                            paper::Scratch& scratch, std::vector<Contact>& contacts,
                            std::uint32_t max_contacts) {
    using paper::collide;
    return collide(a, b, scratch, contacts, max_contacts);
  }
};

struct PaperEagerTraits : UpdatedTraits<paper::EagerBody, paper::SphereTree> {
  static Prepared prepare(const SkinnedMesh& mesh) {
    return paper::build_sphere_tree(mesh.rest_positions, mesh.triangles);
  }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Prepared& tree) {
    return std::make_unique<Body>(mesh, tree);
  }
};

struct Nothing {};

template <typename Body>
struct UnpreparedTraits : UpdatedTraits<Body, Nothing> {
  static Nothing prepare(const SkinnedMesh&) { return {}; }
  static std::unique_ptr<Body> make_body(const SkinnedMesh& mesh, const Nothing&) {
    return std::make_unique<Body>(mesh);
  }
};

struct PaperRigidTraits : UnpreparedTraits<paper::RigidBody> {
  static constexpr bool kUpdateCounts = false;
};

constexpr std::array<std::string_view, 14> kNames = {
    "on_demand",  "eager",        "rigid",  "paper", "paper_eq2",    "paper_eager", "paper_rigid",
    "aabb_refit", "aabb_rebuild", "hybrid", "hash",  "hash_overlap", "bd_tree",     "brute"};

}  // namespace

std::span<const std::string_view> method_names() { return kNames; }

std::string_view name_of(MethodKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<MethodKind> find_method(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<MethodKind>(found - kNames.begin());
}

Skins skinning_of(MethodKind kind) {
  switch (kind) {
    case MethodKind::on_demand:
    case MethodKind::paper:
    case MethodKind::paper_eq2:
    case MethodKind::bd_tree:
      return Skins::where_queried;
    case MethodKind::eager:
      return Skins::with_boxes;
    default:
      return Skins::first;
  }
}

std::unique_ptr<Method> make_method(MethodKind kind) {
  switch (kind) {
    case MethodKind::on_demand:
      return std::make_unique<OnDemandMethod>();
    case MethodKind::eager:
      return make_eager_method();
    case MethodKind::rigid:
      return make_rigid_method();
    case MethodKind::paper:
      return std::make_unique<BodyMethod<PaperTraits<paper::BoundKind::optimised>>>();
    case MethodKind::paper_eq2:
      return std::make_unique<BodyMethod<PaperTraits<paper::BoundKind::plain>>>();
    case MethodKind::paper_eager:
      return std::make_unique<BodyMethod<PaperEagerTraits>>();
    case MethodKind::paper_rigid:
      return std::make_unique<BodyMethod<PaperRigidTraits>>();
    case MethodKind::aabb_refit:
      return adapt(rivals::make_aabb_refit());
    case MethodKind::aabb_rebuild:
      return adapt(rivals::make_aabb_rebuild());
    case MethodKind::hybrid:
      return adapt(rivals::make_hybrid());
    case MethodKind::hash:
      return adapt(rivals::make_hash());
    case MethodKind::hash_overlap:
      return adapt(rivals::make_hash_overlap());
    case MethodKind::bd_tree:
      return std::make_unique<BodyMethod<BdTraits>>();
    case MethodKind::brute:
      return std::make_unique<BodyMethod<UnpreparedTraits<BruteForceBody>>>();
  }
  PELT_ASSERT(false);
  return nullptr;
}

}  // namespace pelt::bench

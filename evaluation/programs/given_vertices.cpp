/// Measures contacts and rays of meshes whose vertices another program has computed: Pelt's
/// `set_vertices` and query beside Embree, Bullet and FCL, which refit their trees. All get the
/// same vertices in the same frames. Prints the means over all frames of the best time of each
/// frame, and says so if answers differ.

#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/embree_mesh.hpp"
#include "evaluation/programs/program.hpp"
#include "evaluation/programs/query_stage.hpp"

#include <pelt/collide.hpp>
#include <pelt/ray.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

namespace pelt::programs {
namespace {

struct Arguments {
  std::uint32_t frames = 20, rays = 64, runs = 5;
};

/// The vertices of both instances, and rays at the first.
struct GivenFrame {
  std::vector<Vec3> a, b;
  std::vector<Ray> rays;
};

std::vector<Vec3> vertices_of(Pose& pose, const JointPalette& palette) {
  std::vector<Vec3> vertices(pose.model().vertex_count());
  (void)pose.set_palette(palette);
  posed_vertices(pose, vertices);
  return vertices;
}

/// From a point through the middle of a triangle, and about as far again.
Ray through(const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto beyond = [](float start, float p, float q, float r) {
    return 2 * (p + q + r) / 3 - start;
  };
  return segment(from, {beyond(from.x, a.x, b.x, c.x), beyond(from.y, a.y, b.y, c.y),
                        beyond(from.z, a.z, b.z, c.z)});
}

std::vector<GivenFrame> given_frames(const QueryStage& stage, const SkinnedModel& model,
                                     std::span<const Triangle> triangles) {
  Pose pose(model);
  std::vector<GivenFrame> frames;
  for (const QueryFrame& frame : stage.frames()) {
    GivenFrame given = {vertices_of(pose, frame.a), vertices_of(pose, frame.touching), {}};
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      const auto [a, b, c] = triangles[i * 7919 % triangles.size()];
      given.rays.push_back(through(frame.points[i], given.a[a], given.a[b], given.a[c]));
    }
    frames.push_back(std::move(given));
  }
  return frames;
}

/// Times of refitting and of the query, and what the query found.
struct Sample {
  double refit = std::numeric_limits<double>::infinity();
  double query = std::numeric_limits<double>::infinity();
  std::vector<Contact> contacts;
  std::vector<float> hits;
};

class PeltBodies {
 public:
  explicit PeltBodies(const SkinnedModel& model) : a_(model), b_(model) {
    a_.reserve();
    b_.reserve();
  }

  void collide(const GivenFrame& frame, Sample& sample) {
    sample.contacts.clear();
    sample.refit = microseconds([&] {
      (void)a_.set_vertices(frame.a);
      (void)b_.set_vertices(frame.b);
    });
    sample.query = microseconds([&] { pelt::collide(a_, b_, scratch_, sample.contacts); });
  }

  void cast(const GivenFrame& frame, Sample& sample) {
    std::vector<RayHit> hits(frame.rays.size());
    sample.refit = microseconds([&] { (void)a_.set_vertices(frame.a); });
    sample.query = microseconds([&] { pelt::cast(a_, frame.rays, hits); });
    sample.hits.clear();
    for (const RayHit& hit : hits) sample.hits.push_back(hit.t);
  }

 private:
  Pose a_, b_;
  Scratch scratch_;
};

class PeerBodies {
 public:
  PeerBodies(std::unique_ptr<rivals::PosedMeshMethod> method, std::span<const Triangle> triangles,
             const GivenFrame& first)
      : method_(std::move(method)) {
    method_->add(triangles, first.a);
    method_->add(triangles, first.b);
  }

  void collide(const GivenFrame& frame, Sample& sample) {
    sample.contacts.clear();
    sample.refit = microseconds([&] {
      method_->update(0, frame.a);
      method_->update(1, frame.b);
    });
    sample.query = microseconds([&] {
      method_->collide(0, 1, sample.contacts, std::numeric_limits<std::uint32_t>::max());
    });
    std::sort(sample.contacts.begin(), sample.contacts.end());
  }

 private:
  std::unique_ptr<rivals::PosedMeshMethod> method_;
};

class EmbreeRays {
 public:
  EmbreeRays(std::span<const Triangle> triangles, std::size_t vertices)
      : mesh_(triangles, vertices) {}

  void cast(const GivenFrame& frame, Sample& sample) {
    std::vector<RayHit> hits(frame.rays.size());
    sample.refit = microseconds([&] {
      std::copy(frame.a.begin(), frame.a.end(), mesh_.positions().begin());
      mesh_.refit();
    });
    sample.query = microseconds([&] { mesh_.cast(frame.rays, hits, peers::RayCalls::one); });
    sample.hits.clear();
    for (const RayHit& hit : hits) sample.hits.push_back(hit.t);
  }

 private:
  peers::EmbreeMesh mesh_;
};

/// Answers every frame some times, and prints the means of the best times. Returns the answers.
template <typename Ask>
std::vector<Sample> measure(const char* name, const std::vector<GivenFrame>& frames,
                            std::uint32_t runs, const Ask& ask) {
  std::vector<Sample> best(frames.size());
  for (std::uint32_t run = 0; run < runs; ++run)
    for (std::size_t f = 0; f < frames.size(); ++f) {
      Sample sample;
      ask(frames[f], sample);
      if (sample.refit + sample.query < best[f].refit + best[f].query) best[f] = sample;
    }
  double refit = 0, query = 0;
  for (const Sample& sample : best) refit += sample.refit, query += sample.query;
  const auto count = static_cast<double>(frames.size());
  std::printf("  %-16s refit %8.1f us, query %8.1f us, together %8.1f us\n", name, refit / count,
              query / count, (refit + query) / count);
  return best;
}

bool have_equal_contacts(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  return std::ranges::equal(a, b, {}, &Sample::contacts, &Sample::contacts);
}

/// Rays through edges may hit either triangle, at times that differ by rounding.
bool have_similar_hits(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  const auto agree = [](float s, float t) {
    return s == t || std::fabs(s - t) < 1e-4f * std::fabs(s);
  };
  for (std::size_t f = 0; f < a.size(); ++f)
    if (!std::ranges::equal(a[f].hits, b[f].hits, agree)) return false;
  return true;
}

Result<void> measure_model(const Subject& subject, const Arguments& arguments) {
  const QueryStage stage(subject.character.asset, subject.model, arguments.frames, arguments.rays);
  const std::vector<Triangle>& triangles = subject.character.asset.triangles;
  const std::vector<GivenFrame> frames = given_frames(stage, subject.model, triangles);
  std::printf("%s: %zu triangles\n", subject.name.c_str(), triangles.size());

  PeltBodies pelt(subject.model);
  const auto expected = measure("contacts, Pelt", frames, arguments.runs,
                                [&](const GivenFrame& f, Sample& s) { pelt.collide(f, s); });
  const auto beside = [&](const char* name, std::unique_ptr<rivals::PosedMeshMethod> method) {
    PeerBodies bodies(std::move(method), triangles, frames[0]);
    const auto found = measure(name, frames, arguments.runs,
                               [&](const GivenFrame& f, Sample& s) { bodies.collide(f, s); });
    if (!have_equal_contacts(found, expected)) std::puts("  other contacts than Pelt");
  };
  beside("contacts, Embree", peers::make_embree());
  beside("contacts, Bullet", peers::make_bullet());
  beside("contacts, FCL", peers::make_fcl());

  const auto hits = measure("rays, Pelt", frames, arguments.runs,
                            [&](const GivenFrame& f, Sample& s) { pelt.cast(f, s); });
  EmbreeRays embree(triangles, subject.model.vertex_count());
  const auto embree_hits = measure("rays, Embree", frames, arguments.runs,
                                   [&](const GivenFrame& f, Sample& s) { embree.cast(f, s); });
  if (!have_similar_hits(embree_hits, hits)) std::puts("  other hits than Pelt");
  return {};
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) {
  using namespace pelt::programs;
  Arguments arguments;
  return measure_characters(
      {"given_vertices", "Measure queries of given vertices beside other libraries"}, argc, argv,
      {{"--frames", arguments.frames, "Frames along the first clip"},
       {"--rays", arguments.rays, "Rays of a frame"},
       {"--runs", arguments.runs, "Runs of which the best counts"}},
      [&](const Subject& subject) { return measure_model(subject, arguments); });
}

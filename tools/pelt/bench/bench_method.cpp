#include "tools/pelt/bench/bench_engine.hpp"

#include "asset/message.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/self_methods.hpp"

#include <algorithm>

namespace pelt::tools::bench {

Engine engine_of(methods::MethodKind method) {
  return {std::string(method.name), [method](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders, method.make());
          }};
}

Engine self_engine(methods::MethodKind method) {
  const auto make = [method](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::of_each(colliders, method.make());
  };
  return {std::string(method.name), make, method == methods::kBoxes ? Asked::none : Asked::self};
}

Engine crowd_engine(std::uint32_t threads) {
  const auto make = [threads](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::as_crowd(colliders, threads);
  };
  return {std::string(methods::kOnDemand.name), make, Asked::crowd, threads};
}

Time time_of(std::span<const Engine> engines) {
  const bool as_crowd = std::any_of(engines.begin(), engines.end(), [](const Engine& engine) {
    return engine.asked == Asked::crowd;
  });
  return as_crowd ? Time::wall : Time::thread;
}

void Runner::ask(Question question) {
  CollideOptions options;
  if (question == Question::first) options.max_contacts = 1;
  query_.collide(options, found_);
}

Error in_frame(std::uint32_t frame, const Error& error) {
  return asset::prefixed("frame " + std::to_string(frame), error);
}

}  // namespace pelt::tools::bench

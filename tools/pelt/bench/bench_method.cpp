#include "tools/pelt/bench/bench_method.hpp"

#include "asset/message.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/self_methods.hpp"

#include <algorithm>

namespace pelt::tools::bench {

BenchMethod method_of(methods::MethodKind method) {
  return {std::string(method.name), [method](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders, method.make());
          }};
}

BenchMethod self_method(methods::MethodKind method) {
  const auto make = [method](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::of_each(colliders, method.make());
  };
  return {std::string(method.name), make, method == methods::kBoxes ? Asked::none : Asked::self};
}

BenchMethod crowd_method(std::uint32_t threads) {
  const auto make = [threads](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::as_crowd(colliders, threads);
  };
  return {std::string(methods::kOnDemand.name), make, Asked::crowd, threads};
}

Time time_of(std::span<const BenchMethod> methods) {
  const bool as_crowd = std::any_of(methods.begin(), methods.end(), [](const BenchMethod& method) {
    return method.asked == Asked::crowd;
  });
  return as_crowd ? Time::wall : Time::thread;
}

void Runner::ask(Question question) {
  Limits limits;
  if (question == Question::first) limits.max_contacts = 1;
  query_.collide(limits, found_);
}

Error in_frame(std::uint32_t frame, const Error& error) {
  return asset::prefixed("frame " + std::to_string(frame), error);
}

}  // namespace pelt::tools::bench

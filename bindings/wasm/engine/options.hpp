#pragma once

/// What JavaScript hands over as an object: JSON that pelt.mjs writes once options.mjs has checked
/// it, so the keys that are there are known and have the right types.

#include "bindings/wasm/engine/handles.hpp"
#include "scenes/face.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::wasm {

class Options {
 public:
  /// Refuses text that is no Unicode, which JavaScript lets strings be.
  static Result<Options> read(std::string_view json);

  /// Empty where there is none.
  std::string text(const char* key) const;
  std::optional<std::vector<std::string>> texts(const char* key) const;

  asset::GltfOptions gltf() const;
  scenes::CreatureOptions creature() const;
  scenes::FaceOptions face() const;

  /// Without clips.
  Preparation preparation() const;

 private:
  explicit Options(nlohmann::json values) : values_(std::move(values)) {}

  bool flag(const char* key) const;
  std::uint32_t count(const char* key, std::uint32_t otherwise) const;

  nlohmann::json values_;
};

}  // namespace pelt::wasm

#pragma once

/// What JavaScript hands over as an object: JSON that memory.mjs has written, so keys that are
/// there have the right types.

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
  explicit Options(std::string_view json);

  /// Empty where there is none.
  std::string text(const char* key) const;
  std::optional<std::vector<std::string>> texts(const char* key) const;

  asset::GltfOptions gltf() const;
  scenes::CreatureOptions creature() const;
  scenes::FaceOptions face() const;

  /// Without clips.
  Preparation preparation() const;

 private:
  bool flag(const char* key) const;
  std::uint32_t count(const char* key, std::uint32_t otherwise) const;

  nlohmann::json values_;
};

}  // namespace pelt::wasm

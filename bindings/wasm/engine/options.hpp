#pragma once

/// Options that JavaScript passes as JSON. pelt.mjs writes the JSON after options.mjs has validated
/// it, so all keys are known and have the right types.

#include "bindings/wasm/engine/handles.hpp"
#include "scenes/creature.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::wasm {

class Options {
 public:
  /// Reads options. Returns an error for text that is not valid Unicode, which JavaScript allows.
  static Result<Options> read(std::string_view json);

  /// Returns the text, or an empty text if it is absent.
  std::string text(const char* key) const;
  std::optional<std::vector<std::string>> texts(const char* key) const;
  std::optional<float> number(const char* key) const;

  asset::GltfOptions gltf() const;
  scenes::CreatureOptions creature() const;
  scenes::FaceOptions face() const;

  /// The preparation without its clips and caps.
  Preparation preparation() const;

 private:
  explicit Options(nlohmann::json values) : values_(std::move(values)) {}

  bool flag(const char* key, bool otherwise = false) const;
  std::uint32_t count(const char* key, std::uint32_t otherwise) const;

  nlohmann::json values_;
};

}  // namespace pelt::wasm

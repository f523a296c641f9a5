/// Crowds, and the hash of what they find.

#include <pelt/crowd.hpp>

#include "base/hash.hpp"
#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

namespace pelt::wasm {
namespace {

struct CrowdHandle {
  Crowd crowd;
  std::vector<float> input;  ///< where JavaScript writes a palette or weights
  std::vector<CrowdContact> found;
};

}  // namespace

PELT_EXPORT std::uint32_t pelt_make_crowd() { return address_of(new CrowdHandle); }
PELT_EXPORT void pelt_delete_crowd(CrowdHandle* handle) { delete handle; }

PELT_EXPORT std::uint32_t pelt_add_to_crowd(CrowdHandle* handle, const CharacterHandle* character) {
  return handle->crowd.add(character->character->model);
}

PELT_EXPORT float* pelt_crowd_input(CrowdHandle* handle, std::uint32_t floats) {
  handle->input.resize(floats);
  return handle->input.data();
}

PELT_EXPORT std::uint32_t pelt_set_crowd_palette(CrowdHandle* handle, std::uint32_t instance) {
  return done(handle->crowd.set_palette(instance, handle->input));
}

PELT_EXPORT std::uint32_t pelt_set_crowd_weights(CrowdHandle* handle, std::uint32_t instance) {
  return done(handle->crowd.set_morph_weights(instance, handle->input));
}

PELT_EXPORT void pelt_collide_crowd(CrowdHandle* handle, std::uint32_t most) {
  handle->found.clear();
  CrowdOptions options;
  options.max_contacts = most;
  answer_stats(handle->crowd.collide(handle->found, options).work);
  answer_data<CrowdContact>(handle->found);
}

PELT_EXPORT std::uint32_t pelt_make_hash() { return address_of(new detail::Fnv1a64); }
PELT_EXPORT void pelt_delete_hash(detail::Fnv1a64* hash) { delete hash; }

PELT_EXPORT void pelt_add_to_hash(detail::Fnv1a64* hash, std::uint32_t value) {
  hash->add_u32(value);
}

PELT_EXPORT void pelt_hash_value(const detail::Fnv1a64* hash) {
  answer_numbers(
      {static_cast<double>(hash->value() >> 32), static_cast<double>(hash->value() & 0xFFFFFFFF)});
}

}  // namespace pelt::wasm

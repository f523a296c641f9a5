/// Crowds, and the hash of their contacts.

#include <pelt/crowd.hpp>

#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "base/hash.hpp"
#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "scenes/ignored_pairs.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::wasm {
namespace {

/// An instance of the crowd.
struct Member {
  std::uint32_t character = 0;  ///< index into the crowd's characters
  std::uint32_t first_triangle = 0;
  std::optional<SelfFilter> self_filter;  ///< whether and how it is tested against itself
};

struct CrowdHandle {
  Crowd crowd;
  std::vector<Member> members;
  std::vector<std::shared_ptr<Character>> characters;  ///< each once
  std::vector<scenes::NamePair> ignore;
  std::optional<scenes::IgnoredPairs> ignored;  ///< of these characters; created on first use
  std::vector<float> input;                     ///< where JavaScript writes a palette or weights
  std::vector<CrowdContact> found;

  std::uint32_t number_of(const std::shared_ptr<Character>& character) {
    const auto known = std::find(characters.begin(), characters.end(), character);
    if (known != characters.end()) return static_cast<std::uint32_t>(known - characters.begin());
    ignored.reset();
    characters.push_back(character);
    return static_cast<std::uint32_t>(characters.size() - 1);
  }
};

Result<void> know_ignored(CrowdHandle& handle) {
  if (handle.ignored) return {};
  std::vector<const scenes::Character*> characters;
  for (const auto& character : handle.characters) characters.push_back(&character->read);
  Result<scenes::IgnoredPairs> made = scenes::IgnoredPairs::make(characters, handle.ignore);
  if (!made) return made.error();
  handle.ignored = std::move(*made);
  return {};
}

/// Converts to the characters' triangle numbers.
void number_triangles(CrowdHandle& handle) {
  for (CrowdContact& contact : handle.found) {
    contact.triangle_a += handle.members[contact.instance_a].first_triangle;
    contact.triangle_b += handle.members[contact.instance_b].first_triangle;
  }
}

/// Removes ignored contacts, and returns their number.
std::size_t take_ignored_out(CrowdHandle& handle) {
  if (handle.ignored->is_empty()) return 0;
  return std::erase_if(handle.found, [&](const CrowdContact& contact) {
    return handle.ignored->is_ignored(
        handle.members[contact.instance_a].character, contact.triangle_a,
        handle.members[contact.instance_b].character, contact.triangle_b);
  });
}

void add(detail::Fnv1a64& hash, std::uint32_t frame, const CrowdContact& contact) {
  hash.add_u32(frame);
  hash.add_u32(contact.instance_a);
  hash.add_u32(contact.instance_b);
  hash.add_u32(contact.triangle_a);
  hash.add_u32(contact.triangle_b);
}

}  // namespace

PELT_EXPORT std::uint32_t pelt_make_crowd() { return address_of(new CrowdHandle); }
PELT_EXPORT void pelt_delete_crowd(CrowdHandle* handle) { delete handle; }

/// Adds a part or a whole character, and answers with its number.
PELT_EXPORT std::uint32_t pelt_add_to_crowd(CrowdHandle* handle, const CharacterHandle* character,
                                            std::uint32_t part) {
  const Result<Body*> body = character->character->body(part);
  if (!body) return refuse(body.error());
  answer().instance = handle->crowd.add((*body)->model);
  handle->members.push_back({handle->number_of(character->character), (*body)->first_triangle, {}});
  return 1;
}

/// Precondition: the filter is of the instance's body, or null for no test against itself.
PELT_EXPORT void pelt_set_crowd_self_filter(CrowdHandle* handle, std::uint32_t instance,
                                            const FilterHandle* filter) {
  handle->members[instance].self_filter =
      filter != nullptr ? std::optional(filter->filter) : std::nullopt;
}

/// `pairs` is the JSON of an array of pairs of names.
PELT_EXPORT std::uint32_t pelt_ignore_in_crowd(CrowdHandle* handle, const char* pairs) {
  const auto parsed = asset::parse_json(pairs);
  if (!parsed) return refuse(asset::prefixed("ignore", parsed.error()));
  handle->ignored.reset();
  handle->ignore.clear();
  for (const nlohmann::json& pair : **parsed)
    handle->ignore.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  return 1;
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

/// Answers with the stats, the numbers of ignored contacts and of those that filters have left out,
/// and all other contacts.
PELT_EXPORT std::uint32_t pelt_collide_crowd(CrowdHandle* handle, std::uint32_t most) {
  if (const auto known = know_ignored(*handle); !known) return refuse(known.error());
  handle->found.clear();
  CrowdOptions options;
  options.max_contacts = most;
  options.self_filter = [handle](std::uint32_t instance) {
    const std::optional<SelfFilter>& own = handle->members[instance].self_filter;
    return own ? &*own : nullptr;
  };
  const CrowdStats stats = handle->crowd.collide(handle->found, options);
  answer_stats(stats);
  answer_left_out(stats.left_out);
  number_triangles(*handle);
  answer().ignored = static_cast<double>(take_ignored_out(*handle));
  answer_data<CrowdContact>(handle->found);
  return 1;
}

PELT_EXPORT std::uint32_t pelt_make_hash() { return address_of(new detail::Fnv1a64); }
PELT_EXPORT void pelt_delete_hash(detail::Fnv1a64* hash) { delete hash; }

PELT_EXPORT void pelt_hash_pairs(detail::Fnv1a64* hash, std::uint32_t frame, std::uint32_t a,
                                 std::uint32_t b, const Contact* contacts, std::uint32_t count) {
  for (const Contact& contact : std::span(contacts, count))
    add(*hash, frame, {a, b, contact.triangle_a, contact.triangle_b});
}

PELT_EXPORT void pelt_hash_crowd(detail::Fnv1a64* hash, std::uint32_t frame,
                                 const CrowdContact* contacts, std::uint32_t count) {
  for (const CrowdContact& contact : std::span(contacts, count)) add(*hash, frame, contact);
}

PELT_EXPORT void pelt_hash_value(const detail::Fnv1a64* hash) {
  answer().hash_high = static_cast<double>(hash->value() >> 32);
  answer().hash_low = static_cast<double>(hash->value() & 0xFFFFFFFF);
}

}  // namespace pelt::wasm

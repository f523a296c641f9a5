/// Crowds, and the hash of their contacts.

#include <pelt/crowd.hpp>

#include "asset/parsed_json.hpp"
#include "base/hash.hpp"
#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/moving_columns.hpp"
#include "scenes/ignored_pairs.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace pelt::wasm {
namespace {

/// Owns the offsets that a crowd borrows for an instance: the offsets that were set last, and the
/// offsets at the start of the step. A move changes no address of an offset.
class KeptOffsets {
 public:
  /// Copies offsets in a step, and returns the copy. Keeps the copy before it if the start of the
  /// step may borrow it.
  std::span<const Vec3> keep(std::span<const Vec3> offsets, std::uint64_t step) {
    if (step != step_) std::swap(last_, start_);
    step_ = step;
    last_.assign(offsets.begin(), offsets.end());
    return last_;
  }

  /// Call when the start of the step has borrowed the offsets that were set last.
  void start_borrows() { step_ = std::numeric_limits<std::uint64_t>::max(); }

 private:
  std::vector<Vec3> last_, start_;
  std::uint64_t step_ = 0;  // in which `last_` was set
};

/// An instance of the crowd.
struct Member {
  std::uint32_t character = 0;  ///< index into the crowd's characters
  std::uint32_t first_triangle = 0;
  std::optional<SelfFilter> self_filter;     ///< whether and how it is tested against itself
  std::optional<std::uint32_t> part_filter;  ///< index into the crowd's part filters
  KeptOffsets offsets = {};
};
static_assert(
    std::is_nothrow_move_constructible_v<Member>,
    "a growing vector of members must move them, because the crowd borrows their offsets");

struct CrowdHandle {
  Crowd crowd;
  std::vector<Member> members;
  std::vector<std::shared_ptr<Character>> characters;  ///< each once
  std::vector<SelfFilter> part_filters;                ///< of whole characters
  std::vector<scenes::NamePair> ignore;
  std::optional<scenes::IgnoredPairs> ignored;  ///< of these characters; created on first use
  std::uint64_t step = 0;                       ///< number of steps begun
  std::vector<CrowdContact> found;
  std::vector<CrowdMovingContact> moving;
  MovingColumns columns;

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
void number_in_characters(const CrowdHandle& handle, CrowdContact& contact) {
  contact.triangle_a += handle.members[contact.instance_a].first_triangle;
  contact.triangle_b += handle.members[contact.instance_b].first_triangle;
}

/// Appends contacts with the characters' triangle numbers.
CrowdStats find_contacts(CrowdHandle& handle, const CrowdOptions& options) {
  const std::size_t begin = handle.found.size();
  const CrowdStats stats = handle.crowd.collide(handle.found, options);
  for (CrowdContact& contact : std::span(handle.found).subspan(begin))
    number_in_characters(handle, contact);
  return stats;
}

/// Removes the contacts of two parts that the filter of their character leaves out.
LeftOut filter_parts(CrowdHandle& handle) {
  LeftOut left_out;
  std::vector<CrowdContact> kept;
  std::vector<Contact> contacts;
  const auto& found = handle.found;
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    const auto [a, b] = std::pair(found[begin].instance_a, found[begin].instance_b);
    while (end < found.size() && found[end].instance_a == a && found[end].instance_b == b) ++end;
    contacts.clear();
    for (std::size_t i = begin; i < end; ++i)
      contacts.push_back({found[i].triangle_a, found[i].triangle_b});
    const Member &first = handle.members[a], &second = handle.members[b];
    if (a != b && first.part_filter && first.part_filter == second.part_filter) {
      left_out += leave_out(handle.part_filters[*first.part_filter], scratch(), contacts);
      if (first.first_triangle > second.first_triangle)
        for (Contact& contact : contacts) std::swap(contact.triangle_a, contact.triangle_b);
    }
    for (const auto& [triangle_a, triangle_b] : contacts)
      kept.push_back({a, b, triangle_a, triangle_b});
  }
  handle.found = std::move(kept);
  return left_out;
}

CrowdPair instances_of(const CrowdContact& contact) {
  return {contact.instance_a, contact.instance_b};
}

/// Keeps the first `most` contacts of each pair of instances. Returns whether it removed any.
bool limit_contacts(std::vector<CrowdContact>& contacts, std::uint32_t most) {
  CrowdPair pair;
  std::uint32_t count = 0;
  const auto is_beyond = [&](const CrowdContact& contact) {
    if (instances_of(contact) != pair) count = 0;
    pair = instances_of(contact);
    return count++ >= most;
  };
  return std::erase_if(contacts, is_beyond) > 0;
}

/// Finds all contacts.
CrowdStats collide_all(CrowdHandle& handle, const CrowdOptions& options) {
  CrowdStats stats = find_contacts(handle, options);
  if (!handle.part_filters.empty()) stats.left_out += filter_parts(handle);
  return stats;
}

/// Adds the contacts of instances with themselves to those of pairs.
void collide_selves(CrowdHandle& handle, CrowdOptions options, CrowdStats& stats) {
  const auto pairs = static_cast<std::ptrdiff_t>(handle.found.size());
  options.filter = [](std::uint32_t, std::uint32_t) { return false; };
  const CrowdStats own = find_contacts(handle, options);
  static_cast<QueryStats&>(stats) += own;
  stats.left_out += own.left_out;
  const auto by_instances = [](const CrowdContact& a, const CrowdContact& b) {
    return instances_of(a) < instances_of(b);
  };
  std::inplace_merge(handle.found.begin(), handle.found.begin() + pairs, handle.found.end(),
                     by_instances);
}

/// Finds contacts up to the limit. Filters of parts may drop any contacts of pairs, so that all are
/// needed. Which contacts of a pair a limited query finds first depends on the nodes that
/// self-tests have opened. For the answer of `pelt check`, pairs are therefore queried apart.
CrowdStats collide_limited(CrowdHandle& handle, const CrowdOptions& options) {
  CrowdOptions of_pairs = options;
  of_pairs.self_filter = nullptr;
  if (!handle.part_filters.empty()) of_pairs.max_contacts = CrowdOptions().max_contacts;
  CrowdStats stats = collide_all(handle, of_pairs);
  const bool is_cut = limit_contacts(handle.found, options.max_contacts);
  stats.cut_short = stats.cut_short || is_cut;
  const auto is_tested = [](const Member& member) { return member.self_filter.has_value(); };
  if (std::any_of(handle.members.begin(), handle.members.end(), is_tested))
    collide_selves(handle, options, stats);
  return stats;
}

/// Removes ignored contacts, and answers with their number.
void remove_ignored(CrowdHandle& handle) {
  std::size_t count = 0;
  if (!handle.ignored->is_empty())
    count = std::erase_if(handle.found, [&](const CrowdContact& contact) {
      return handle.ignored->is_ignored(
          handle.members[contact.instance_a].character, contact.triangle_a,
          handle.members[contact.instance_b].character, contact.triangle_b);
    });
  answer().ignored = static_cast<double>(count);
}

/// Tests instances against themselves with their filters.
CrowdOptions self_tests(const CrowdHandle& handle) {
  CrowdOptions options;
  options.self_filter = [&handle](std::uint32_t instance) {
    const std::optional<SelfFilter>& own = handle.members[instance].self_filter;
    return own ? &*own : nullptr;
  };
  return options;
}

/// Sets `found` to the triangles of `moving`.
void write_found(CrowdHandle& handle) {
  handle.found.clear();
  for (const auto& [instance_a, instance_b, moving] : handle.moving) {
    handle.found.push_back(
        {instance_a, instance_b, moving.contact.triangle_a, moving.contact.triangle_b});
    number_in_characters(handle, handle.found.back());
  }
}

/// Writes the times and features of the contacts in `found`, some of those in `moving`, in the same
/// order.
void write_moving_columns(CrowdHandle& handle) {
  auto moving = handle.moving.begin();
  for (const CrowdContact& kept : handle.found) {
    const auto is_kept = [&](const CrowdMovingContact& other) {
      const auto& [triangle_a, triangle_b] = other.moving.contact;
      CrowdContact contact = {other.instance_a, other.instance_b, triangle_a, triangle_b};
      number_in_characters(handle, contact);
      return contact == kept;
    };
    moving = std::find_if(moving, handle.moving.end(), is_kept);
    handle.columns.add((moving++)->moving);
  }
}

/// Finds moving contacts up to the limit. Filters of parts may drop any contacts of pairs, so that
/// all are needed.
CrowdStats collide_motions(CrowdHandle& handle, const MovingOptions& options) {
  MovingOptions asked = options;
  if (!handle.part_filters.empty()) asked.max_contacts = MovingOptions().max_contacts;
  handle.moving.clear();
  CrowdStats stats = handle.crowd.collide(handle.moving, self_tests(handle), asked);
  write_found(handle);
  if (handle.part_filters.empty()) return stats;
  stats.left_out += filter_parts(handle);
  const bool is_cut = limit_contacts(handle.found, options.max_contacts);
  stats.cut_short = stats.cut_short || is_cut;
  return stats;
}

void add(detail::Fnv1a64& hash, std::uint32_t frame, const CrowdContact& contact) {
  hash.add_u32(frame);
  hash.add_u32(contact.instance_a);
  hash.add_u32(contact.instance_b);
  hash.add_u32(contact.triangle_a);
  hash.add_u32(contact.triangle_b);
}

}  // namespace

CrowdHandle* make_crowd() { return new CrowdHandle; }
PELT_EXPORT(make_crowd)

void delete_crowd(CrowdHandle* handle) { delete handle; }
PELT_EXPORT(delete_crowd)

/// Adds a part or a whole character, and returns its number.
Result<std::uint32_t> add_to_crowd(CrowdHandle& handle, const CharacterHandle& character,
                                   std::uint32_t part) {
  const Result<Body*> body = character.character->body(part);
  if (!body) return body.error();
  handle.members.push_back(
      {handle.number_of(character.character), (*body)->first_triangle, {}, {}});
  return handle.crowd.add((*body)->model);
}
PELT_EXPORT(add_to_crowd)

/// Precondition: the filter is of the instance's body, or null for no test against itself.
void set_crowd_self_filter(CrowdHandle& handle, std::uint32_t instance,
                           const FilterHandle* filter) {
  handle.members[instance].self_filter =
      filter != nullptr ? std::optional(filter->filter) : std::nullopt;
}
PELT_EXPORT(set_crowd_self_filter)

/// Adds a filter of a whole character, for contacts of its parts, and returns its number.
std::size_t add_crowd_part_filter(CrowdHandle& handle, const FilterHandle& filter) {
  handle.part_filters.push_back(filter.filter);
  return handle.part_filters.size() - 1;
}
PELT_EXPORT(add_crowd_part_filter)

/// Precondition: the instance is a part of the filter's character.
void set_crowd_part_filter(CrowdHandle& handle, std::uint32_t instance, std::uint32_t filter) {
  handle.members[instance].part_filter = filter;
}
PELT_EXPORT(set_crowd_part_filter)

/// `pairs` is the JSON of an array of pairs of names.
Result<void> ignore_in_crowd(CrowdHandle& handle, std::string_view pairs) {
  const auto parsed = asset::parse_json(pairs);
  if (!parsed) return text::prefixed("ignore", parsed.error());
  handle.ignored.reset();
  handle.ignore.clear();
  for (const nlohmann::json& pair : **parsed)
    handle.ignore.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  return {};
}
PELT_EXPORT(ignore_in_crowd)

template <typename Number, auto kSet>
Result<void> set_instance(CrowdHandle& handle, std::uint32_t instance,
                          std::span<const Number> numbers) {
  return in_words_of_javascript((handle.crowd.*kSet)(instance, numbers));
}
PELT_EXPORT_AS(set_crowd_palette, (set_instance<float, &Crowd::set_palette>))
PELT_EXPORT_AS(set_crowd_dual_quaternions, (set_instance<float, &Crowd::set_dual_quaternions>))
PELT_EXPORT_AS(set_crowd_morph_weights, (set_instance<float, &Crowd::set_morph_weights>))
PELT_EXPORT_AS(set_crowd_vertices, (set_instance<Vec3, &Crowd::set_vertices>))

/// Without offsets, the instance has none.
Result<void> set_crowd_offsets(CrowdHandle& handle, std::uint32_t instance,
                               std::span<const Vec3> offsets) {
  if (!offsets.empty()) offsets = handle.members[instance].offsets.keep(offsets, handle.step);
  return in_words_of_javascript(handle.crowd.set_offsets(instance, offsets));
}
PELT_EXPORT(set_crowd_offsets)

/// Answers with the number of ignored contacts, and with all other contacts.
Result<CrowdStats> collide_crowd(CrowdHandle& handle, std::uint32_t most) {
  if (const auto known = know_ignored(handle); !known) return known.error();
  handle.found.clear();
  CrowdOptions options = self_tests(handle);
  options.max_contacts = most;
  const bool is_limited = most < CrowdOptions().max_contacts;
  const CrowdStats stats =
      is_limited ? collide_limited(handle, options) : collide_all(handle, options);
  remove_ignored(handle);
  answer_arrays(handle.found);
  return stats;
}
PELT_EXPORT(collide_crowd)

void begin_crowd_step(CrowdHandle& handle) {
  handle.crowd.begin_step();
  ++handle.step;
}
PELT_EXPORT(begin_crowd_step)

template <auto kSet>
Result<void> set_motion(CrowdHandle& handle, std::uint32_t instance, std::span<const float> from,
                        std::span<const float> to) {
  handle.members[instance].offsets.start_borrows();
  return in_words_of_javascript((handle.crowd.*kSet)(instance, from, to));
}
PELT_EXPORT_AS(set_crowd_motion, set_motion<&Crowd::set_motion>)
PELT_EXPORT_AS(set_crowd_motion_dual_quaternions, set_motion<&Crowd::set_motion_dual_quaternions>)

/// Answers like collide_crowd, and then with times and features.
Result<CrowdStats> collide_crowd_moving(CrowdHandle& handle, bool leaves_out_start, bool has_times,
                                        std::uint32_t most) {
  if (const auto known = know_ignored(handle); !known) return known.error();
  const CrowdStats stats = collide_motions(handle, {leaves_out_start, has_times, most});
  remove_ignored(handle);
  handle.columns = {};
  if (has_times) write_moving_columns(handle);
  const auto& [times, at_start, features] = handle.columns;
  answer_arrays(handle.found, times, at_start, features);
  return stats;
}
PELT_EXPORT(collide_crowd_moving)

/// Answers like collide_crowd. Precondition: the crowd has these instances and triangles.
Result<void> without_ignored(CrowdHandle& handle, std::span<const CrowdContact> contacts) {
  if (const auto known = know_ignored(handle); !known) return known.error();
  handle.found.assign(contacts.begin(), contacts.end());
  remove_ignored(handle);
  answer_arrays(handle.found);
  return {};
}
PELT_EXPORT(without_ignored)

detail::Fnv1a64* make_hash() { return new detail::Fnv1a64; }
PELT_EXPORT(make_hash)

void delete_hash(detail::Fnv1a64* hash) { delete hash; }
PELT_EXPORT(delete_hash)

void hash_pairs(detail::Fnv1a64& hash, std::uint32_t frame, std::uint32_t a, std::uint32_t b,
                std::span<const Contact> contacts) {
  for (const auto& [triangle_a, triangle_b] : contacts)
    add(hash, frame, {a, b, triangle_a, triangle_b});
}
PELT_EXPORT(hash_pairs)

void hash_crowd(detail::Fnv1a64& hash, std::uint32_t frame,
                std::span<const CrowdContact> contacts) {
  for (const CrowdContact& contact : contacts) add(hash, frame, contact);
}
PELT_EXPORT(hash_crowd)

void hash_value(const detail::Fnv1a64& hash) {
  answer().hash_high = static_cast<double>(hash.value() >> 32);
  answer().hash_low = static_cast<double>(hash.value() & 0xFFFFFFFF);
}
PELT_EXPORT(hash_value)

}  // namespace pelt::wasm

#include "tools/pelt/shard/contact_text.hpp"

#include <cstdint>
#include <tuple>

namespace pelt::tools::shard {
namespace {

constexpr char kZero = '0';
constexpr std::uint64_t kMore = 32;  // added to all digits of a number but the last one
constexpr int kBits = 5;

void add_number(std::uint64_t number, std::string& text) {
  for (; number >= kMore; number >>= kBits)
    text.push_back(static_cast<char>(kZero + kMore + number % kMore));
  text.push_back(static_cast<char>(kZero + number));
}

std::uint64_t sign_last(std::int64_t difference) {
  return difference < 0 ? 2 * static_cast<std::uint64_t>(-difference) + 1
                        : 2 * static_cast<std::uint64_t>(difference);
}

/// Reads numbers. After the first bad one, `is_good` is false and all numbers are 0.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : next_(text.data()), end_(next_ + text.size()) {}

  bool has_more() const { return next_ != end_; }
  bool is_good() const { return is_good_; }
  std::size_t characters_left() const { return static_cast<std::size_t>(end_ - next_); }

  /// A number below 2^60.
  std::uint64_t next() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 12 * kBits && next_ != end_; shift += kBits) {
      const auto digit = static_cast<std::uint64_t>(static_cast<unsigned char>(*next_++)) - kZero;
      if (digit >= 2 * kMore) break;
      number |= digit % kMore << shift;
      if (digit < kMore) return number;
    }
    return fail();
  }

  /// The end of a step from `start`, if it is in [least, limit).
  std::uint64_t step_up(std::uint64_t start, std::uint64_t least, std::uint64_t limit) {
    const std::uint64_t number = start + next();
    return number >= least && number < limit ? number : fail();
  }
  std::uint64_t step(std::uint64_t start, std::uint64_t least, std::uint64_t limit) {
    const std::uint64_t difference = next();
    const std::uint64_t size = difference / 2;
    const std::uint64_t number = difference % 2 == 0 ? start + size : start - size;  // or wraps
    return number >= least && number < limit ? number : fail();
  }

 private:
  std::uint64_t fail() {
    next_ = end_;
    is_good_ = false;
    return 0;
  }

  const char* next_;
  const char* end_;
  bool is_good_ = true;
};

/// The numbers of a collider's triangles in its asset.
struct Triangles {
  std::uint64_t begin = 0, end = 0;

  explicit Triangles(const scene::Collider& collider)
      : begin(collider.first_triangle), end(begin + collider.model.triangle_count()) {}
};

/// Reads the contacts of the last pair.
bool read_pair(Numbers& numbers, const Triangles& a, const Triangles& b,
               scene::FrameContacts& found) {
  const std::uint64_t count = numbers.next();
  if (count == 0 || count > numbers.characters_left() / 2) return false;
  const std::size_t begin = found.contacts.size();
  found.contacts.resize(begin + count);
  Contact last;
  bool is_ascending = true;
  for (std::size_t i = begin; i < begin + count; ++i) {
    const auto of_a = static_cast<std::uint32_t>(numbers.step_up(last.triangle_a, a.begin, a.end));
    const auto of_b = static_cast<std::uint32_t>(numbers.step(last.triangle_b, b.begin, b.end));
    const Contact contact = {of_a, of_b};
    is_ascending = is_ascending && (i == begin || last < contact);
    found.contacts[i] = last = contact;
  }
  return is_ascending && numbers.is_good();
}

}  // namespace

void add_contacts(const scene::FrameContacts& found, std::string& text) {
  for (const scene::FrameContacts::Pair& pair : found.pairs) {
    add_number(pair.a, text);
    add_number(pair.b, text);
    add_number(pair.end - pair.begin, text);
    Contact last;
    for (const Contact& contact : found.of(pair)) {
      add_number(contact.triangle_a - last.triangle_a, text);
      add_number(sign_last(std::int64_t{contact.triangle_b} - last.triangle_b), text);
      last = contact;
    }
  }
}

bool read_contacts(std::string_view text, std::span<const scene::Collider> colliders,
                   scene::FrameContacts& found) {
  Numbers numbers(text);
  while (numbers.has_more()) {
    const std::uint64_t a = numbers.next(), b = numbers.next();
    if (a > b || b >= colliders.size()) return false;
    scene::FrameContacts::Pair pair = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                       found.contacts.size(), 0};
    if (!found.pairs.empty() &&
        std::tie(found.pairs.back().a, found.pairs.back().b) >= std::tie(pair.a, pair.b))
      return false;
    if (!read_pair(numbers, Triangles(colliders[a]), Triangles(colliders[b]), found)) return false;
    pair.end = found.contacts.size();
    found.pairs.push_back(pair);
  }
  return numbers.is_good();
}

}  // namespace pelt::tools::shard

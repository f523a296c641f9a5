#include "tools/pelt/shard/answer_text.hpp"

#include "asset/parsed_json.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "tools/pelt/check/json_fields.hpp"
#include "tools/pelt/list/entry.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace pelt::tools::shard {
namespace {

using check::FrameAnswer;
using nlohmann::ordered_json;

/// Whether a part of an answer is an object with keys, and not a list of its values.
template <typename T>
constexpr bool kHasKeys =
    std::is_same_v<T, check::FrameAnswer> || std::is_same_v<T, check::StepAnswer>;

template <typename Part>
class PartWriter;

template <typename T>
ordered_json json_of(const T& part) {
  PartWriter<T> writer;
  check::describe(writer, part);
  return writer.take();
}

template <typename T>
ordered_json json_of(const std::optional<T>& part) {
  return part ? json_of(*part) : ordered_json();
}

template <typename T>
ordered_json json_of(const std::vector<T>& parts) {
  ordered_json list = ordered_json::array();
  for (const T& part : parts) list.push_back(json_of(part));
  return list;
}

/// Writes the members of a part of an answer, see check::describe.
template <typename Part>
class PartWriter : public check::MemberWriter<PartWriter<Part>> {
 public:
  template <typename T>
  void member(const char* name, const T& value) {
    add(name, json_of(value));
  }

  template <typename Choice, std::size_t kCount>
  void choice(const char* name, Choice value, const char* const (&)[kCount]) {
    add(name, static_cast<std::uint32_t>(value));
  }

  void add(const char* name, ordered_json value) {
    if constexpr (kHasKeys<Part>)
      json_[name] = std::move(value);
    else
      json_.push_back(std::move(value));
  }

  ordered_json take() { return std::move(json_); }

 private:
  ordered_json json_;
};

/// Reads what PartWriter wrote.
template <typename Part>
class PartReader {
 public:
  PartReader(const nlohmann::json& json, const Expected& expected)
      : json_(json), expected_(expected) {
    if (!kHasKeys<Part> && !json.is_array()) bad_ = "";
  }

  /// Returns the name of the first bad value, or null.
  const char* read(Part& part) {
    check::describe(*this, part);
    return bad_ == nullptr && !kHasKeys<Part> && next_ != json_.size() ? "" : bad_;
  }

  void count(const char* name, std::uint64_t& to) { number(name, to, kAny); }
  void below(const char* name, std::uint8_t& to, std::uint64_t limit) { number(name, to, limit); }

  void length(const char* name, double& to) {
    const nlohmann::json& value = next(name);
    verify(name, check::read(value, to) && to >= 0);
  }
  void length(const char* name, float& to) {
    double value = 0;
    length(name, value);
    to = static_cast<float>(value);
  }

  void same(const char* name, const std::uint32_t& value) { verify(name, next(name) == value); }

  void collider(const char* name, std::uint32_t& to) {
    number(name, to, expected_.staged.colliders.size());
  }
  void joint(const char* name, std::uint32_t& to, std::uint32_t of) {
    number(name, to, std::max<std::size_t>(1, expected_.staged.asset_of(of).joints.size()));
  }
  void vertex(const char* name, std::uint32_t& to, std::uint32_t of) {
    number(name, to, expected_.staged.colliders[of].model.vertex_count());
  }

  /// Numbered as in the asset.
  void triangle(const char* name, std::uint32_t& to, std::uint32_t of) {
    const scene::Collider& collider = expected_.staged.colliders[of];
    number(name, to, std::uint64_t{collider.first_triangle} + collider.model.triangle_count());
    to = std::max(to, collider.first_triangle);
  }

  template <typename Choice, std::size_t kCount>
  void choice(const char* name, Choice& to, const char* const (&)[kCount]) {
    std::uint32_t value = 0;
    number(name, value, kCount);
    to = static_cast<Choice>(value);
  }

  void require(bool condition) { verify("", condition); }

  template <typename T>
  void member(const char* name, T& to) {
    verify(name, PartReader<T>(next(name), expected_).read(to) == nullptr);
  }
  template <typename T>
  void member(const char* name, std::vector<T>& to) {
    const nlohmann::json& list = next(name);
    verify(name,
           list.is_array() && std::all_of(list.begin(), list.end(), [&](const nlohmann::json& one) {
             return PartReader<T>(one, expected_).read(to.emplace_back()) == nullptr;
           }));
  }

  /// A step is there if and only if one ends with the frame.
  void member(const char* name, std::optional<check::StepAnswer>& to) {
    const nlohmann::json& value = next(name);
    verify(name, value.is_null() != expected_.step_from.has_value());
    if (bad_ != nullptr || value.is_null()) return;
    check::StepAnswer& step = to.emplace();
    step.from = step.deviation.from = *expected_.step_from;
    step.to = step.deviation.to = expected_.frame;
    verify(name, PartReader<check::StepAnswer>(value, expected_).read(step) == nullptr);
  }

 private:
  static constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

  const nlohmann::json& next(const char* name) {
    static const nlohmann::json kNull;
    if constexpr (kHasKeys<Part>) return check::value_of(json_, name);
    return json_.is_array() && next_ < json_.size() ? json_[next_++] : kNull;
  }

  /// A bad number becomes 0.
  template <typename T>
  void number(const char* name, T& to, std::uint64_t limit) {
    std::uint64_t value = 0;
    const bool is_good = check::read(next(name), value) && value < limit;
    verify(name, is_good);
    to = is_good ? static_cast<T>(value) : T{};
  }

  void verify(const char* name, bool is_good) {
    if (!is_good && bad_ == nullptr) bad_ = name;
  }

  const nlohmann::json& json_;
  const Expected& expected_;
  std::size_t next_ = 0;
  const char* bad_ = nullptr;  // the first one
};

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

std::string answer_text(const FrameAnswer& answer) {
  std::string text = text::json_text(json_of(answer)) + '\n';
  text.append(answer.line).append(1, '\n');
  add_contacts(answer.found, text);
  return text + '\n';
}

bool read_lines(std::istream& in, AnswerLines& lines) {
  return list::read_line(in, lines.values) && list::read_line(in, lines.line) &&
         list::read_line(in, lines.contacts);
}

Result<FrameAnswer> read_answer(AnswerLines& lines, const Expected& expected) {
  const auto bad = [](const char* what) {
    return text::malformed(std::string("bad value of ") + what);
  };
  const Result<asset::ParsedJson> parsed = asset::parse_json(lines.values);
  if (!parsed) return parsed.error();
  FrameAnswer answer;
  answer.line = std::move(lines.line);
  if (!read_contacts(lines.contacts, expected.staged.colliders, answer.found))
    return bad("contacts");
  answer.frame = expected.frame;
  if (expected.staged.colliders.empty()) return bad("frame");
  const char* const name = PartReader<FrameAnswer>(**parsed, expected).read(answer);
  if (name != nullptr) return bad(name);
  return answer;
}

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

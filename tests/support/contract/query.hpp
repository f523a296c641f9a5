#pragma once

/// The contract of a query, and the rows of the table of all queries. Add a query by adding its row
/// to one of the *_queries.cpp files: how to ask it, and its answer by brute force. The properties
/// that all queries have are asserted once, for each row, by tests/query/query_contract_test.cpp,
/// and by tests/memory/query_memory_test.cpp.

#include "support/contract/stage.hpp"

#include <pelt/crowd.hpp>
#include <pelt/pelt.hpp>
#include <pelt/query.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace pelt::contract {

/// The bits of each number as a double, so that NaN equals NaN, and -0.0 differs from 0.0.
using Numbers = std::vector<std::uint64_t>;

template <typename Number>
requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void put(Numbers& numbers,
                                                                          const Number& number) {
  numbers.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(number)));
}

inline void put(Numbers& n, const Vec3& v) { put(n, v.x), put(n, v.y), put(n, v.z); }
inline void put(Numbers& n, const Box& box) { put(n, box.low), put(n, box.high); }
inline void put(Numbers& n, const Contact& c) { put(n, c.triangle_a), put(n, c.triangle_b); }

inline void put(Numbers& n, const Feature& f) { put(n, f.kind), put(n, f.number); }
inline void put(Numbers& n, const MovingContact& c) {
  put(n, c.contact), put(n, c.time), put(n, c.at_start), put(n, c.a), put(n, c.b);
}
inline void put(Numbers& n, const RegionEntry& e) {
  put(n, e.triangle), put(n, e.time), put(n, e.at_start);
}

inline void put(Numbers& n, const CrowdPair& p) { put(n, p.instance_a), put(n, p.instance_b); }
inline void put(Numbers& n, const CrowdContact& c) {
  put(n, c.instance_a), put(n, c.instance_b), put(n, c.triangle_a), put(n, c.triangle_b);
}
inline void put(Numbers& n, const CrowdMovingContact& c) {
  put(n, c.instance_a), put(n, c.instance_b), put(n, c.moving);
}

inline void put(Numbers& n, const SurfacePoint& p) {
  put(n, p.triangle), put(n, p.position);
  for (const float weight : p.barycentrics) put(n, weight);
}
inline void put(Numbers& n, const ClosestPoint& c) { put(n, c.distance), put(n, c.point); }
inline void put(Numbers& n, const Distance& d) {
  put(n, d.distance), put(n, d.lower_bound), put(n, d.a), put(n, d.b);
}
inline void put(Numbers& n, const SolidDistance& d) {
  put(n, d.distance), put(n, d.surface), put(n, d.solid);
}

inline void put(Numbers& n, const Bounds& b) {
  put(n, b.box), put(n, b.sphere.centre), put(n, b.sphere.radius);
}
inline void put(Numbers& n, const RayHit& hit) {
  put(n, hit.triangle), put(n, hit.t), put(n, hit.normal);
  for (const float weight : hit.barycentrics) put(n, weight);
}
inline void put(Numbers& n, const FarthestVertex& v) {
  put(n, v.triangle), put(n, v.corner), put(n, v.position);
}
inline void put(Numbers& n, const Penetration& p) {
  put(n, p.vertex), put(n, p.depth), put(n, p.position), put(n, p.closest);
}
inline void put(Numbers& n, const Volume& v) { put(n, v.value), put(n, v.error); }

inline void put(Numbers& n, const ContactTrace& t) {
  put(n, t.contact), put(n, t.kind), put(n, t.from), put(n, t.to), put(n, t.normal);
  put(n, t.depth);
}
inline void put(Numbers& n, const CurveStep& s) { put(n, s.trace), put(n, s.is_reversed); }
inline void put(Numbers& n, const ContactCurve& c) {
  put(n, c.first), put(n, c.count), put(n, c.is_closed), put(n, c.length), put(n, c.area);
}
inline void put(Numbers& n, const ContactPatch& p) {
  put(n, p.first), put(n, p.count), put(n, p.length), put(n, p.depth);
  put(n, p.joint_a), put(n, p.joint_b);
}

template <typename Item>
void put(Numbers& n, const std::optional<Item>& item) {
  put(n, item.has_value());
  if (item) put(n, *item);
}
template <typename Item>
void put(Numbers& n, const std::vector<Item>& items) {
  put(n, items.size());
  for (const Item& item : items) put(n, item);
}
template <typename Item, std::size_t kCount>
void put(Numbers& n, const std::array<Item, kCount>& items) {
  for (const Item& item : items) put(n, item);
}

inline void put(Numbers& n, const TrianglesInRegion& t) {
  put(n, t.intersecting), put(n, t.inside);
}
inline void put(Numbers& n, const ContactGeometry& g) {
  put(n, g.traces), put(n, g.steps), put(n, g.curves), put(n, g.members), put(n, g.patches);
}

template <typename Answer>
Numbers numbers_of(const Answer& answer) {
  Numbers numbers;
  put(numbers, answer);
  return numbers;
}

/// The numbers of an answer, to be printed.
template <typename Answer>
std::vector<double> readable(const Answer& answer) {
  std::vector<double> numbers;
  for (const std::uint64_t bits : numbers_of(answer))
    numbers.push_back(std::bit_cast<double>(bits));
  return numbers;
}

inline constexpr std::uint32_t kNoLimit = std::numeric_limits<std::uint32_t>::max();

/// Properties of a query besides its answer.
struct Traits {
  bool is_costly = false;      ///< is tested with fewer cases
  bool is_limited = false;     ///< has an option that limits the length of its list
  bool of_two_bodies = false;  ///< gives the same answer for swapped bodies, but for sides
  bool has_threads = false;    ///< takes `Stage::threads`
  /// Has memory that `reserve` does not allocate: allocates in its first call, and then no more.
  bool reserves_when_asked = false;
  bool allocates = false;  ///< in each call
  /// Does other work the second time, or poses vertices again.
  bool varies_in_work = false;
  bool always_hits = false;  ///< has no answer without hits
  /// The answer depends on how vertices are posed, and not only on where they are.
  bool depends_on_skinning = false;
};

/// Prepares a stage before a query is asked. Does nothing by default.
struct Preparation {
  /// Whether the stage fulfils the preconditions.
  std::function<bool(const Stage&)> applies = [](const Stage&) { return true; };
  /// Changes a new stage once, so that the query finds more.
  std::function<void(Stage&)> arrange = [](Stage&) {};
  /// Makes what the query keeps from call to call.
  std::function<void(Stage&)> make = [](Stage&) {};
};

class Query {
 public:
  Query(std::string query_name, const Traits& query_traits, Preparation query_preparation)
      : name(std::move(query_name)),
        traits(query_traits),
        preparation(std::move(query_preparation)) {}
  virtual ~Query() = default;
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  /// Replaces the answer. Lists with `limit` elements are full.
  virtual QueryStats ask(Stage& stage, std::uint32_t limit = kNoLimit) = 0;
  /// Compares the answer with brute force.
  virtual void expect_right(const Stage& stage) const = 0;
  /// The answer, for comparisons bit by bit.
  virtual Numbers numbers() const = 0;
  /// The length of a list, or 1 if a value has been found.
  virtual std::size_t hits() const = 0;
  /// Allocates room for this many elements of the answer.
  virtual void reserve(std::size_t elements) = 0;
  /// Releases the memory of the answer.
  virtual void forget() = 0;

  virtual bool is_list() const = 0;
  /// Asks with a list that has elements already.
  virtual void expect_appended(Stage& stage) = 0;
  /// Asks with limits around the number of elements.
  virtual void expect_limits(Stage& stage) = 0;
  /// Asks a stage whose bodies have been swapped, and compares with the last answer.
  virtual void expect_swapped(Stage& swapped) = 0;

  const std::string name;
  const Traits traits;
  const Preparation preparation;
};

/// A query that appends to a list.
template <typename Item>
struct ListRow {
  std::string name = {};
  std::function<QueryStats(Stage&, std::vector<Item>&, std::uint32_t limit)> ask = nullptr;
  std::function<std::vector<Item>(const Stage&)> brute_force;  ///< in ascending order
  Traits traits = {};
  /// Whether an element is the expected one, if several are right.
  std::function<bool(const Stage&, const Item& found, const Item& expected)> is_right =
      [](const Stage&, const Item& found, const Item& expected) { return found == expected; };
  /// Puts the answer of swapped bodies into the order and the sides of the others.
  std::function<void(std::vector<Item>&)> swap = nullptr;
  /// Removes from an answer what depends on the order of the bodies.
  std::function<void(std::vector<Item>&)> forget_order = [](std::vector<Item>&) {};
  Preparation preparation = {};
};

template <typename Item>
class ListQuery final : public Query {
 public:
  explicit ListQuery(ListRow<Item> row)
      : Query(row.name, row.traits, row.preparation), row_(std::move(row)) {}

  QueryStats ask(Stage& stage, std::uint32_t limit) override {
    found_.clear();
    return row_.ask(stage, found_, limit);
  }

  void expect_right(const Stage& stage) const override {
    const std::vector<Item> expected = row_.brute_force(stage);
    EXPECT_EQ(found_.size(), expected.size());
    for (std::size_t i = 0; i < std::min(found_.size(), expected.size()); ++i)
      ASSERT_TRUE(row_.is_right(stage, found_[i], expected[i]))
          << "element " << i << " of " << found_.size() << ": "
          << testing::PrintToString(readable(found_[i])) << ", expected "
          << testing::PrintToString(readable(expected[i]));
  }

  Numbers numbers() const override { return numbers_of(found_); }
  std::size_t hits() const override { return found_.size(); }
  void reserve(std::size_t elements) override {
    found_ = {};
    found_.reserve(elements);
  }
  void forget() override { found_ = decltype(found_)(); }
  bool is_list() const override { return true; }

  void expect_appended(Stage& stage) override {
    ask(stage, kNoLimit);
    const std::vector<Item> all = found_;
    std::vector<Item> list = all;
    list.resize(std::min<std::size_t>(all.size(), 3));
    const std::size_t before = list.size();
    row_.ask(stage, list, kNoLimit);
    ASSERT_EQ(list.size(), before + all.size());
    EXPECT_TRUE(std::equal(list.begin(), list.begin() + before, all.begin()));
    EXPECT_TRUE(std::equal(all.begin(), all.end(), list.begin() + before));
  }

  void expect_limits(Stage& stage) override {
    EXPECT_FALSE(ask(stage, kNoLimit).cut_short);
    const std::vector<Item> all = found_;
    const auto count = static_cast<std::uint32_t>(all.size());
    for (const std::uint32_t limit :
         {0u, 1u, 2u, 7u, 8u, 9u, count / 2, std::max(count, 1u) - 1, count, count + 1}) {
      SCOPED_TRACE(testing::Message() << "limit " << limit << " of " << count);
      const QueryStats work = ask(stage, limit);
      EXPECT_EQ(found_.size(), std::min(limit, count));
      EXPECT_TRUE(is_part_of(all));
      // A query that is full does not find out whether it has missed anything.
      if (limit != count) {
        EXPECT_EQ(work.cut_short, limit < count);
      }
    }
  }

  void expect_swapped(Stage& swapped) override {
    std::vector<Item> expected = found_;
    ask(swapped, kNoLimit);
    row_.swap(found_);
    row_.forget_order(found_), row_.forget_order(expected);
    EXPECT_EQ(found_, expected);
  }

 private:
  /// Whether the elements are some of these, in the same order.
  bool is_part_of(const std::vector<Item>& all) const {
    auto next = all.begin();
    for (const Item& item : found_) {
      next = std::find(next, all.end(), item);
      if (next++ == all.end()) return false;
    }
    return true;
  }

  ListRow<Item> row_;
  std::vector<Item> found_;
};

/// A query with a result of fixed size.
template <typename Value>
struct ValueRow {
  const char* name;
  std::function<QueryStats(Stage&, Value&)> ask;
  std::function<void(const Stage&, const Value&)> expect_right;
  std::function<bool(const Value&)> is_hit;
  Traits traits = {};
  std::function<void(const Value& expected, const Value& swapped)> expect_swapped = nullptr;
  Preparation preparation = {};
};

template <typename Value>
class ValueQuery final : public Query {
 public:
  explicit ValueQuery(ValueRow<Value> row)
      : Query(row.name, row.traits, row.preparation), row_(std::move(row)) {}

  QueryStats ask(Stage& stage, std::uint32_t) override { return row_.ask(stage, found_); }
  void expect_right(const Stage& stage) const override { row_.expect_right(stage, found_); }
  Numbers numbers() const override { return numbers_of(found_); }
  std::size_t hits() const override { return row_.is_hit(found_); }
  void reserve(std::size_t) override {}
  void forget() override { found_ = Value(); }
  bool is_list() const override { return false; }
  void expect_appended(Stage&) override {}
  void expect_limits(Stage&) override {}

  void expect_swapped(Stage& swapped) override {
    const Value expected = found_;
    ask(swapped, kNoLimit);
    row_.expect_swapped(expected, found_);
  }

 private:
  ValueRow<Value> row_;
  Value found_ = {};
};

/// A question of yes or no.
struct YesNoRow {
  const char* name;
  std::function<YesNo(Stage&)> ask;
  std::function<bool(const Stage&)> brute_force;
  Traits traits = {};
};

using Queries = std::vector<std::unique_ptr<Query>>;

template <typename Item>
void add(Queries& queries, ListRow<Item> row) {
  queries.push_back(std::make_unique<ListQuery<Item>>(std::move(row)));
}
template <typename Value>
void add(Queries& queries, ValueRow<Value> row) {
  queries.push_back(std::make_unique<ValueQuery<Value>>(std::move(row)));
}
void add(Queries& queries, YesNoRow row);

// The rows of the table, each function in a file of its own.
void add_contact_queries(Queries& queries);
void add_self_queries(Queries& queries);
void add_moving_queries(Queries& queries);
void add_distance_queries(Queries& queries);
void add_solid_queries(Queries& queries);
void add_ray_and_bounds_queries(Queries& queries);
void add_inside_queries(Queries& queries);
void add_crowd_queries(Queries& queries);

/// Removes what the filter leaves out, which tests/self compares with the definition.
template <typename Item>
std::vector<Item> left_by(const SelfFilter& filter, std::vector<Item> items) {
  std::erase_if(items, [&](const Item& item) {
    const Contact* contact = nullptr;
    if constexpr (std::is_same_v<Item, Contact>)
      contact = &item;
    else
      contact = &item.contact;
    return filter.left_out_by(contact->triangle_a, contact->triangle_b) != LeftOutBy::none;
  });
  return items;
}

/// All queries.
const Queries& queries();

}  // namespace pelt::contract

#include "base/arena.hpp"

#include "support/allocation_count.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace pelt::detail {
namespace {

struct Piece {
  std::byte* at;
  std::size_t size;
  int content;
};

/// Allocates pieces of these sizes and fills each with a different number.
std::vector<Piece> allocate_all(Arena& arena, const std::vector<std::size_t>& sizes) {
  std::vector<Piece> pieces;
  for (const std::size_t size : sizes) {
    pieces.push_back({arena.allocate(size), size, static_cast<int>(pieces.size() % 251)});
    std::memset(pieces.back().at, pieces.back().content, size);
  }
  return pieces;
}

void expect_untouched(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces)
    for (std::size_t i = 0; i < piece.size; ++i)
      ASSERT_EQ(piece.at[i], static_cast<std::byte>(piece.content));
}

std::vector<std::size_t> random_sizes(test::Random& random) {
  std::vector<std::size_t> sizes;
  for (int i = 0; i < 300; ++i)
    sizes.push_back(random.chance(0.02) ? random.index(400'000) : random.index(3'000));
  return sizes;
}

TEST(Arena, PiecesAreAlignedAndApart) {
  test::Random random(50);
  Arena arena;
  for (int round = 0; round < 10; ++round) {
    const auto pieces = allocate_all(arena, random_sizes(random));
    for (const Piece& piece : pieces)
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(piece.at) % Arena::kAlignment, 0u);
    expect_untouched(pieces);
    arena.clear();
  }
}

TEST(Arena, TheSameNeedsAfterClearAllocateNothing) {
  test::Random random(51);
  Arena arena;
  const auto sizes = random_sizes(random);
  for (const std::size_t size : sizes) arena.allocate(size);
  const std::size_t held = arena.capacity();
  for (int round = 0; round < 3; ++round) {
    arena.clear();
    EXPECT_EQ(arena.used(), 0u);
    const std::size_t before = test::allocation_count();
    for (const std::size_t size : sizes) arena.allocate(size);
    EXPECT_EQ(test::allocation_count(), before);
  }
  EXPECT_EQ(arena.capacity(), held);
}

TEST(Arena, WhatFitsNeedsNoAllocationInAnyOrder) {
  test::Random random(53);
  Arena arena;
  auto sizes = random_sizes(random);
  for (const std::size_t size : sizes) arena.allocate(size);
  const std::size_t used = arena.used();
  EXPECT_LT(arena.room(), used) << "the pieces lie in several blocks";
  arena.reserve(used);
  arena.clear();
  EXPECT_EQ(arena.room(), used);
  EXPECT_EQ(arena.capacity(), used) << "the other blocks are gone";
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = sizes.size(); i > 1; --i)
      std::swap(sizes[i - 1], sizes[random.index(static_cast<std::uint32_t>(i))]);
    const std::size_t before = test::allocation_count();
    for (const std::size_t size : sizes) arena.allocate(size);
    EXPECT_EQ(test::allocation_count(), before);
    EXPECT_EQ(arena.used(), used);
    arena.clear();
  }
}

TEST(Arena, KeepsThePiecesInBlocksThatAReservationReplaces) {
  test::Random random(54);
  Arena arena;
  const auto pieces = allocate_all(arena, random_sizes(random));
  arena.reserve(2 * arena.used());
  EXPECT_EQ(arena.room(), 2 * arena.used());
  EXPECT_GT(arena.capacity(), arena.room()) << "replaced blocks count until they are freed";
  const auto more = allocate_all(arena, random_sizes(random));
  expect_untouched(pieces);
  expect_untouched(more);
}

TEST(Arena, WhatWasReservedNeedsNoAllocation) {
  for (const std::size_t held : {0u, 100u, 9'000u, 100'000u}) {
    Arena arena;
    if (held > 0) arena.allocate(held);
    arena.reserve(held + 700'000);
    EXPECT_GE(arena.capacity(), held + 700'000);
    arena.clear();
    const std::size_t before = test::allocation_count();
    for (int i = 0; i < 10; ++i) arena.allocate(64'000);
    EXPECT_EQ(test::allocation_count(), before) << held;
  }
}

TEST(Arena, HoldsLittleMoreThanWasAskedFor) {
  test::Random random(52);
  Arena arena;
  std::size_t asked = 0;
  while (asked < 10'000'000) {
    const std::size_t size = 64 * (1 + random.index(60));
    arena.allocate(size);
    asked += size;
    EXPECT_EQ(arena.used(), asked);
    EXPECT_GE(arena.capacity(), arena.used());
  }
  EXPECT_LT(static_cast<double>(arena.capacity()), 1.05 * static_cast<double>(asked));
}

struct alignas(64) Counter {
  int value = 7;
};

TEST(Arena, ConstructsWhatItMakesRoomFor) {
  Arena arena;
  const Counter *first = arena.allocate<Counter>(), *second = arena.allocate<Counter>();
  EXPECT_NE(first, second);
  EXPECT_EQ(first->value + second->value, 14);
}

}  // namespace
}  // namespace pelt::detail

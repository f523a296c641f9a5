/// How much of the stack the exact tests of moving triangles use. The npm package sets the size of
/// its stack (bindings/wasm/CMakeLists.txt).
#include "motion/moving_pair.hpp"

#include "moving_cases.hpp"
#include "solid/region_triangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <pthread.h>
#include <sys/mman.h>

namespace pelt::test {
namespace {

void* ask_pairs_of_all_families(void* met) {
  for (const MovingFamily& family : kMovingFamilies) {
    Random random(197);
    for (int i = 0; i < 40; ++i) {
      const MovingPair pair = family.make(random);
      *static_cast<int*>(met) += detail::first_meeting(pair.a, pair.b).has_value();
    }
  }
  return nullptr;
}

void* ask_regions_of_all_families(void* touched) {
  for (const MovingFamily& family : kMovingFamilies) {
    Random random(198);
    for (int i = 0; i < 10; ++i) {
      const auto [triangle, other] = family.make(random);
      const auto& [p, q, r] = other.from;
      const detail::Face faces[] = {{p, q, 1}, {q, r, 1}, {r, p, 1}, {p, r, 2}};
      *static_cast<int*>(touched) += detail::first_touch(triangle, faces).has_value();
      *static_cast<int*>(touched) += detail::first_touch(triangle, Capsule{p, q, 1}).has_value();
    }
  }
  return nullptr;
}

/// A thread's stack whose unused bytes are known.
class MarkedStack {
 public:
  MarkedStack()
      : bytes_(static_cast<std::uint8_t*>(
            mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
    std::fill_n(bytes_, kSize, kMark);
  }
  ~MarkedStack() { munmap(bytes_, kSize); }
  MarkedStack(const MarkedStack&) = delete;
  MarkedStack& operator=(const MarkedStack&) = delete;

  void run(void* (*function)(void*), void* argument) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    ASSERT_EQ(pthread_attr_setstack(&attributes, bytes_, kSize), 0);
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, function, argument), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
  }

  /// The stack grows downwards.
  std::size_t used() const {
    const auto* first =
        std::find_if(bytes_, bytes_ + kSize, [](std::uint8_t byte) { return byte != kMark; });
    return static_cast<std::size_t>(bytes_ + kSize - first);
  }

 private:
  static constexpr std::size_t kSize = std::size_t{4} << 20;
  static constexpr std::uint8_t kMark = 0xA5;
  std::uint8_t* bytes_;
};

TEST(MovingPair, UsesNoMoreOfTheStackThanItsHeaderSays) {
  MarkedStack stack;
  int met = 0;
  stack.run(ask_pairs_of_all_families, &met);
  EXPECT_GT(met, 0);
  EXPECT_GT(stack.used(), std::size_t{100'000});
  EXPECT_LT(stack.used(), std::size_t{300'000});
}

TEST(MovingRegion, UsesNoMoreOfTheStackThanItsHeaderSays) {
  MarkedStack stack;
  int touched = 0;
  stack.run(ask_regions_of_all_families, &touched);
  EXPECT_GT(touched, 0);
  EXPECT_GT(stack.used(), std::size_t{200'000});
  EXPECT_LT(stack.used(), std::size_t{900'000});
}

}  // namespace
}  // namespace pelt::test

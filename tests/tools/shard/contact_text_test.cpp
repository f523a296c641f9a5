#include "tools/pelt/shard/answer_text.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace pelt::tools::shard {
namespace {

/// Bodies with a few hundred triangles. The numbers of the last one's triangles begin late, as
/// those of a part do.
std::vector<scene::Collider> three_bodies() {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::CreatureOptions{1000, 24, 1}));
  scene.instances.resize(3);
  auto colliders = *scene::make_colliders(scene, scene::Granularity::instance, {});
  colliders[2].first_triangle = 4'294'000'000;
  return colliders;
}

class RandomContacts {
 public:
  RandomContacts(const std::vector<scene::Collider>& colliders, std::uint32_t seed)
      : colliders_(colliders), random_(seed) {}

  scene::FrameContacts next() {
    scene::FrameContacts found;
    for (std::uint32_t a = 0; a < colliders_.size(); ++a)
      for (std::uint32_t b = a; b < colliders_.size(); ++b) add_pair(a, b, found);
    return found;
  }

 private:
  void add_pair(std::uint32_t a, std::uint32_t b, scene::FrameContacts& found) {
    std::set<Contact> contacts;
    for (std::uint32_t count = below(4) * below(40); count > 0; --count)
      contacts.insert({triangle_of(a), triangle_of(b)});
    if (contacts.empty()) return;
    const std::size_t begin = found.contacts.size();
    found.contacts.insert(found.contacts.end(), contacts.begin(), contacts.end());
    found.pairs.push_back({a, b, begin, found.contacts.size()});
  }

  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  /// Ends of the range are frequent.
  std::uint32_t triangle_of(std::uint32_t collider) {
    const scene::Collider& of = colliders_[collider];
    const std::uint32_t count = of.model.triangle_count(), chosen = below(count + 20);
    if (chosen >= count) return of.number_in_asset(chosen % 2 == 0 ? 0 : count - 1);
    return of.number_in_asset(chosen);
  }

  const std::vector<scene::Collider>& colliders_;
  std::mt19937 random_;
};

bool are_equal(const scene::FrameContacts& a, const scene::FrameContacts& b) {
  const auto is_same = [](const auto& x, const auto& y) {
    return std::tie(x.a, x.b, x.begin, x.end) == std::tie(y.a, y.b, y.begin, y.end);
  };
  return a.contacts == b.contacts &&
         std::equal(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), b.pairs.end(), is_same);
}

TEST(ContactText, IsReadAsItWasWritten) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<scene::Collider> colliders = three_bodies();
  RandomContacts random(colliders, seed);
  std::size_t contacts = 0, characters = 0;
  for (int i = 0; i < 300; ++i) {
    const scene::FrameContacts found = random.next();
    std::string text;
    add_contacts(found, text);
    scene::FrameContacts again;
    ASSERT_TRUE(read_contacts(text, colliders, again)) << text;
    ASSERT_TRUE(are_equal(again, found)) << text;
    ASSERT_EQ(text.find_first_of("\n\r \"\x7f"), text.npos);
    contacts += found.contacts.size();
    characters += text.size();
  }
  EXPECT_GT(contacts, 10'000u);
  EXPECT_LT(characters, 6 * contacts);
}

TEST(ContactText, OfNothingIsEmpty) {
  std::string text;
  add_contacts({}, text);
  EXPECT_EQ(text, "");
  scene::FrameContacts found;
  EXPECT_TRUE(read_contacts("", {}, found));
  EXPECT_TRUE(found.pairs.empty());
}

TEST(ContactText, IsRefusedForTrianglesThatDoNotExist) {
  const std::vector<scene::Collider> colliders = three_bodies();
  const std::uint32_t first = colliders[2].first_triangle,
                      end = first + colliders[2].model.triangle_count();
  for (const std::uint32_t triangle : {0u, first - 1, first, end - 1, end, 0xFFFFFFFFu}) {
    scene::FrameContacts found;
    found.contacts.push_back({0, triangle});
    found.pairs.push_back({0, 2, 0, 1});
    std::string text;
    add_contacts(found, text);
    scene::FrameContacts again;
    EXPECT_EQ(read_contacts(text, colliders, again), triangle >= first && triangle < end)
        << triangle;
  }
}

TEST(ContactText, HasNoBadPrefixThatIsRead) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<scene::Collider> colliders = three_bodies();
  RandomContacts random(colliders, seed);
  std::size_t refused = 0, read = 0;
  for (int i = 0; i < 20; ++i) {
    std::string text;
    add_contacts(random.next(), text);
    for (std::size_t length = 0; length < text.size(); ++length) {
      scene::FrameContacts found;
      const bool is_read = read_contacts(text.substr(0, length), colliders, found);
      ++(is_read ? read : refused);
      if (is_read) {
        std::string again;
        add_contacts(found, again);
        ASSERT_EQ(again, text.substr(0, length));  // it ends with a pair
      }
    }
  }
  EXPECT_GT(refused, 100 * read);
  EXPECT_GE(read, 20u);
}

}  // namespace
}  // namespace pelt::tools::shard

#include <pelt/model.hpp>

#include "support/prepared_file.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/config.hpp>
#include <pelt/pelt.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <tuple>

namespace pelt {
namespace {

using test::Bytes;
using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

SkinnedModel limb() { return *build_model(test::make_limb(40, 12, 5).view()); }

std::string refusal_of(const Bytes& file) {
  const Result<SkinnedModel> model = load_model(file);
  return model ? "accepted" : model.error().message;
}

void expect_words(const Bytes& file, const char* words) {
  EXPECT_NE(refusal_of(file).find(words), std::string::npos)
      << "expected: " << words << "\nfound:    " << refusal_of(file);
}

/// The answers of two poses, and their work.
auto answers(Pose& a, Pose& b) {
  Scratch scratch;
  std::vector<Contact> contacts;
  const QueryStats work = collide(a, b, scratch, contacts);
  std::vector<Vec3> posed(a.model().vertex_count());
  posed_vertices(a, posed);
  return std::tuple(contacts, posed, work.node_pairs, work.refits, work.posed_vertices,
                    work.triangle_pairs, work.displacements);
}

void expect_equal_answers(const Shape& shape, Motion motion, Random& random, int& touching) {
  const SkinnedModel built = *build_model(shape.view());
  const Result<SkinnedModel> loaded = load_model(save_model(built));
  ASSERT_TRUE(loaded) << loaded.error().message;
  Pose a(built), b(built), loaded_a(*loaded), loaded_b(*loaded);
  for (int round = 0; round < 5; ++round) {
    const auto palette_a = test::make_palette(random, shape.joint_count, motion, 0.5);
    const auto palette_b = test::make_palette(random, shape.joint_count, motion, 0.5);
    for (Pose* pose : {&a, &loaded_a}) ASSERT_TRUE(pose->set_palette(palette_a));
    for (Pose* pose : {&b, &loaded_b}) ASSERT_TRUE(pose->set_palette(palette_b));
    const auto weights =
        test::make_morph_weights(random, shape.morph_target_count(), test::Morphing::some);
    for (Pose* pose : {&a, &loaded_a}) ASSERT_TRUE(pose->set_morph_weights(weights));
    const auto expected = answers(a, b);
    EXPECT_EQ(answers(loaded_a, loaded_b), expected);
    touching += !std::get<0>(expected).empty();
  }
}

TEST(Prepared, AnswersAsTheModelThatWasBuilt) {
  const InstructionSet before = active_instruction_set();
  Random random(300);
  int touching = 0;
  for (const InstructionSet set : available_instruction_sets()) {
    set_active_instruction_set(set);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::far_away}) {
      expect_equal_answers(test::make_limb(40, 12, 5), motion, random, touching);
      expect_equal_answers(test::make_soup(random, 300, 7, 4, Weights::random), motion, random,
                           touching);
      Shape morphing = test::make_limb(40, 12, 5);
      test::add_morph_targets(random, morphing, 9, 0.3, 0.1);
      expect_equal_answers(morphing, motion, random, touching);
      expect_equal_answers(test::make_soup(random, 1, 1, 1, Weights::one_joint), motion, random,
                           touching);
    }
  }
  set_active_instruction_set(before);
  EXPECT_GT(touching, 20);
}

TEST(Prepared, KeepsTheReport) {
  Shape shape = test::make_limb(5, 4, 2);
  shape.triangles.push_back({3, 3, 4});
  const SkinnedModel loaded = *load_model(save_model(*build_model(shape.view())));
  EXPECT_EQ(loaded.report().degenerate_triangles, 1u);
  EXPECT_EQ(loaded.vertex_count(), shape.rest_positions.size());
  EXPECT_EQ(loaded.triangle_count(), shape.triangles.size());
  EXPECT_EQ(loaded.joint_count(), 2u);
}

TEST(Prepared, TheSameModelGivesTheSameBytes) {
  const Bytes file = save_model(limb());
  EXPECT_EQ(save_model(limb()), file);
  EXPECT_EQ(save_model(*load_model(file)), file);
}

/// The bytes may have any alignment, as in a file mapped into memory.
TEST(Prepared, LoadsFromOddAddresses) {
  Bytes file = save_model(limb());
  file.insert(file.begin(), std::byte{0});
  EXPECT_TRUE(load_model(std::span(file).subspan(1)));
}

struct Forgery {
  const char* words;  ///< of the message
  void (*commit)(detail::PreparedHeader&);
};

const Forgery kForgeries[] = {
    {"is not a prepared model", [](detail::PreparedHeader& h) { h.magic[0] = 'P'; }},
    {"is not a prepared model", [](detail::PreparedHeader& h) { h.magic[7] = 0; }},
    {"the prepared model was made by another version of Pelt (version 1 of the format, this one "
     "reads version 4): run `pelt prepare` or save_model() again",
     [](detail::PreparedHeader& h) { h.version = 1; }},
    {"another version of Pelt (version 5 of", [](detail::PreparedHeader& h) { h.version = 5; }},
    {"another version of Pelt (version 0 of", [](detail::PreparedHeader& h) { h.version = 0; }},
    {"the other byte order", [](detail::PreparedHeader& h) { h.byte_order = 0x04030201; }},
    {"byte order mark 01020305", [](detail::PreparedHeader& h) { ++h.byte_order; }},
    {"but its header says 1", [](detail::PreparedHeader& h) { h.file_size = 1; }},
    {"but its header says 18446744073709551615",
     [](detail::PreparedHeader& h) { h.file_size = UINT64_MAX; }},
    {"is damaged", [](detail::PreparedHeader& h) { ++h.checksum; }},
    {"is damaged", [](detail::PreparedHeader& h) { ++h.joint_count; }},
};

TEST(Prepared, NamesWhatIsWrongWithTheHeader) {
  for (const Forgery& forgery : kForgeries) {
    Bytes file = save_model(limb());
    detail::PreparedHeader header = test::header_of(file);
    forgery.commit(header);
    test::put_header(header, file);
    expect_words(file, forgery.words);
  }
}

const Forgery kMendedForgeries[] = {
    {"joint_count is 0", [](detail::PreparedHeader& h) { h.joint_count = 0; }},
    {"joint_count is 65536", [](detail::PreparedHeader& h) { h.joint_count = 65536; }},
    {"but joint_count is 1", [](detail::PreparedHeader& h) { h.joint_count = 1; }},
    {"rest_extent is 0", [](detail::PreparedHeader& h) { h.rest_extent = 0; }},
    {"rest_extent is inf", [](detail::PreparedHeader& h) { h.rest_extent = HUGE_VALF; }},
    {"its arrays take", [](detail::PreparedHeader& h) { h.counts[0] = UINT32_MAX; }},
    {"its arrays take", [](detail::PreparedHeader& h) { h.counts.fill(UINT32_MAX); }},
    {"its arrays take", [](detail::PreparedHeader& h) { h.counts[19] -= 1; }},
};

TEST(Prepared, NamesWhatAForgerHasDoneToTheHeader) {
  for (const Forgery& forgery : kMendedForgeries) {
    Bytes file = save_model(limb());
    detail::PreparedHeader header = test::header_of(file);
    forgery.commit(header);
    test::put_header(header, file);
    test::mend(file);
    expect_words(file, forgery.words);
  }
}

ErrorCode refusal_code(const Bytes& file) { return load_model(file).error().code; }

/// Even if the header size, the checksum and the arrays differ.
TEST(Prepared, DistinguishesOtherVersionsFromDamage) {
  for (const std::uint32_t version : {1u, 2u, 3u, 5u, 0x7FFFFFFFu}) {
    Bytes file = save_model(limb());
    std::memcpy(&file[8], &version, sizeof version);
    EXPECT_EQ(refusal_code(file), ErrorCode::unsupported);
    std::fill(file.begin() + 16, file.end(), std::byte{0xA5});
    EXPECT_EQ(refusal_code(file), ErrorCode::unsupported);
    file.resize(16);
    EXPECT_EQ(refusal_code(file), ErrorCode::unsupported);
  }
  Bytes file = save_model(limb());
  file.back() ^= std::byte{1};
  EXPECT_EQ(refusal_code(file), ErrorCode::malformed_file);
  file.resize(16);
  EXPECT_EQ(refusal_code(file), ErrorCode::malformed_file);
}

Bytes stored_limb() {
  std::ifstream stream(PELT_STORED_LIMB, std::ios::binary);
  std::vector<char> text{std::istreambuf_iterator<char>(stream), {}};
  Bytes file(text.size());
  std::transform(text.begin(), text.end(), file.begin(), [](char c) { return std::byte(c); });
  return file;
}

/// If you change the layout or the meaning of an array, raise the version and store the limb.pelt
/// that prepared_seeds writes. Otherwise earlier files are refused as damaged, or miss contacts.
TEST(Prepared, FilesOfThisVersionKeepTheirMeaning) {
  const Shape shape = test::make_morphing_limb(20, 8, 3);
  const Result<SkinnedModel> stored = load_model(stored_limb());
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_FALSE(stored->detail().bounds.fits.empty());
  EXPECT_FALSE(stored->detail().bounds.joint_boxes.empty());
  const SkinnedModel built = *build_model(shape.view());
  Pose a(built), b(built), stored_a(*stored), stored_b(*stored);
  Random random(306);
  int touching = 0;
  for (int round = 0; round < 20; ++round) {
    const auto palette_a = test::bend_limb(random, 3, 0.5, {});
    const auto palette_b = test::bend_limb(random, 3, 0.5, {0.1f, 0.1f, 0});
    for (Pose* pose : {&a, &stored_a}) ASSERT_TRUE(pose->set_palette(palette_a));
    for (Pose* pose : {&b, &stored_b}) ASSERT_TRUE(pose->set_palette(palette_b));
    const auto weights = test::make_morph_weights(random, 3, test::Morphing::all);
    for (Pose* pose : {&a, &stored_a}) ASSERT_TRUE(pose->set_morph_weights(weights));
    const auto contacts = std::get<0>(answers(a, b));
    EXPECT_EQ(std::get<0>(answers(stored_a, stored_b)), contacts);
    EXPECT_EQ(check_bounds(stored_a), "");
    touching += !contacts.empty();
  }
  EXPECT_GT(touching, 10);
}

TEST(Prepared, NamesTheArrayAndTheIndex) {
  const SkinnedModel model = limb();
  Bytes file = save_model(model);
  const std::size_t triangle_ids = test::array_places(model.detail())[5];
  file[triangle_ids + 4 * 7 + 3] = std::byte{0xFF};
  test::mend(file);
  expect_words(file, "the prepared model is malformed, triangle_ids[7] is 42");
}

TEST(Prepared, RecognisesFilesByTheirFirstBytes) {
  const Bytes file = save_model(limb());
  EXPECT_TRUE(is_prepared_model(file));
  EXPECT_TRUE(is_prepared_model(std::span(file).first(8)));
  EXPECT_FALSE(is_prepared_model(std::span(file).first(7)));
  EXPECT_FALSE(is_prepared_model({}));
}

}  // namespace
}  // namespace pelt

/// Finds the contacts of two characters in all frames of a clip, in a loop on one thread. The C++
/// half of python_overhead.py, which writes its input and runs it.
///
///     clip_loop MODEL_A PALETTES_A MODEL_B PALETTES_B FRAMES RUNS
///
/// A model is a prepared model; palettes are column-major floats, frame after frame. Prints the
/// milliseconds of each run, and the number of contacts.

#include <pelt/collide.hpp>
#include <pelt/model.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

namespace {

std::vector<char> read_file(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A character, and its palettes in all frames.
struct Body {
  pelt::SkinnedModel model;
  std::vector<char> palettes;

  std::span<const pelt::Matrix4> palette(std::size_t frame) const {
    const auto* first = reinterpret_cast<const pelt::Matrix4*>(palettes.data());
    return {first + frame * model.joint_count(), model.joint_count()};
  }
};

Body read_body(const char* model, const char* palettes) {
  const std::vector<char> bytes = read_file(model);
  auto loaded = pelt::load_model(std::as_bytes(std::span(bytes)));
  if (loaded) return {*std::move(loaded), read_file(palettes)};
  std::fprintf(stderr, "clip_loop: %s: %s\n", model, loaded.error().message.c_str());
  std::exit(1);
}

std::size_t run(const Body& body_a, const Body& body_b, std::size_t frames) {
  pelt::Pose a(body_a.model), b(body_b.model);
  pelt::Scratch scratch;
  std::vector<pelt::Contact> contacts;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (!a.set_palette(body_a.palette(frame)) || !b.set_palette(body_b.palette(frame))) return 0;
    pelt::collide(a, b, scratch, contacts);
  }
  return contacts.size();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) return std::fputs("usage: see python_overhead.py\n", stderr), 2;
  const Body a = read_body(argv[1], argv[2]), b = read_body(argv[3], argv[4]);
  std::size_t contacts = 0;
  for (int i = std::atoi(argv[6]); i > 0; --i) {
    const auto begin = std::chrono::steady_clock::now();
    contacts = run(a, b, static_cast<std::size_t>(std::atoi(argv[5])));
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    std::printf("%.6f ", time.count());
  }
  std::printf("\n%zu\n", contacts);
}

#pragma once

/// Shared code of programs that measure the characters of their command line.

#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "scenes/scene.hpp"

#include <pelt/model.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

namespace pelt::programs {

/// Duration of `work()`.
template <typename Work>
double microseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// Random numbers that are the same on every platform.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937_64 engine_;
};

/// Skins all vertices and computes all boxes of a pose.
inline void open_all(Pose& pose) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  make_table(posed);
  detail::open_all(posed);
}

struct Program {
  const char *name, *description;
};

/// Prints a failure to standard error, and returns the exit code.
inline int fail(const Program& program, const std::string& message) {
  std::fprintf(stderr, "%s: %s\n", program.name, message.c_str());
  return 1;
}

/// An option of a program, with its default in `value`.
struct CountOption {
  const char* name;
  std::uint32_t& value;
  const char* help;
};

/// A character with its model, and how to name it.
struct Subject {
  std::string name;
  scenes::Character character;
  SkinnedModel model;
};

/// The character in a file, or the generated one if `path` is empty.
inline Result<Subject> load_subject(const std::string& path) {
  Result<scenes::Character> character = path.empty()
                                            ? scenes::generate_character(scenes::CreatureOptions{})
                                            : scenes::load_character(path);
  if (!character) return character.error();
  const Result<SkinnedModel> model =
      build_model(character->asset.mesh(), {.off_weights = OffWeights::renormalise});
  if (!model) return model.error();
  return Subject{path.empty() ? "the generated character" : path, std::move(*character), *model};
}

/// Parses the command line, which names characters or none for the generated one, and calls
/// `measure(subject)` for each. Returns the exit code, after the first failure.
template <typename Measure>
int measure_characters(const Program& program, int argc, char** argv,
                       std::initializer_list<CountOption> options, const Measure& measure) {
  CLI::App app(program.description);
  std::vector<std::string> paths;
  app.add_option("MODELS", paths, "Characters (.glb); default: the generated one");
  for (const CountOption& option : options)
    app.add_option(option.name, option.value, option.help)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if (paths.empty()) paths.emplace_back();
  for (const std::string& path : paths) {
    const Result<Subject> subject = load_subject(path);
    if (!subject) return fail(program, subject.error().message);
    const Result<void> measured = measure(*subject);
    if (!measured) return fail(program, measured.error().message);
  }
  return 0;
}

}  // namespace pelt::programs

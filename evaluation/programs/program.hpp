#pragma once

/// Shared code of programs that measure the characters of their command line.

#include "scenes/scene.hpp"

#include <pelt/model.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
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

struct Program {
  const char *name, *description;
};

/// Prints a failure to standard error, and returns the exit code.
inline int fail(const Program& program, const std::string& message) {
  std::fprintf(stderr, "%s: %s\n", program.name, message.c_str());
  return 1;
}

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
/// `measure(subject)` for each. `add_options(app)` adds the options of the program. Returns the
/// exit code, after the first failure.
template <typename AddOptions, typename Measure>
int measure_characters(const Program& program, int argc, char** argv, const AddOptions& add_options,
                       const Measure& measure) {
  CLI::App app(program.description);
  std::vector<std::string> paths;
  app.add_option("MODELS", paths, "Characters (.glb); default: the generated one");
  add_options(app);
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

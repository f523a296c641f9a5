#include "tools/pelt/bench/bench_baseline.hpp"

namespace pelt::tools::bench {
namespace {

using asset::JsonObject;

Figures read_figures(const JsonObject& object) {
  Figures figures;
  figures.method = required_text(object, known_key(object, "method", "engine"));
  figures.variant = {one_of(object, "query", {Question::all, Question::first}),
                     one_of(object, "cache", {Cache::hot, Cache::cold})};
  figures.asked = one_of(object, "asked", {Asked::pairs, Asked::crowd, Asked::self, Asked::none});
  figures.threads = static_cast<std::uint32_t>(object.count("threads"));
  figures.answer.hash = hash_in(object);
  figures.times.mean_us = positive(object, "mean_us");
  return figures;
}

SceneFigures read_scene(const JsonObject& object) {
  SceneFigures scene;
  scene.scene = required_text(object, "scene");
  scene.frames = object.count("frames");
  scene.time = one_of(object, "time", {Time::thread, Time::wall});
  for (const JsonObject& method : object.objects(known_key(object, "methods", "engines")))
    scene.figures.push_back(read_figures(method));
  return scene;
}

}  // namespace

Result<Baseline> parse_baseline(const std::string& path, std::string_view text) {
  return parse_baseline(path, text, kSceneFormat, read_scene);
}

Result<Baseline> read_baseline(const std::string& path) {
  const auto text = read_figures(path, kSceneFormat);
  if (!text) return text.error();
  return parse_baseline(path, *text);
}

}  // namespace pelt::tools::bench

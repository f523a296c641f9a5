#include "tools/pelt/bench/moving_baseline.hpp"

namespace pelt::tools::bench {
namespace {

using asset::JsonObject;

MovingFigures read_moving_figures(const JsonObject& object) {
  MovingFigures figures;
  figures.method = required_text(object, "method");
  figures.question = one_of(object, "query", kMovingQuestions);
  figures.answer.hash = hash_in(object);
  figures.times.mean_us = positive(object, "mean_us");
  return figures;
}

MovingSceneFigures read_moving_scene(const JsonObject& object) {
  MovingSceneFigures scene;
  scene.scene = required_text(object, "scene");
  scene.steps = object.count("steps");
  for (const JsonObject& method : object.objects("methods"))
    scene.figures.push_back(read_moving_figures(method));
  return scene;
}

}  // namespace

Result<MovingBaseline> parse_moving_baseline(const std::string& path, std::string_view text) {
  return parse_baseline(path, text, kMovingFormat, read_moving_scene);
}

Result<MovingBaseline> read_moving_baseline(const std::string& path) {
  const auto text = read_figures(path, kMovingFormat);
  if (!text) return text.error();
  return parse_moving_baseline(path, *text);
}

}  // namespace pelt::tools::bench

#include "tools/pelt/check/check_settings.hpp"

namespace pelt::tools::check {

CheckQuestion question_of(const CheckSettings& settings, const scenes::Scene& scene,
                          const arguments::ModelArguments& models) {
  CheckQuestion question;
  question.method = settings.method.name;
  question.by = settings.granularity == scene::Granularity::part ? "part" : "instance";
  question.frames = settings.frames;
  question.fps = scene.fps;
  for (const scenes::Take& take : scene.takes) question.clips.push_back(take.clip);
  question.max_contacts = settings.max_contacts;
  question.clearance = settings.clearance;
  question.budget = settings.budget;
  question.substeps = settings.substeps;
  question.pairs = settings.lists_triangles;
  question.contacts = settings.describes_contacts;
  question.inside = settings.asks_inside;
  question.self = settings.self;
  question.ignore = settings.ignore;
  question.exclude = models.exclude;
  question.no_unskinned = models.no_unskinned;
  question.renormalise = models.renormalise;
  for (const scenes::Character& character : scene.characters)
    question.skinning[character.name] = scenes::name_of(models.skinning_of(character));
  return question;
}

}  // namespace pelt::tools::check

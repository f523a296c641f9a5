#include "tools/pelt/check/check_question.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

/// Null if bodies are not tested against themselves.
ordered_json self_json(const SelfChoice& self) {
  if (!self.asks_self()) return nullptr;
  const auto kept_or_dropped = [](bool drops) { return drops ? "drop" : "keep"; };
  ordered_json object = {{"only", !self.asks_pairs()},
                         {"rings", self.rules.rings},
                         {"at_rest", kept_or_dropped(self.rules.drops_at_rest)},
                         {"always", "keep"},
                         {"near_joints", kept_or_dropped(self.rules.drops_near_joints)}};
  if (self.rules.always) object["always"] = *self.rules.always;
  return object;
}

/// The kind of skinning of all models, or of each model if they differ.
ordered_json skinning_json(const std::map<std::string, std::string>& skinning) {
  if (skinning.empty()) return scenes::name_of(Skinning::linear);
  const std::string& first = skinning.begin()->second;
  const bool differ = std::any_of(skinning.begin(), skinning.end(),
                                  [&](const auto& model) { return model.second != first; });
  return differ ? ordered_json(skinning) : ordered_json(first);
}

}  // namespace

nlohmann::ordered_json question_json(const CheckQuestion& question) {
  nlohmann::ordered_json json = {
      {"method", question.method},
      {"by", question.by},
      {"frames", {question.frames.begin, question.frames.end, question.frames.stride}},
      {"fps", question.fps},
      {"max_contacts", nullptr},
      {"pairs", question.pairs},
      {"contacts", question.contacts},
      {"inside", question.inside},
      {"clearance", nullptr},
      {"between", nullptr},
      {"self", self_json(question.self)},
      {"ignore", nlohmann::ordered_json::array()},
      {"exclude", question.exclude},
      {"no_unskinned", question.no_unskinned},
      {"renormalise", question.renormalise},
      {"skinning", skinning_json(question.skinning)}};
  for (const scenes::NamePair& pair : question.ignore) json["ignore"].push_back({pair.a, pair.b});
  if (!question.clips.empty()) json["clips"] = question.clips;
  if (question.clearance) json["clearance"] = *question.clearance;
  if (question.budget) json["budget"] = *question.budget;
  if (question.substeps) json["between"] = {{"substeps", *question.substeps}};
  if (question.max_contacts) json["max_contacts"] = *question.max_contacts;
  return json;
}

}  // namespace pelt::tools::check

#include "tools/pelt/check_scene.hpp"

#include "asset/message.hpp"
#include "tools/pelt/scene_glb.hpp"
#include "tools/pelt/summary.hpp"

#include <fstream>
#include <iostream>

namespace pelt::tools {
namespace {

/// --jsonl's file, standard output, or nothing.
class JsonlOutput {
 public:
  Result<void> open(const std::string& path, TriangleLists lists) {
    path_ = path;
    if (path.empty()) return {};
    const bool standard = path == kStandardOutput;
    if (!standard) file_.open(path, std::ios::binary);
    stream_ = standard ? &std::cout : &file_;
    if (!*stream_) return unwritable(path_);
    writer_.emplace(*stream_, lists);
    return {};
  }

  /// Null where there is nothing to write to.
  JsonlWriter* writer() { return writer_ ? &*writer_ : nullptr; }

  Result<void> close() {
    if (stream_ == nullptr) return {};
    stream_->flush();
    return *stream_ ? Result<void>() : unwritable(path_);
  }

 private:
  std::string path_;
  std::ofstream file_;
  std::ostream* stream_ = nullptr;
  std::optional<JsonlWriter> writer_;
};

Result<void> write_contacts_glb(const std::string& path, const scenes::Scene& scene,
                                std::span<const Collider> colliders, const CheckReport::Kept& kept,
                                const ModelArguments& models) {
  const auto posed = pose_instances(scene, kept.frame, models);
  if (!posed) return posed.error();
  return write_file(path, contacts_glb(*posed, touching_triangles(*posed, colliders, kept.found)));
}

void write_header(const scenes::Scene& scene, std::span<const Collider> colliders,
                  const CheckSettings& settings, JsonlWriter& jsonl) {
  const bool parts = settings.granularity == Granularity::part;
  jsonl.header(scene, colliders,
               {std::string(bench::name_of(settings.method)), parts ? "part" : "instance",
                settings.frames, settings.max_contacts});
}

}  // namespace

Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                const ModelArguments& models, const CheckOutputs& outputs,
                                std::ostream& words) {
  const auto colliders = make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  JsonlOutput jsonl;
  if (const auto opened = jsonl.open(outputs.jsonl, outputs.lists); !opened) return opened.error();
  if (jsonl.writer() != nullptr) write_header(scene, *colliders, settings, *jsonl.writer());
  TouchTally tally(scene, *colliders);
  Result<CheckReport> report = run_check(scene, *colliders, settings, tally, jsonl.writer());
  if (!report) return asset::prefixed(scene.name, report.error());
  if (const auto closed = jsonl.close(); !closed) return closed.error();
  if (!outputs.glb.empty()) {
    const auto written = write_contacts_glb(outputs.glb, scene, *colliders, report->kept, models);
    if (!written) return written.error();
  }
  print_summary(scene, *colliders, settings, *report, tally, words);
  return report;
}

}  // namespace pelt::tools

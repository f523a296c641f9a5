#include "tools/pelt/prepared/prepared_file.hpp"

#include <pelt/model.hpp>

#include "asset/file_bytes.hpp"
#include "base/hash.hpp"
#include "model/prepared_format.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace pelt::tools::prepared {
namespace {

using nlohmann::ordered_json;

std::uint64_t hash_of(std::span<const std::byte> file) {
  detail::Fnv1a64 hash;
  hash.add_bytes(file);
  return hash.value();
}

std::uint32_t most_influences(const detail::Tree& tree) {
  std::uint32_t most = 0;
  for (std::size_t p = 0; p < tree.rest_positions.size(); ++p)
    most = std::max(most, tree.influence_begin[p + 1] - tree.influence_begin[p]);
  return most;
}

ordered_json describe(const std::string& path, std::span<const std::byte> file,
                      const SkinnedModel& model) {
  const detail::Tree& tree = model.detail().tree;
  const BuildReport& report = model.report();
  return {{"format", "pelt-info"},
          {"version", 1},
          {"model", path},
          {"hash", text::hex16(hash_of(file))},
          {"prepared", {{"version", detail::kPreparedVersion}, {"bytes", file.size()}}},
          {"vertices", model.vertex_count()},
          {"triangles", model.triangle_count()},
          {"degenerate_triangles", report.degenerate_triangles},
          {"influences_per_vertex", most_influences(tree)},
          {"renormalised_vertices", report.renormalised_vertices},
          {"merged_influences", report.merged_influences},
          {"joint_count", model.joint_count()},
          {"nodes", tree.nodes.size()},
          {"clusters", tree.clusters.size()}};
}

void print_line(const char* label, const std::string& text) {
  std::cout << std::left << std::setw(11) << label << text << '\n';
}

void print(const ordered_json& info) {
  const auto number = [&](const char* key) {
    return text::with_commas(info[key].get<std::uint64_t>());
  };
  const ordered_json& prepared = info["prepared"];
  print_line("model", text::printable(info["model"].get<std::string>()));
  print_line("prepared", text::with_commas(prepared["bytes"].get<std::uint64_t>()) +
                             " bytes, version " + prepared["version"].dump() + " of the format");
  print_line("vertices", number("vertices"));
  print_line("triangles",
             number("triangles") + ", " + number("degenerate_triangles") + " degenerate at rest");
  print_line("influences", "up to " + number("influences_per_vertex") + " for each vertex");
  print_line("weights", number("renormalised_vertices") + " vertices renormalised, " +
                            number("merged_influences") + " influences merged");
  print_line("joints", number("joint_count"));
  print_line("tree", number("nodes") + " nodes, " + number("clusters") + " clusters of triangles");
}

}  // namespace

Result<SkinnedModel> load_named_model(const std::string& name, std::span<const std::byte> file) {
  Result<SkinnedModel> model = asset::within_memory(name, [&] { return load_model(file); });
  if (model || model.error().code == ErrorCode::unreadable_file) return model;
  return text::prefixed(name, model.error());
}

bool is_prepared_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;  // a pipe is read only once
  std::array<char, 8> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return is_prepared_model(std::as_bytes(std::span(begin)));
}

Result<void> print_prepared_info(const std::string& path, InfoStyle style) {
  const Result<std::vector<std::byte>> file = asset::read_file(path);
  if (!file) return file.error();
  const Result<SkinnedModel> model = load_named_model(path, *file);
  if (!model) return model.error();
  const ordered_json info = describe(path, *file, *model);
  if (style == InfoStyle::json)
    std::cout << text::json_text(info, 2) << '\n';
  else
    print(info);
  return {};
}

}  // namespace pelt::tools::prepared

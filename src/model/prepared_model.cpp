#include <pelt/model.hpp>

#include "base/problem.hpp"
#include "model/check_tree.hpp"
#include "model/prepared_format.hpp"
#include "model/triangle_places.hpp"
#include "model/weld.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

namespace pelt {
namespace {

using detail::PreparedHeader;

PreparedHeader header_of(const detail::Model& model) {
  PreparedHeader header;
  header.joint_count = model.tree.joint_count;
  header.rest_extent = model.tree.rest_extent;
  header.dual_influences = model.tree.dual_influences;
  header.report = model.report;
  std::size_t next = 0;
  detail::each_array(model, [&](const auto& array) {
    header.counts[next++] = static_cast<std::uint32_t>(array.size());
  });
  header.file_size = detail::file_size_of(header.counts);
  return header;
}

void put(const PreparedHeader& header, std::vector<std::byte>& file) {
  std::memcpy(file.data(), &header, sizeof header);
}

}  // namespace

std::vector<std::byte> save_model(const SkinnedModel& model) {
  PreparedHeader header = header_of(model.detail());
  std::vector<std::byte> file(static_cast<std::size_t>(header.file_size));
  put(header, file);
  std::size_t end = sizeof header;
  detail::each_array(model.detail(), [&]<typename T>(const std::vector<T>& array) {
    const auto begin = static_cast<std::size_t>(detail::next_array(end));
    end = begin + array.size() * sizeof(T);
    if (!array.empty()) std::memcpy(&file[begin], array.data(), end - begin);
  });
  header.checksum = detail::checksum_of(file);
  put(header, file);
  return file;
}

namespace {

using detail::PreparedHeader;
using detail::Problem;
using detail::problem;

Error refusal(ErrorCode code, const Problem& found) {
  return {code, "the prepared model " + found + ": run `pelt prepare` or save_model() again"};
}

Error malformed(const Problem& found) { return refusal(ErrorCode::malformed_file, found); }

/// Reads as much of the header as the file contains.
PreparedHeader read_header(std::span<const std::byte> file) {
  PreparedHeader header;
  std::memcpy(&header, file.data(), std::min(file.size(), sizeof header));
  return header;
}

/// Detects files of another machine or another version, whose headers may have another size.
Problem find_foreign(const PreparedHeader& header) {
  if (header.byte_order == detail::kForeignMark)
    return problem("was prepared on a machine with the other byte order");
  if (header.version != detail::kPreparedVersion)
    return problem(
        "was made by another version of Pelt (version %u of the format, this one reads version %u)",
        header.version, detail::kPreparedVersion);
  return {};
}

/// Later checks rely on the earlier ones.
Problem find_damage(std::span<const std::byte> file, const PreparedHeader& header) {
  if (file.size() < sizeof header)
    return problem("has %zu bytes, less than its header", file.size());
  if (header.byte_order != detail::kByteOrderMark)
    return problem("has the byte order mark %08x, expected %08x", header.byte_order,
                   detail::kByteOrderMark);
  if (header.file_size != file.size())
    return problem("has %zu bytes, but its header says %llu", file.size(),
                   static_cast<unsigned long long>(header.file_size));
  const std::uint64_t sum = detail::checksum_of(file);
  if (header.checksum != sum)
    return problem("is damaged: its bytes have the checksum %016llx, but its header says %016llx",
                   static_cast<unsigned long long>(sum),
                   static_cast<unsigned long long>(header.checksum));
  const std::uint64_t needed = detail::file_size_of(header.counts);
  if (needed != file.size())
    return problem("has %zu bytes, but its arrays take %llu", file.size(),
                   static_cast<unsigned long long>(needed));
  return {};
}

/// Precondition: find_damage found nothing.
detail::Model read_model(std::span<const std::byte> file, const PreparedHeader& header) {
  detail::Model model;
  model.tree.joint_count = header.joint_count;
  model.tree.rest_extent = header.rest_extent;
  model.tree.dual_influences = header.dual_influences;
  model.report = header.report;
  std::size_t next = 0, end = sizeof header;
  detail::each_array(model, [&]<typename T>(std::vector<T>& array) {
    array.resize(header.counts[next++]);
    const auto begin = static_cast<std::size_t>(detail::next_array(end));
    end = begin + array.size() * sizeof(T);
    if (!array.empty()) std::memcpy(array.data(), &file[begin], end - begin);
  });
  return model;
}

}  // namespace

bool is_prepared_model(std::span<const std::byte> file) {
  const auto& magic = detail::kPreparedMagic;
  return file.size() >= magic.size() && std::memcmp(file.data(), magic.data(), magic.size()) == 0;
}

Result<SkinnedModel> load_model(std::span<const std::byte> file) {
  if (!is_prepared_model(file))
    return Error{
        ErrorCode::malformed_file,
        "the file is not a prepared model: create one with `pelt prepare` or save_model()"};
  const PreparedHeader header = read_header(file);
  if (const Problem found = find_foreign(header); !found.empty())
    return refusal(ErrorCode::unsupported, found);
  if (const Problem found = find_damage(file, header); !found.empty()) return malformed(found);

  auto model = std::make_shared<detail::Model>(read_model(file, header));
  Problem found = detail::check_structure(model->tree);
  if (found.empty()) found = detail::check_node_bounds(model->bounds, model->tree);
  if (!found.empty()) return malformed("is malformed, " + found);
  index_triangles(model->tree);
  index_triangles_below(model->tree);
  index_welded_vertices(model->tree);
  find_offset_caps(model->tree, model->bounds);
  return SkinnedModel(std::move(model));
}

}  // namespace pelt

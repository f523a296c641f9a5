#include <pelt/prepared.hpp>

#include "model/prepared_format.hpp"

#include <cstring>

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

}  // namespace pelt

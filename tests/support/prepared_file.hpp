#pragma once

/// Deliberately broken prepared models.

#include "model/prepared_format.hpp"

#include <pelt/model.hpp>

#include <cstring>
#include <vector>

namespace pelt::test {

using Bytes = std::vector<std::byte>;

inline detail::PreparedHeader header_of(const Bytes& file) {
  detail::PreparedHeader header;
  std::memcpy(&header, file.data(), sizeof header);
  return header;
}

inline void put_header(const detail::PreparedHeader& header, Bytes& file) {
  std::memcpy(file.data(), &header, sizeof header);
}

/// Corrects checksum and size, as a forger would. Does nothing if the file is shorter than the
/// header.
inline void mend(Bytes& file) {
  if (file.size() < sizeof(detail::PreparedHeader)) return;
  detail::PreparedHeader header = header_of(file);
  header.file_size = file.size();
  header.checksum = detail::checksum_of(file);
  put_header(header, file);
}

/// The offset of each array of `model` in its file, and the end of the last array.
inline std::vector<std::size_t> array_places(const detail::Model& model) {
  std::vector<std::size_t> places;
  std::size_t end = sizeof(detail::PreparedHeader);
  detail::each_array(model, [&]<typename T>(const std::vector<T>& array) {
    places.push_back(static_cast<std::size_t>(detail::next_array(end)));
    end = places.back() + array.size() * sizeof(T);
  });
  places.push_back(end);
  return places;
}

}  // namespace pelt::test

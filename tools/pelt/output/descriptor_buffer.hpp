#pragma once

#include <cstddef>
#include <streambuf>
#include <vector>

namespace pelt::tools::output {

/// A stream buffer that writes to a file descriptor and stores the first error.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer() = default;
  DescriptorBuffer(const DescriptorBuffer&) = delete;
  DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;
  ~DescriptorBuffer() override;  ///< closes the descriptor; discards buffered bytes

  /// Takes ownership of a descriptor.
  void open(int descriptor);

  /// Writes the rest and closes the descriptor. Returns false if anything was lost since `open`.
  bool close();

  /// The errno of the first failure; 0 if there was none.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  int sync() override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;

 private:
  bool write_all(const char* text, std::size_t count);
  bool write_buffered();

  int descriptor_ = -1;
  int error_ = 0;
  std::vector<char> buffer_;
};

}  // namespace pelt::tools::output

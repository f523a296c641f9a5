#pragma once

#include <cstddef>
#include <streambuf>
#include <vector>

namespace pelt::tools::output {

/// The buffer of a stream that writes to a file descriptor and remembers why it could not.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer() = default;
  DescriptorBuffer(const DescriptorBuffer&) = delete;
  DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;
  ~DescriptorBuffer() override;  ///< closes the descriptor; what is still in the buffer is lost

  /// Takes a descriptor over.
  void open(int descriptor);

  /// Writes the rest and closes the descriptor. False if anything has been lost since `open`.
  bool close();

  /// The errno of the first failure; 0: there was none.
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

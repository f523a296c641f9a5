#include "tools/pelt/output/descriptor_buffer.hpp"

#include <unistd.h>

#include <cerrno>

namespace pelt::tools::output {
namespace {

constexpr std::size_t kBufferSize = 1 << 16;

}  // namespace

DescriptorBuffer::~DescriptorBuffer() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void DescriptorBuffer::open(int descriptor) {
  descriptor_ = descriptor;
  buffer_.resize(kBufferSize);
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

bool DescriptorBuffer::close() {
  const bool written = write_buffered();
  const int closed = ::close(descriptor_);
  if (closed != 0 && error_ == 0) error_ = errno;
  descriptor_ = -1;
  return written && closed == 0;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
  if (!write_buffered()) return traits_type::eof();
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  return sputc(traits_type::to_char_type(c));
}

int DescriptorBuffer::sync() { return write_buffered() ? 0 : -1; }

std::streamsize DescriptorBuffer::xsputn(const char* text, std::streamsize count) {
  if (count < epptr() - pptr()) return std::streambuf::xsputn(text, count);
  return write_buffered() && write_all(text, static_cast<std::size_t>(count)) ? count : 0;
}

bool DescriptorBuffer::write_all(const char* text, std::size_t count) {
  while (count > 0 && error_ == 0) {
    const ssize_t written = ::write(descriptor_, text, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = errno;
    } else {
      text += written;
      count -= static_cast<std::size_t>(written);
    }
  }
  return error_ == 0;
}

bool DescriptorBuffer::write_buffered() {
  const bool written = write_all(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return written;
}

}  // namespace pelt::tools::output

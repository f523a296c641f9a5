#include "base/arena.hpp"

#include <algorithm>
#include <new>

namespace pelt::detail {
namespace {

constexpr std::size_t kFirstBlock = std::size_t{1} << 13, kLargestBlock = std::size_t{1} << 18;

}  // namespace

void Arena::Release::operator()(std::byte* memory) const {
  ::operator delete (memory, std::align_val_t{kAlignment});
}

std::size_t Arena::capacity() const {
  std::size_t bytes = 0;
  for (const Block& block : blocks_) bytes += block.size;
  return bytes;
}

std::size_t Arena::used() const {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < block_; ++i) bytes += blocks_[i].size;
  return bytes - left_ - unused_;
}

std::size_t Arena::room() const {
  std::size_t most = 0;
  for (const Block& block : blocks_) most = std::max(most, block.size);
  return most;
}

void Arena::reserve(std::size_t bytes) {
  if (bytes <= room()) return;
  add_block(bytes);
  replaced_ = blocks_.size() - 1;
}

/// Blocks grow with the capacity, so that there are few of them, up to a size at which the unused
/// end of a block does not matter.
void Arena::next_block(std::size_t bytes) {
  unused_ += left_;
  while (block_ < blocks_.size() && blocks_[block_].size < bytes) unused_ += blocks_[block_++].size;
  if (block_ == blocks_.size())
    add_block(std::max(bytes, std::clamp(capacity(), kFirstBlock, kLargestBlock)));
  next_ = blocks_[block_].memory.get();
  left_ = blocks_[block_].size;
  ++block_;
}

void Arena::add_block(std::size_t bytes) {
  void* memory = ::operator new (bytes, std::align_val_t{kAlignment});
  blocks_.push_back({std::unique_ptr<std::byte, Release>(static_cast<std::byte*>(memory)), bytes});
}

void Arena::release_replaced() {
  blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(replaced_));
  replaced_ = 0;
}

}  // namespace pelt::detail

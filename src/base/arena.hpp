#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace pelt::detail {

/// Memory that is handed out piece by piece and taken back all at once. Keeps what it has got, so
/// that a user who needs no more than before allocates nothing.
class Arena {
 public:
  /// Every piece begins on a multiple of this.
  static constexpr std::size_t kAlignment = 64;

  /// What a piece of `bytes` takes.
  static constexpr std::size_t size_of_piece(std::size_t bytes) {
    return (bytes + kAlignment - 1) / kAlignment * kAlignment;
  }

  /// Uninitialised memory, valid until `clear`.
  std::byte* allocate(std::size_t bytes) {
    bytes = size_of_piece(bytes);
    if (bytes > left_) next_block(bytes);
    std::byte* piece = next_;
    next_ += bytes;
    left_ -= bytes;
    return piece;
  }

  /// Room for one `T` whose constructor has nothing to do.
  template <typename T>
  T* allocate() {
    static_assert(alignof(T) <= kAlignment);
    return new (allocate(sizeof(T))) T;
  }

  /// Takes all pieces back.
  void clear() {
    block_ = 0;
    next_ = nullptr;
    left_ = 0;
  }

  /// All memory held, handed out or not.
  std::size_t capacity() const;

  /// Memory handed out since `clear`, with what is lost between the pieces.
  std::size_t used() const;

  /// Makes the capacity `bytes` at least. Pieces leave the ends of blocks unused, so that those of
  /// `bytes` together may take a little more, but for an arena that had no memory before: its first
  /// block has room for just these.
  void reserve(std::size_t bytes);

 private:
  struct Release {
    void operator()(std::byte* memory) const;
  };

  struct Block {
    std::unique_ptr<std::byte, Release> memory;
    std::size_t size = 0;
  };

  void next_block(std::size_t bytes);
  void add_block(std::size_t bytes);

  std::vector<Block> blocks_;
  std::size_t block_ = 0;  // blocks before this one are in use
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace pelt::detail

/// Calls the decoder of EXT_meshopt_compression that was passed in from JavaScript.

#include "asset/meshopt.hpp"
#include "text/message.hpp"

#include <emscripten.h>

#include <array>
#include <string>

namespace pelt::asset {
namespace {

constexpr const char* kNone =
    "is compressed (EXT_meshopt_compression): give the option meshoptDecode, which is "
    "MeshoptDecoder.decodeGltfBuffer of the npm package meshoptimizer";

const char* name_of(MeshoptMode mode) {
  switch (mode) {
    case MeshoptMode::attributes:
      return "ATTRIBUTES";
    case MeshoptMode::triangles:
      return "TRIANGLES";
    case MeshoptMode::indices:
      return "INDICES";
  }
  return "";
}

const char* name_of(MeshoptFilter filter) {
  switch (filter) {
    case MeshoptFilter::none:
    case MeshoptFilter::quaternion:  // Pelt's own
      return "NONE";
    case MeshoptFilter::octahedral:
      return "OCTAHEDRAL";
    case MeshoptFilter::exponential:
      return "EXPONENTIAL";
  }
  return "";
}

}  // namespace

// Returns 0 if there is no decoder. Otherwise `problem` is the decoder's error message
// (`withDecoder`, files.mjs), or empty.
EM_JS(int, call_meshopt_decode,
      (void* target, unsigned count, unsigned stride, const void* source, unsigned size,
       const char* mode, const char* filter, char* problem, unsigned room),
      {
        if (!Module["meshoptDecode"]) return 0;
        const words = Module["meshoptDecode"](HEAPU8.subarray(target, target + count * stride),
                                              count, stride, HEAPU8.subarray(source, source + size),
                                              UTF8ToString(mode), UTF8ToString(filter));
        stringToUTF8(words, problem, room);
        return 1;
      })

Result<void> decompress(const GltfMeshopt& meshopt, std::span<const std::byte> compressed,
                        std::span<std::byte> out) {
  std::array<char, 200> problem = {};
  const int there = call_meshopt_decode(
      out.data(), static_cast<unsigned>(meshopt.count), static_cast<unsigned>(meshopt.stride),
      compressed.data(), static_cast<unsigned>(compressed.size()), name_of(meshopt.mode),
      name_of(meshopt.filter), problem.data(), static_cast<unsigned>(problem.size()));
  if (there == 0) return text::unsupported(kNone);
  if (problem[0] == '\0') return {};
  return Error{ErrorCode::invalid_argument,
               std::string("the compressed bytes are damaged, or meshoptDecode is not what it "
                           "should be or not ready; it says: ") +
                   problem.data()};
}

}  // namespace pelt::asset

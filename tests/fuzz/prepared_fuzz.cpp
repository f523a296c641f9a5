/// The fuzz target of prepared models: bytes -> load_model, and what a program does with a model.
/// Corrects the checksum, so that it does not refuse all other damage.

#include "fuzz/goal.hpp"
#include "support/prepared_file.hpp"
#include "support/use_model.hpp"

namespace pelt::test {
namespace {

Goal model_used("load_model: a model that can be posed"), model_refused("load_model: an error");

void use_prepared(std::span<const std::byte> bytes) {
  constexpr std::uint32_t kMostTriangles = 20000;  // so that fuzzing stays quick
  Bytes file(bytes.begin(), bytes.end());
  mend(file);
  const Result<SkinnedModel> model = load_model(file);
  model_refused.reach(!model);
  if (model && model->triangle_count() <= kMostTriangles) model_used.reach(use_model(*model));
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::use_prepared(std::as_bytes(std::span(data, size)));
  return 0;
}

/// The fuzz target of prepared models: bytes -> load_model, then queries. Corrects the checksum
/// first, so that it does not hide the later checks.

#include "support/prepared_file.hpp"
#include "support/use_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint32_t kMaxTriangles = 20000;  // limits the time per input
  const auto bytes = std::as_bytes(std::span(data, size));
  pelt::test::Bytes file(bytes.begin(), bytes.end());
  pelt::test::mend(file);
  const pelt::Result<pelt::SkinnedModel> model = pelt::load_model(file);
  if (model && model->triangle_count() <= kMaxTriangles) pelt::test::use_model(*model);
  return 0;
}

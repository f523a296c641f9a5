#include "bindings/wasm/engine/moving_columns.hpp"

#include "bindings/wasm/engine/answer.hpp"

#include <span>
#include <vector>

namespace pelt::wasm {
namespace {

/// Same order as in motion.mjs.
enum class MovingColumn : std::uint32_t { times, at_start, features };

struct MovingColumns {
  std::vector<float> times;
  std::vector<std::uint8_t> at_start;
  std::vector<std::uint8_t> features;  // [N][4] kind and number of a, then of b
};

MovingColumns& columns() {
  static MovingColumns columns;
  return columns;
}

}  // namespace

void clear_moving_columns() { columns() = {}; }

void add_to_moving_columns(const MovingContact& moving) {
  columns().times.push_back(moving.time);
  columns().at_start.push_back(moving.at_start ? 1 : 0);
  for (const Feature& feature : {moving.a, moving.b}) {
    columns().features.push_back(moving.at_start ? 0 : static_cast<std::uint8_t>(feature.kind));
    columns().features.push_back(moving.at_start ? 0 : feature.number);
  }
}

PELT_EXPORT void pelt_moving_column(MovingColumn column) {
  switch (column) {
    case MovingColumn::times:
      return answer_data<float>(columns().times);
    case MovingColumn::at_start:
      return answer_data<std::uint8_t>(columns().at_start);
    case MovingColumn::features:
      return answer_data<std::uint8_t>(columns().features);
  }
}

}  // namespace pelt::wasm

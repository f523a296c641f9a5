#include "tools/pelt/arguments/position_argument.hpp"

#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

#include <cmath>

namespace pelt::tools::arguments {

Result<std::array<double, 3>> parse_position(const std::string& option, const std::string& text) {
  std::array<double, 3> position;
  const std::vector<std::string_view> fields = output::split(text, ',');
  bool good = fields.size() == position.size();
  for (std::size_t i = 0; good && i < position.size(); ++i) {
    good = output::parse_number(fields[i], position[i]) && std::fabs(position[i]) <= 1e12;
  }
  if (good) return position;
  return output::bad_argument(option, asset::quoted(text) + " is not a position",
                              "give x,y,z as in " + option + " 0.5,0,-1");
}

Result<Vec3> parse_point(const std::string& option, const std::string& text) {
  const Result<std::array<double, 3>> p = parse_position(option, text);
  if (!p) return p.error();
  return Vec3{static_cast<float>((*p)[0]), static_cast<float>((*p)[1]),
              static_cast<float>((*p)[2])};
}

}  // namespace pelt::tools::arguments

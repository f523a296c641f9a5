#include "asset/parsed_json.hpp"

#include "asset/budget.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace pelt::asset {

namespace {

using nlohmann::json;

/// Size of a text, estimated without parsing: the depth of the deepest bracket, and an upper bound
/// of the number of values. Brackets inside strings do not count.
struct TextSize {
  std::size_t depth = 0, values = 1;
};

TextSize measure(std::string_view text) {
  TextSize size;
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') ++i;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '[' || c == '{') size.depth = std::max(size.depth, ++depth);
    if (c == '[' || c == '{' || c == ',') ++size.values;
    if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return size;
}

/// Returns nlohmann's message without its error number, truncated because it may quote the file.
std::string plain_words(const json::exception& error) {
  const std::string_view words = error.what();
  const std::size_t bracket = words.find("] ");
  return std::string(words.substr(bracket == words.npos ? 0 : bracket + 2).substr(0, 200));
}

/// Recursion is limited by the depth that `parse_json` allows.
void take_apart(json& value) {
  if (!value.is_structured()) return;
  for (json& element : value) take_apart(element);
  value.clear();
}

/// Receives the events of nlohmann's parser. Builds the tree in a value of the caller, because the
/// tree of json::parse is not taken apart if memory runs out.
class TreeBuilder {
 public:
  explicit TreeBuilder(json& root) : root_(root) {}

  const std::string& problem() const { return problem_; }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(json::binary_t&) { return false; }  // not part of JSON texts
  bool start_object(std::size_t) { return open(json::object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(json::array()); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    member_ = &open_.back()->get_ref<json::object_t&>()[std::move(name)];
    take_apart(*member_);  // the value of an equal key
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const json::exception& error) {
    problem_ = plain_words(error);
    return false;
  }

 private:
  json& place(json&& value) {
    if (open_.empty()) return root_ = std::move(value);
    if (open_.back()->is_object()) return *member_ = std::move(value);
    return open_.back()->get_ref<json::array_t&>().emplace_back(std::move(value));
  }

  bool add(json value) {
    place(std::move(value));
    return true;
  }

  bool open(json value) {
    open_.push_back(&place(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  json& root_;
  std::vector<json*> open_;  // arrays and objects, from the root
  json* member_ = nullptr;   // of the innermost object, if that is open
  std::string problem_;
};

}  // namespace

void JsonEnd::operator()(json* value) const {
  take_apart(*value);
  delete value;
}

Result<ParsedJson> parse_json(std::string_view text) {
  constexpr std::size_t kDeepest = 64;
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    return text::malformed("the JSON text is empty");
  const TextSize size = measure(text);
  if (size.depth > kDeepest) {
    return text::malformed("the JSON text is nested more than " + std::to_string(kDeepest) +
                           " deep");
  }
  if (size.values > Budget::kMaxValues) {
    return text::malformed("the JSON text has more than " + std::to_string(Budget::kMaxValues) +
                           " values");
  }
  ParsedJson parsed(new json);
  TreeBuilder tree(*parsed);
  if (!json::sax_parse(text, &tree))
    return text::malformed("the JSON text is invalid: " + tree.problem());
  return parsed;
}

}  // namespace pelt::asset

#include "tools/pelt/page/http_request.hpp"

#include <algorithm>

namespace pelt::tools::page {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

/// Removes the text before `separator`, and the separator, from `rest`; nullopt if there is none.
std::optional<std::string_view> cut(std::string_view& rest, std::string_view separator) {
  const std::size_t at = rest.find(separator);
  if (at == rest.npos) return std::nullopt;
  const std::string_view text = rest.substr(0, at);
  rest.remove_prefix(at + separator.size());
  return text;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

bool parse_request_line(std::string_view line, HttpRequest& request) {
  const auto method = cut(line, " ");
  const auto target = cut(line, " ");
  if (!method || !target || method->empty() || target->empty()) return false;
  request.method = *method;
  request.target = *target;
  return line == "HTTP/1.1" || line == "HTTP/1.0";
}

/// A second Host header invalidates the request.
bool parse_header(std::string_view line, bool& has_host, HttpRequest& request) {
  const auto name = cut(line, ":");
  if (!name || name->empty() || name->find_first_of(" \t") != name->npos) return false;
  const std::string key = in_lower_case(*name);
  const std::string_view value = trimmed(line);
  if (key == "host") {
    request.host = has_host ? "" : std::string(value);
    has_host = true;
  }
  if (key == "transfer-encoding" || (key == "content-length" && value != "0"))
    request.has_body = true;
  return true;
}

}  // namespace

std::size_t end_of_head(std::string_view text) {
  const std::size_t at = text.find("\r\n\r\n");
  return at == text.npos ? at : at + 4;
}

std::optional<HttpRequest> parse_request(std::string_view head) {
  HttpRequest request;
  const auto first = cut(head, kLineEnd);
  if (!first || !parse_request_line(*first, request)) return std::nullopt;
  bool has_host = false;
  for (auto line = cut(head, kLineEnd); line && !line->empty(); line = cut(head, kLineEnd)) {
    if (!parse_header(*line, has_host, request)) return std::nullopt;
  }
  return request;
}

}  // namespace pelt::tools::page

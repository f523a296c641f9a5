#pragma once

/// The head of an HTTP request, as much of it as a server of one page needs.

#include <optional>
#include <string>
#include <string_view>

namespace pelt::tools::page {

struct HttpRequest {
  std::string method, target;
  std::string host;  ///< "" unless there is exactly one Host header
  bool has_body = false;
};

/// Where a request's head ends, its empty line included; npos if `text` has no whole head.
std::size_t end_of_head(std::string_view text);

/// Parses a whole head (RFC 9112, sections 3 and 5); nothing if it is malformed.
std::optional<HttpRequest> parse_request(std::string_view head);

}  // namespace pelt::tools::page

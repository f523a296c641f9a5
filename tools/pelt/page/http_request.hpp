#pragma once

/// The head of an HTTP request, as far as a server of one page needs it.

#include <optional>
#include <string>
#include <string_view>

namespace pelt::tools::page {

struct HttpRequest {
  std::string method, target;
  std::string host;  ///< "" unless there is exactly one Host header
  bool has_body = false;
};

/// The end of a request's head, including its empty line; npos if `text` has no complete head.
std::size_t end_of_head(std::string_view text);

/// Parses a complete head (RFC 9112, sections 3 and 5); nullopt if it is malformed.
std::optional<HttpRequest> parse_request(std::string_view head);

}  // namespace pelt::tools::page

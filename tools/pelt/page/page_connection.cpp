#include "tools/pelt/page/page_connection.hpp"

#include "tools/pelt/page/http_request.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace pelt::tools::page {
namespace {

using std::chrono::seconds;

/// Browsers send requests of about 1 KB.
constexpr std::size_t kLongestRequest = 16 << 10;
constexpr seconds kRequestTime(10);

/// Clients that read the answer more slowly than this are disconnected; a page of 3 MB may take 4
/// minutes.
constexpr seconds kAnswerTime(30);
constexpr std::size_t kBytesPerSecond = 16 << 10;

/// Time for reading the last bytes of the answer: closing a socket with unread input would lose
/// them.
constexpr seconds kDrainTime(1);

constexpr const char* kPlain = "Content-Type: text/plain\r\n";
constexpr const char* kHtml =
    "Content-Type: text/html; charset=utf-8\r\nCache-Control: no-store\r\n";

/// Other host names that resolve to this machine would let their pages read the scene (DNS
/// rebinding).
bool is_own_name(std::string_view host, int port) {
  const std::string number = std::to_string(port);
  return host == "127.0.0.1:" + number || host == "localhost:" + number;
}

bool is_page(std::string_view target) { return target.substr(0, target.find('?')) == "/"; }

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

PageConnection::PageConnection(int socket, const Site& site)
    : socket_(socket), site_(site), begin_(Clock::now()), deadline_(begin_ + kRequestTime) {}

PageConnection::~PageConnection() { close(socket_); }

short PageConnection::events() const { return state_ == State::answering ? POLLOUT : POLLIN; }

bool PageConnection::advance() {
  if (state_ == State::reading && !read_request()) return false;
  if (state_ == State::answering && !write_answer()) return false;
  return state_ != State::draining || drain();
}

bool PageConnection::read_request() {
  std::array<char, 4096> bytes;
  const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
  if (count <= 0) return count < 0 && would_wait();
  request_.append(bytes.data(), static_cast<std::size_t>(count));
  const std::size_t end = end_of_head(request_);
  if (end != std::string::npos && end <= kLongestRequest)
    answer(std::string_view(request_).substr(0, end));
  else if (request_.size() > kLongestRequest)
    begin_answer("431 Request Header Fields Too Large", "the request is too long\n", kPlain);
  return true;
}

void PageConnection::answer(std::string_view head) {
  const auto request = parse_request(head);
  if (!request) return begin_answer("400 Bad Request", "malformed request\n", kPlain);
  if (!is_own_name(request->host, site_.port))
    return begin_answer("403 Forbidden", "not the name of this server\n", kPlain);
  if (request->has_body)
    return begin_answer("413 Content Too Large", "requests have no body here\n", kPlain);
  if (request->method != "GET" && request->method != "HEAD")
    return begin_answer("405 Method Not Allowed", "only GET and HEAD\n",
                        "Content-Type: text/plain\r\nAllow: GET, HEAD\r\n");
  if (!is_page(request->target)) return begin_answer("404 Not Found", "no such page\n", kPlain);
  // Ignores Range headers, as every server may (RFC 9110, section 14.2).
  begin_answer("200 OK", site_.page, kHtml);
  if (request->method == "HEAD") body_ = {};
}

void PageConnection::begin_answer(const char* status, std::string_view body, const char* more) {
  head_ = std::string("HTTP/1.1 ") + status + "\r\n" + more +
          "Content-Length: " + std::to_string(body.size()) +
          "\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n";
  body_ = body;
  state_ = State::answering;
  begin_ = Clock::now();
  deadline_ = begin_ + kAnswerTime;
}

bool PageConnection::write_answer() {
  while (sent_ < head_.size() + body_.size()) {
    const std::string_view rest = sent_ < head_.size() ? std::string_view(head_).substr(sent_)
                                                       : body_.substr(sent_ - head_.size());
    const ssize_t count = send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0) return would_wait();
    sent_ += static_cast<std::size_t>(count);
    deadline_ = begin_ + kAnswerTime + seconds(sent_ / kBytesPerSecond);
  }
  shutdown(socket_, SHUT_WR);
  state_ = State::draining;
  deadline_ = Clock::now() + kDrainTime;
  return true;
}

bool PageConnection::drain() {
  std::array<char, 4096> bytes;
  const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
  return count > 0 || (count < 0 && would_wait());
}

}  // namespace pelt::tools::page

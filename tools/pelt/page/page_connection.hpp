#pragma once

/// A connection of a browser: reads a request, answers it, and closes the connection. Never blocks,
/// and uses bounded memory and time.

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace pelt::tools::page {

/// The served page and the names of the server.
struct Site {
  std::string_view page;
  int port = 0;
};

class PageConnection {
 public:
  using Clock = std::chrono::steady_clock;

  /// Takes ownership of a connected, non-blocking socket. The page must outlive the connection.
  PageConnection(int socket, const Site& site);
  PageConnection(const PageConnection&) = delete;
  PageConnection& operator=(const PageConnection&) = delete;
  ~PageConnection();

  int socket() const { return socket_; }

  /// The events to poll for.
  short events() const;

  /// Whether the client has sent nothing yet.
  bool is_silent() const { return state_ == State::reading && request_.empty(); }

  /// The time at which the connection is closed if nothing happens.
  Clock::time_point deadline() const { return deadline_; }

  /// Reads or writes as much as possible without blocking. Returns false when the connection has
  /// ended.
  bool advance();

 private:
  enum class State { reading, answering, draining };

  bool read_request();
  bool write_answer();
  bool drain();
  void answer(std::string_view head);
  void begin_answer(const char* status, std::string_view body, const char* more);

  int socket_;
  Site site_;
  State state_ = State::reading;
  std::string request_;
  std::string head_;       // of the answer
  std::string_view body_;  // after it
  std::size_t sent_ = 0;   // bytes of both
  Clock::time_point begin_, deadline_;
};

}  // namespace pelt::tools::page

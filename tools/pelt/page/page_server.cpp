#include "tools/pelt/page/page_server.hpp"

#include "tools/pelt/output/run_program.hpp"
#include "tools/pelt/page/page_connection.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace pelt::tools::page {
namespace {

using Clock = PageConnection::Clock;

constexpr const char* kLoopback = "127.0.0.1";

/// Further connections replace one that has sent nothing, or wait until one of these ends.
constexpr std::size_t kMaxConnections = 32;

/// Owns a file descriptor. Child processes do not inherit it.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) { fcntl(number_, F_SETFD, FD_CLOEXEC); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  int number() const { return number_; }

 private:
  int number_;
};

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// Binds the socket to the port; returns whether it now listens. Accepting does not block.
bool listen_at(int socket, std::uint16_t port) {
  const int yes = 1;  // for a recently used port
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const sockaddr_in address = loopback(port);
  return bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
         listen(socket, SOMAXCONN) == 0 && fcntl(socket, F_SETFL, O_NONBLOCK) == 0;
}

std::uint16_t port_of(int socket) {
  sockaddr_in address = {};
  socklen_t size = sizeof address;
  getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

Error unavailable(std::uint16_t port) {
  if (port != 0) {
    return {ErrorCode::invalid_argument, "--port: " + std::to_string(port) +
                                             " is in use: give another port, or leave out --port"};
  }
  return {
      ErrorCode::unsupported,
      "--port: there is no free port on the loopback address: write the page to a file with pelt "
      "check --html"};
}

Result<Descriptor> open_listener(std::uint16_t port) {
  Descriptor listener(socket(AF_INET, SOCK_STREAM, 0));
  if (listener.number() < 0 || !listen_at(listener.number(), port)) return unavailable(port);
  return listener;
}

/// The connections of a listening socket, served in turns by one thread until it is stopped.
class PageServer {
 public:
  /// Serves until `stop` becomes readable.
  PageServer(int listener, int stop, const Site& site)
      : listener_(listener), stop_(stop), site_(site) {}

  void run() {
    for (;;) {
      std::vector<pollfd> waiting = wait();
      if (waiting[0].revents != 0) return;
      for (std::size_t i = 0; i < connections_.size(); ++i) {
        const bool is_ready = waiting[2 + i].revents != 0;
        if ((is_ready && !connections_[i]->advance()) || has_expired(*connections_[i]))
          connections_[i].reset();
      }
      connections_.erase(std::remove(connections_.begin(), connections_.end(), nullptr),
                         connections_.end());
      if (waiting[1].revents != 0) accept_one();
    }
  }

 private:
  using Connection = std::unique_ptr<PageConnection>;

  static bool has_expired(const PageConnection& connection) {
    return Clock::now() >= connection.deadline();
  }

  static bool is_silent(const Connection& connection) { return connection->is_silent(); }

  /// Waits until something can be done. Order: `stop`, the listener, each connection.
  std::vector<pollfd> wait() const {
    const bool has_room = connections_.size() < kMaxConnections ||
                          std::any_of(connections_.begin(), connections_.end(), is_silent);
    const short accepting = has_room ? POLLIN : 0;
    std::vector<pollfd> waiting = {{stop_, POLLIN, 0}, {listener_, accepting, 0}};
    Clock::time_point next = Clock::now() + std::chrono::minutes(1);
    for (const Connection& connection : connections_) {
      waiting.push_back({connection->socket(), connection->events(), 0});
      next = std::min(next, connection->deadline());
    }
    const auto time = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
    poll(waiting.data(), waiting.size(), static_cast<int>(std::max<decltype(time)>(time, 0)));
    return waiting;
  }

  void accept_one() {
    const int socket = accept(listener_, nullptr, nullptr);
    if (socket < 0) {
      // For example, without a free descriptor: the connection stays in the queue.
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      return;
    }
    fcntl(socket, F_SETFD, FD_CLOEXEC);
    fcntl(socket, F_SETFL, O_NONBLOCK);
    // Otherwise, clients that send nothing would keep others waiting. The first one is the oldest.
    if (connections_.size() >= kMaxConnections)
      connections_.erase(std::find_if(connections_.begin(), connections_.end(), is_silent));
    connections_.push_back(std::make_unique<PageConnection>(socket, site_));
  }

  int listener_, stop_;
  Site site_;
  std::vector<Connection> connections_;
};

/// Blocks the signals that end the server in all threads except the one that waits for them.
sigset_t block_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// Does not wait, because the program may run until the browser is closed.
void open_browser(const std::string& address) {
  std::thread([address] {
    const std::vector<std::string> command = {"xdg-open", address};
    if (output::run_program(command, output::CtrlC::ends_caller) != output::ProgramEnd::succeeded)
      std::cout << "open this address in a browser\n" << std::flush;
  }).detach();
}

}  // namespace

Result<void> serve_page(const std::string& page, std::uint16_t port, Browser browser) {
  const sigset_t signals = block_ending_signals();
  const Result<Descriptor> listener = open_listener(port);
  if (!listener) return listener.error();
  const std::uint16_t own_port = port_of(listener->number());
  std::array<int, 2> ends = {-1, -1};
  if (pipe(ends.data()) != 0) return unavailable(0);
  const Descriptor stop(ends[0]);
  PageServer server(listener->number(), stop.number(), {page, own_port});
  std::thread serving;
  {
    const Descriptor running(ends[1]);  // closing this end stops the server
    serving = std::thread([&server] { server.run(); });
    const std::string address =
        std::string("http://") + kLoopback + ":" + std::to_string(own_port) + "/";
    std::cout << address << " until Ctrl+C\n" << std::flush;
    if (browser == Browser::opened) open_browser(address);
    int signal = 0;
    sigwait(&signals, &signal);
  }
  serving.join();
  return {};
}

}  // namespace pelt::tools::page

#include "tools/pelt/page_server.hpp"

#include "tools/pelt/run_program.hpp"

#include <httplib.h>

#include <csignal>
#include <iostream>
#include <thread>

namespace pelt::tools {
namespace {

constexpr const char* kLoopback = "127.0.0.1";

Result<int> bind(httplib::Server& server, std::uint16_t port) {
  if (port == 0) return server.bind_to_any_port(kLoopback);
  if (server.bind_to_port(kLoopback, port)) return int{port};
  return Error{ErrorCode::invalid_argument,
               "--port: " + std::to_string(port) + " is taken: give another, or leave it out"};
}

/// Signals that end the server, kept from all threads but the one that waits for them.
sigset_t block_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void open_browser(const std::string& address) {
  const std::vector<std::string> command = {"xdg-open", address};
  if (run_program(command) != ProgramEnd::succeeded)
    std::cout << "open it in a browser\n" << std::flush;
}

}  // namespace

Result<void> serve_page(const std::string& page, std::uint16_t port, Browser browser) {
  const sigset_t signals = block_ending_signals();
  httplib::Server server;
  server.Get("/", [&page](const httplib::Request&, httplib::Response& response) {
    response.set_content(page, "text/html; charset=utf-8");
  });
  const Result<int> bound = bind(server, port);
  if (!bound) return bound.error();
  std::thread serving([&server] { server.listen_after_bind(); });
  const std::string address =
      std::string("http://") + kLoopback + ":" + std::to_string(*bound) + "/";
  std::cout << address << " until Ctrl+C\n" << std::flush;
  if (browser == Browser::opened) open_browser(address);
  int signal = 0;
  sigwait(&signals, &signal);
  server.stop();
  serving.join();
  return {};
}

}  // namespace pelt::tools

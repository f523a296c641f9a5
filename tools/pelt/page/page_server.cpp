#include "tools/pelt/page/page_server.hpp"

#include "tools/pelt/output/run_program.hpp"

#include <httplib.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace pelt::tools::page {
namespace {

constexpr const char* kLoopback = "127.0.0.1";

/// The port is ours alone: by default, another server could share it.
void own_port(httplib::Server& server) {
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
}

Error taken(std::uint16_t port) {
  return {ErrorCode::invalid_argument,
          "--port: " + std::to_string(port) + " is in use: give another port, or leave out --port"};
}

Result<int> bind(httplib::Server& server, std::uint16_t port) {
  own_port(server);
  if (port != 0) return server.bind_to_port(kLoopback, port) ? Result<int>(port) : taken(port);
  const int any = server.bind_to_any_port(kLoopback);
  if (any > 0) return any;
  return Error{ErrorCode::unsupported,
               "--port: there is no free port on the loopback address: "
               "write the page to a file with pelt check --html"};
}

/// Names of other hosts that lead here would let their pages read the scene (DNS rebinding).
bool is_own_name(const std::string& host, int port) {
  const std::string number = std::to_string(port);
  return host == std::string(kLoopback) + ':' + number || host == "localhost:" + number;
}

/// Serves the page only under its own names, and forbids caching.
void offer(httplib::Server& server, const std::string& page, int port) {
  server.set_pre_routing_handler(
      [port](const httplib::Request& request, httplib::Response& response) {
        if (is_own_name(request.get_header_value("Host"), port))
          return httplib::Server::HandlerResponse::Unhandled;
        response.status = 403;
        return httplib::Server::HandlerResponse::Handled;
      });
  server.Get("/", [&page](const httplib::Request&, httplib::Response& response) {
    response.set_header("Cache-Control", "no-store");
    response.set_content(page, "text/html; charset=utf-8");
  });
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

/// Before that, the server cannot be stopped.
void wait_until_listening(const httplib::Server& server) {
  while (!server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
  httplib::Server server;
  const Result<int> bound = bind(server, port);
  if (!bound) return bound.error();
  offer(server, page, *bound);
  std::thread serving([&server] { server.listen_after_bind(); });
  wait_until_listening(server);
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

}  // namespace pelt::tools::page

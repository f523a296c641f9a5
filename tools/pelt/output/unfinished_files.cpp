#include "tools/pelt/output/unfinished_files.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <string>

namespace pelt::tools::output {
namespace {

/// A signal handler must not allocate or lock, so paths are stored in memory of fixed size.
struct Slot {
  std::atomic<bool> used = false;
  std::array<char, PATH_MAX> path;
};

/// No verb writes as many files at a time; other files would not be removed on a signal.
constexpr std::size_t kSlots = 16;
std::array<Slot, kSlots> slots;

std::atomic<pid_t> running_program = 0;  // 0: none

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};

/// Precondition: the signal's default action has been restored.
void remove_and_end(int signal) {
  if (const pid_t program = running_program.load(std::memory_order_acquire); program != 0) {
    kill(-program, SIGKILL);
    waitpid(program, nullptr, 0);  // otherwise it may create a file after the removal
  }
  for (const Slot& slot : slots) {
    if (slot.used.load(std::memory_order_acquire)) unlink(slot.path.data());
  }
  raise(signal);
}

}  // namespace

void remove_unfinished_files_on_signals() {
  struct sigaction removing = {};
  removing.sa_handler = remove_and_end;
  removing.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  sigemptyset(&removing.sa_mask);
  for (const int signal : kEndingSignals) {
    struct sigaction known = {};
    sigaction(signal, nullptr, &known);
    if (known.sa_handler == SIG_DFL) sigaction(signal, &removing, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) : slot_(0) {
  while (slot_ < kSlots && slots[slot_].used.load(std::memory_order_relaxed)) ++slot_;
  const std::string text = std::filesystem::absolute(path).string();
  if (slot_ == kSlots || text.size() >= PATH_MAX) {
    slot_ = kSlots;
    return;
  }
  std::memcpy(slots[slot_].path.data(), text.c_str(), text.size() + 1);
  slots[slot_].used.store(true, std::memory_order_release);
}

UnfinishedFile::~UnfinishedFile() {
  if (slot_ < kSlots) slots[slot_].used.store(false, std::memory_order_release);
}

SignalsBlocked::SignalsBlocked() {
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : kEndingSignals) sigaddset(&ending, signal);
  pthread_sigmask(SIG_BLOCK, &ending, &before_);
}

SignalsBlocked::~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

RunningProgram::RunningProgram(pid_t leader) {
  running_program.store(leader, std::memory_order_release);
}

RunningProgram::~RunningProgram() { running_program.store(0, std::memory_order_release); }

}  // namespace pelt::tools::output

#ifndef PROGRAM_INTERRUPT_GUARD_H
#define PROGRAM_INTERRUPT_GUARD_H

#include "system.h"

#include <atomic>
#include <csignal>
#include <utility>
#include <vector>

namespace Program {

/// As long as the object lives, SIGINT, SIGTERM and SIGHUP, or SIGBREAK on Windows, do not end the program but are noted, for all
/// threads. A second one ends it.
/// SIGHUP stays ignored if it is, as nohup has asked for that.
class Interrupt_guard
{
public:
  Interrupt_guard()
  {
    for(const int signal : {SIGINT, SIGTERM, signal_of_hangup})
    {
      m_previous.emplace_back(signal, std::signal(signal, &note));
      if(signal == signal_of_hangup && m_previous.back().second == SIG_IGN)
        std::signal(signal, SIG_IGN);
    }
  }

  ~Interrupt_guard()
  {
    for(const auto& [signal, handler] : m_previous)
      std::signal(signal, handler == SIG_ERR ? SIG_DFL : handler);
  }

  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

  /// returns whether there has been one of the signals.
  static bool is_interrupted() { return s_is_interrupted; }

private:
  static void note(int signal)
  {
    if(!s_is_interrupted.exchange(true))
      return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }

  // What a signal handler writes and other threads read has to be atomic without a lock.
  inline static std::atomic<bool> s_is_interrupted{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "A signal handler must not wait for a lock.");

  std::vector<std::pair<int, void (*)(int)>> m_previous;
};

} // namespace Program

#endif // PROGRAM_INTERRUPT_GUARD_H

#ifndef PROGRAM_INTERRUPT_GUARD_H
#define PROGRAM_INTERRUPT_GUARD_H

#include "system.h"

#include <atomic>
#include <csignal>
#include <utility>
#include <vector>

namespace Program {

/// During its lifetime, SIGINT, SIGTERM and SIGHUP, or SIGBREAK on Windows, do not end the program but are recorded, for all threads. A
/// second signal ends the program. SIGHUP remains ignored if it is ignored already, as under nohup.
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

  /// returns whether one of the signals has been received.
  static bool is_interrupted() { return s_is_interrupted; }

private:
  static void note(int signal)
  {
    if(!s_is_interrupted.exchange(true))
      return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }

  // Written by a signal handler and read by other threads, so it must be atomic and lock-free.
  inline static std::atomic<bool> s_is_interrupted{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "A signal handler must not wait for a lock.");

  std::vector<std::pair<int, void (*)(int)>> m_previous;
};

} // namespace Program

#endif // PROGRAM_INTERRUPT_GUARD_H

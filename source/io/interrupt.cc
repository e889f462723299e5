#include <taut/io/interrupt.h>

#include <csignal>

namespace taut::io
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;
}

extern "C"
{
  static void remember_interrupt(int)
  {
    interrupted = 1;
  }
}

void catch_interrupts()
{
  struct sigaction action = {};
  action.sa_handler = remember_interrupt;
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool was_interrupted()
{
  return interrupted != 0;
}
} // namespace taut::io

#include "haptics/loop/real_time.h"

#include <pthread.h>
#include <sys/mman.h>

#include <cerrno>
#include <system_error>

namespace fulcrum {

std::string ask_for_scheduling(int priority) {
  sched_param wanted{};
  wanted.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
  if (error == 0) return "";
  return "Real-time scheduling was refused (" + std::generic_category().message(error) +
         "), so other programs can delay a tick. To grant it, add to /etc/security/limits.conf: "
         "\"@users - rtprio " +
         std::to_string(kHapticPriority) + "\" and log in anew.";
}

std::string ask_for_locked_memory() {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return "";
  return "Locked memory was refused (" + std::generic_category().message(errno) +
         "), so swapping can delay a tick. To grant it, add to /etc/security/limits.conf: "
         "\"@users - memlock unlimited\" and log in anew.";
}

}  // namespace fulcrum

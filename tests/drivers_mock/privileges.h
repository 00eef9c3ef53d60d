#pragma once
// The person who runs the tests may be root, who may open everything.

#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace fulcrum::test {

// The calling thread may open no more than the modes of files say. False: the system does not let it.
inline bool open_by_modes_alone() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[2]{};
  if (syscall(SYS_capget, &header, sets) != 0) return false;
  constexpr std::uint32_t kOpenAll = 1U << CAP_DAC_OVERRIDE | 1U << CAP_DAC_READ_SEARCH;
  sets[0].effective &= ~kOpenAll;
  sets[0].permitted &= ~kOpenAll;
  return syscall(SYS_capset, &header, sets) == 0;
}

}  // namespace fulcrum::test

#pragma once
// Which system calls a thread makes, as the kernel sees them (seccomp, with a listener that lets each go on).

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>

namespace fulcrum::test {

// One thread's calls, from watch() until the thread ends. Sleeping until a time and reading the clock are not
// counted: neither waits for anybody. Outlives the thread.
class SystemCalls {
public:
  ~SystemCalls() {
    ends_ = true;
    if (listener_.joinable()) listener_.join();
    if (descriptor_ >= 0) close(descriptor_);
  }

  // Of the calling thread, once. Allocates. False: this system does not let it be watched.
  bool watch() {
    sock_filter filter[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clock_nanosleep, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clock_gettime, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{std::size(filter), filter};
    // The listener is there before the filter, which would stop its making, too.
    listener_ = std::thread([this] { listen(); });
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    const long made =
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program);
    descriptor_ = static_cast<int>(made);
    if (made < 0) ends_ = true;
    return made >= 0;
  }

  // Their numbers, so far.
  std::set<int> seen() const {
    const std::lock_guard lock(mutex_);
    return seen_;
  }

private:
  void listen() {
    while (!ends_) {
      pollfd waiting{descriptor_, POLLIN, 0};
      if (descriptor_ < 0 || poll(&waiting, 1, 20) <= 0) {
        std::this_thread::yield();
        continue;
      }
      if ((waiting.revents & POLLIN) == 0) return;  // the thread has ended
      seccomp_notif call{};
      if (ioctl(descriptor_, SECCOMP_IOCTL_NOTIF_RECV, &call) != 0) continue;
      {
        const std::lock_guard lock(mutex_);
        seen_.insert(call.data.nr);
      }
      seccomp_notif_resp answer{};
      answer.id = call.id;
      answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
      ioctl(descriptor_, SECCOMP_IOCTL_NOTIF_SEND, &answer);
    }
  }

  std::atomic<int> descriptor_{-1};
  std::atomic<bool> ends_{false};
  mutable std::mutex mutex_;
  std::set<int> seen_;
  std::thread listener_;
};

}  // namespace fulcrum::test

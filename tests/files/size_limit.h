#pragma once
// A disk without room, as far as a program can tell without one: no file may grow beyond so many bytes.

#include <sys/resource.h>

#include <csignal>

namespace fulcrum::test {

class SizeLimit {
public:
  explicit SizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace fulcrum::test

#pragma once
// Whatever is waited for is waited for until it is seen; who starts the machine ends what never comes.

#include <chrono>
#include <thread>

namespace fulcrum::test {

void wait_for(auto seen) {
  while (!seen()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace fulcrum::test

#include "haptics/bake/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace fulcrum {

void for_each_piece(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress) {
  const unsigned wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  std::atomic<std::size_t> taken{0};
  const auto take_all = [&](bool report) {
    for (std::size_t i = taken++; i < count; i = taken++) {
      work(i);
      if (report && progress) progress(static_cast<double>(i + 1) / static_cast<double>(count));
    }
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(wanted, count); ++i)
    helpers.emplace_back([&] { take_all(false); });
  try {
    take_all(true);
  } catch (...) {
    taken = count;  // nobody waits for the rest
    throw;
  }
}

}  // namespace fulcrum

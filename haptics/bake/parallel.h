#pragma once
// Independent pieces of work over a few threads. Each piece writes only what is its own, so that the outcome
// does not depend on how many threads there are or on who takes what.

#include <cstddef>
#include <functional>

namespace fulcrum {

// work(i) for every i below count. threads = 0: as many as the machine has. progress(fraction of the pieces
// taken) is called now and then, from the calling thread; it may be empty. What it throws ends the work and
// comes out of here.
void for_each_piece(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress);

}  // namespace fulcrum

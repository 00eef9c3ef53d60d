#include "tools/content/mesh/maker.h"

#include <iostream>
#include <span>

#include "tools/content/mesh/glb_writer.h"

namespace fulcrum::content {

int run_maker(const Maker& maker, int argc, char** argv) {
  const std::span arguments(argv, static_cast<std::size_t>(argc));
  const std::string what = arguments.size() == 2 ? arguments[1] : "";
  if (what == "--check") return maker.check() ? 0 : 1;
  if (what == "--route" || what == "--checkpoints") {
    std::cout << (what == "--route" ? maker.route() : maker.checkpoints());
    return 0;
  }
  if (what.empty() || what.starts_with("-")) {
    std::cerr << "usage: " << maker.program << " OUTDIR | --route | --checkpoints | --check\n";
    return 2;
  }
  return write_models(maker.models(), what, maker.program) ? 0 : 1;
}

}  // namespace fulcrum::content

#include <cstdio>

#include "engine/app/cli/exit_code.h"
#include "engine/app/commands/commands.h"
#include "engine/app/start/start_window.h"
#include "engine/ui/window.h"

namespace fulcrum::app {

// Where there is no display, the help is of more use than a sentence about displays.
void add_start(Program& program) {
  program.without_arguments([&program] {
    if (ui::why_no_window().empty()) return run_start_window();
    std::fputs(program.help().c_str(), stdout);
    return static_cast<int>(kUsage);
  });
}

}  // namespace fulcrum::app

#include "engine/app/cli/beside.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"

namespace fulcrum::app {

int become(const Beside& beside, char** argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path program = self.parent_path() / beside.program;
  if (!error) {
    execv(program.c_str(), argv);
    error = std::error_code(errno, std::generic_category());
  }
  const std::string name = beside.program;
  complain(beside.task + std::string(" by ") + program.string() + ", which could not be started (" +
           error.message() + "): `tools/run --build` builds it, or `cmake --build` with the target " + name +
           ".");
  return kError;
}

int run_beside(const Beside& beside, char** argv, const std::string& failed) {
  const pid_t child = fork();
  if (child == 0) _exit(become(beside, argv));
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child > 0 && WIFEXITED(status)) return WEXITSTATUS(status);
  complain(child < 0 ? "no process can be started: " + std::generic_category().message(errno) : failed);
  return kError;
}

}  // namespace fulcrum::app

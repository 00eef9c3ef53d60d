#include "drivers/omega/dhd_library.h"

#include <string>
#include <utility>

#include "drivers/vendor/shared_library.h"

namespace fulcrum::dhd {
namespace {

Result<Library> load() {
  Result<SharedLibrary> file = SharedLibrary::open("libdhd.so");
  if (!file)
    return Error{"the library of its maker is not there (" + file.error().sentence +
                 "): install Force Dimension's SDK, and put the folder of libdhd.so in LD_LIBRARY_PATH."};
  Library dhd{};
  file->find("dhdGetDeviceCount", dhd.device_count);
  file->find("dhdOpen", dhd.open);
  file->find("dhdClose", dhd.close);
  file->find("dhdEnableForce", dhd.enable_force);
  file->find("dhdGetPositionAndOrientationFrame", dhd.frame);
  file->find("dhdSetForceAndTorque", dhd.set_force);
  file->find("dhdGetButton", dhd.button);
  file->find("dhdGetStatus", dhd.status);
  file->find("dhdErrorGetLastStr", dhd.last_error);
  if (!file->missing().empty()) {
    std::string lacks = "the library of its maker, libdhd.so, lacks ";
    lacks.append(file->missing()).append(": install version 3 of Force Dimension's SDK.");
    return Error{std::move(lacks)};
  }
  return dhd;
}

}  // namespace

Result<const Library*> library() {
  static const Result<Library> loaded = load();
  if (!loaded) return loaded.error();
  return &*loaded;
}

}  // namespace fulcrum::dhd

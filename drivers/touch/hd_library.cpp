#include "drivers/touch/hd_library.h"

#include <string>
#include <utility>

#include "drivers/vendor/shared_library.h"

namespace fulcrum::hd {
namespace {

Result<Library> load() {
  Result<SharedLibrary> file = SharedLibrary::open("libHD.so");
  if (!file)
    return Error{"the library of its maker is not there (" + file.error().sentence +
                 "): install 3D Systems' device driver and OpenHaptics, and put the folder of libHD.so in "
                 "LD_LIBRARY_PATH."};
  Library hd{};
  file->find("hdInitDevice", hd.init_device);
  file->find("hdDisableDevice", hd.disable_device);
  file->find("hdMakeCurrentDevice", hd.make_current);
  file->find("hdEnable", hd.enable);
  file->find("hdStartScheduler", hd.start_scheduler);
  file->find("hdStopScheduler", hd.stop_scheduler);
  file->find("hdScheduleAsynchronous", hd.schedule);
  file->find("hdUnschedule", hd.unschedule);
  file->find("hdBeginFrame", hd.begin_frame);
  file->find("hdEndFrame", hd.end_frame);
  file->find("hdGetDoublev", hd.get_doubles);
  file->find("hdGetIntegerv", hd.get_integers);
  file->find("hdSetDoublev", hd.set_doubles);
  file->find("hdGetError", hd.error);
  file->find("hdGetErrorString", hd.error_text);
  file->find("hdCheckCalibration", hd.check_calibration);
  file->find("hdUpdateCalibration", hd.update_calibration);
  if (!file->missing().empty()) {
    std::string lacks = "the library of its maker, libHD.so, lacks ";
    lacks.append(file->missing()).append(": install OpenHaptics 3.");
    return Error{std::move(lacks)};
  }
  return hd;
}

}  // namespace

Result<const Library*> library() {
  static const Result<Library> loaded = load();
  if (!loaded) return loaded.error();
  return &*loaded;
}

}  // namespace fulcrum::hd

#include "engine/app/prepare/colocation_choice.h"

#include <system_error>

#include "drivers/registry.h"

namespace fulcrum::app {

std::string device_on_desk(const std::string& device) {
  return pushes_back(device) && !moves_as_seen(device) ? device.substr(0, device.find('+')) : std::string();
}

ColocationChoice choose_colocation(const HeadsetOptions& options, const std::string& device) {
  const std::string on_desk = device_on_desk(device);
  if (on_desk.empty()) return {{}, "the device has no base that stands on a desk", {}};
  if (options.scale != 1) return {{}, "--xr-scale shows the scene in another size than it is felt in", {}};
  if (options.colocate) return {"by points that are touched before the trial (--colocate)", {}, {}};
  std::filesystem::path file = scenario::colocation_file(on_desk, options.space);
  std::error_code ignored;
  const bool kept = !file.empty() && std::filesystem::symlink_status(file, ignored).type() !=
                                         std::filesystem::file_type::not_found;
  if (!kept) return {{}, "no points have been touched in " + options.space + " space (--colocate)", {}};
  std::string built = "the device stands in " + options.space + " space as " + file.string() + " has it";
  return {std::move(built), {}, std::move(file)};
}

Result<std::optional<scenario::Colocation>> kept_colocation(const HeadsetOptions& options,
                                                            const std::string& device) {
  const std::filesystem::path file = choose_colocation(options, device).file;
  if (file.empty()) return std::optional<scenario::Colocation>();
  scenario::Checked<scenario::Colocation> kept =
      scenario::load_colocation(file, device_on_desk(device), options.space);
  if (!kept) return Error{scenario::to_text(kept.faults())};
  return std::optional(std::move(*kept));
}

}  // namespace fulcrum::app

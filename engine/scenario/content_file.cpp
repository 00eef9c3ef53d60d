#include "engine/scenario/content_file.h"

#include <system_error>
#include <utility>

#include "engine/scenario/content.h"

namespace fulcrum::scenario {

namespace fs = std::filesystem;

namespace {

// A link counts though it leads nowhere: what is wrong with it is said when it is opened.
bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

ContentFile::ContentFile(fs::path scenario_folder, std::string kind, const std::string& name)
    : scenario_folder_(std::move(scenario_folder)), kind_(std::move(kind)), file_(name + ".yaml") {}

bool ContentFile::is_own() const {
  return is_there(scenario_folder_ / kind_ / file_);
}

bool ContentFile::is_installed() const {
  return !installed().empty();
}

fs::path ContentFile::installed() const {
  for (const fs::path& root : content_roots())
    if (fs::path file = root / kind_ / file_; is_there(file)) return file;
  return {};
}

Result<RegularFile> ContentFile::open() const {
  const fs::path own = scenario_folder_ / kind_ / file_;
  const fs::path found = installed();
  return is_own() || found.empty() ? RegularFile::open_within(scenario_folder_, own)
                                   : RegularFile::open(found);
}

std::vector<fs::path> ContentFile::folders() const {
  std::vector<fs::path> folders;
  std::error_code ignored;
  // Not through a link, which may lead anywhere.
  const fs::path own = scenario_folder_ / kind_;
  if (fs::is_directory(fs::symlink_status(own, ignored))) folders.push_back(own);
  for (const fs::path& root : content_roots()) folders.push_back(root / kind_);
  return folders;
}

}  // namespace fulcrum::scenario

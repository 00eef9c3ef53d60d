#pragma once
// Notices that files of a scenario's folder have been saved.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace fulcrum::app {

class FileWatch {
public:
  // What is there now counts as seen.
  explicit FileWatch(std::filesystem::path folder)
      : folder_(std::move(folder)), seen_(look()), before_(seen_) {}

  // These too, wherever they lie and whether they are there or not. What is there now counts as seen.
  void also(const std::vector<std::filesystem::path>& files);

  // True once for each change, when a look finds it as the look before did: an editor that writes a file in
  // pieces is done then. To be asked a few times a second.
  bool saved();

private:
  // A file is another one where it was replaced, written again, or has another size.
  struct Version {
    ino_t inode = 0;
    std::int64_t changed_ns = 0;
    std::int64_t size = 0;
    bool operator==(const Version&) const = default;
  };
  // Of each file that a scenario is made of.
  using Files = std::map<std::filesystem::path, Version>;
  Files look() const;
  static void look_at(const std::filesystem::path& file, Files& files);

  std::filesystem::path folder_;
  std::set<std::filesystem::path> named_;
  Files seen_, before_;
};

}  // namespace fulcrum::app

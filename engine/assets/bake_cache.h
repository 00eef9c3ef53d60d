#pragma once
// Bakes kept between runs, found by what they were made from: SHA-256 of the mesh, the parameters and the
// format.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/math/result.h"

namespace fulcrum {

template <class T>
struct Baked {
  T value;
  bool from_cache = false;
  std::string note;  // a sentence, if the cache was damaged or could not be written; empty otherwise
};

class BakeCache {
public:
  // $XDG_CACHE_HOME/fulcrum, else ~/.cache/fulcrum, else (no home) no folder: everything is baked anew.
  BakeCache();
  explicit BakeCache(std::filesystem::path folder);

  // From the cache if it is there and whole, else baked and kept. A damaged file is noted and replaced; a
  // folder that cannot be written is noted. The errors are the bake's own.
  Result<Baked<DistanceField>> field(const Solid& solid, const FieldDesc& desc,
                                     const Progress& progress = {}) const;
  Result<Baked<Pointshell>> pointshell(const Solid& solid, const PointshellDesc& desc) const;
  Result<Baked<Pointshell>> edges(const Solid& solid, const PointshellDesc& desc) const;

  // What another room makes from something else. name: a SHA-256 of all of that, and an ending. is_whole:
  // the bytes are of one piece.
  Baked<std::vector<std::byte>> bytes(const std::string& name,
                                      const std::function<bool(std::span<const std::byte>)>& is_whole,
                                      const std::function<std::vector<std::byte>()>& make) const;

  const std::filesystem::path& folder() const { return folder_; }

private:
  std::filesystem::path folder_;
};

}  // namespace fulcrum

#pragma once
// What a scene is made of and what it does without, for `fulcrum explain`.

#include <cstddef>
#include <string>

namespace fulcrum {

struct BuiltPart {
  std::string name;
  std::string what;
  std::size_t bytes = 0;
};

struct LeftOut {
  std::string name;
  std::string why;
};

}  // namespace fulcrum

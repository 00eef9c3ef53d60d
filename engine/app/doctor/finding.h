#pragma once
// What `fulcrum doctor` says of one thing that a training session needs.

#include <array>
#include <string>

#include "haptics/math/names_of.h"

namespace fulcrum::app {

enum class Health {
  good,
  fair,  // it works, and could work better
  bad    // what needs it does not work
};

struct Finding {
  std::string what;  // a word
  Health health = Health::good;
  std::string says;  // a sentence
  std::string cure;  // what would make it good: a command or an act; empty where nothing has to be done
};

}  // namespace fulcrum::app

namespace fulcrum {
template <>
inline constexpr std::array<std::string_view, 3> names_of<app::Health>{"good", "fair", "bad"};
}  // namespace fulcrum

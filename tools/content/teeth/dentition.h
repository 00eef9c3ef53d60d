#pragma once

#include <array>

#include "tools/content/teeth/arch.h"
#include "tools/content/teeth/tooth.h"

namespace fulcrum::content {

// The fourteen teeth on their arch, each in contact with its neighbours.
struct Dentition {
  Arch arch;
  std::array<Tooth, 14> teeth;  // from 47 over 41 and 31 to 37

  const Tooth& tooth(int number) const;  // ISO 3950
  // The index of the tooth at a place along the arch.
  std::size_t nearest(double along) const;
};

Dentition make_dentition();

// How deep (mm) two neighbours reach into each other; negative: the gap between them.
double contact_depth(const Tooth& a, const Tooth& b);

}  // namespace fulcrum::content

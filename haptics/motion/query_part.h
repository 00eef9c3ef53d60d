#pragma once

#include "haptics/contact/query.h"
#include "haptics/motion/tool_motion.h"

namespace fulcrum {

inline BuiltPart query_part(const ContactQuery& query) {
  return {"query", std::string("16-ary sphere hierarchy over the points against the field, ") + simd_target(),
          query.bytes()};
}

}  // namespace fulcrum

#pragma once
// Numbers as text that reads back to the same bits, whatever the process's locale.

#include <cstdint>
#include <string>

namespace fulcrum {

// Shortest round trip. -0 is written as 0 and every NaN as nan: their signs say nothing, and differ by
// compiler.
void append_number(std::string& to, double value);
void append_number(std::string& to, std::int64_t value);

}  // namespace fulcrum

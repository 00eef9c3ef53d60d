#pragma once
// What a runtime was asked for, a line a call, into the file that $FULCRUM_XR_LOG names. What a program may
// not do begins with WRONG.

#include <string>

namespace runtime {

void log(const std::string& line);
void wrong(const std::string& line);

}  // namespace runtime

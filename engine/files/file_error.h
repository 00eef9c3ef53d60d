#pragma once
// What went wrong with a file, as a sentence with a remedy.

#include <filesystem>
#include <string_view>

#include "haptics/math/result.h"

namespace fulcrum {

// doing: "write", "create", "read", ...; error_number: errno of the call that failed.
Error file_error(std::string_view doing, const std::filesystem::path& path, int error_number);

// The same of a file that Fulcrum keeps in its own place, such as its settings, which no --out changes.
Error kept_file_error(std::string_view doing, const std::filesystem::path& path, int error_number);

// Of a file that was to be read; why: the clause of RegularFile.
Error read_error(const std::filesystem::path& path, const Error& why);

}  // namespace fulcrum

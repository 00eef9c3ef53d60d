#pragma once
// Writes a file whole or not at all.

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>

namespace fulcrum {

using Pieces = std::initializer_list<std::span<const std::byte>>;

// Other processes find what was there before, nothing, or all of the new file, and a process that is killed
// leaves nothing half done: the file has no name until it is whole. False where it cannot be written, and
// errno says why, for file_error(); folders on the way to it are made. Files of the folder that such a call
// has left as NAME.NUMBER.part, and that nobody writes any more, go.
bool put_file(const std::filesystem::path& path, Pieces pieces);

// The same on a file system that has no files without a name: a kill leaves a .part, and the next call in
// that folder removes it.
bool put_file_by_part(const std::filesystem::path& path, Pieces pieces);

}  // namespace fulcrum

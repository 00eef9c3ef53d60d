#include "engine/record/tape_reader.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/file_error.h"
#include "engine/files/regular_file.h"
#include "engine/record/tape_bytes.h"
#include "engine/record/tape_header.h"

namespace fulcrum::record {

namespace {

Error damaged(std::size_t offset, const std::string& what) {
  return {"The tape is damaged at byte " + std::to_string(offset) + ": " + what +
          ". Use another copy of it, or record the run again."};
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A block and the checksum that follows it. Nothing: the bytes end before it does.
Result<std::optional<std::span<const std::byte>>> take_block(ByteReader& reader, std::size_t size) {
  const std::size_t start = reader.offset();
  const std::span<const std::byte> block = reader.take(size);
  const auto crc = reader.get<std::uint32_t>();
  if (!reader.ok()) return std::optional<std::span<const std::byte>>();
  if (crc != crc32c(block)) {
    return damaged(start,
                   "the checksum of the " + std::to_string(size) + " bytes from there on does not fit them");
  }
  return std::optional(block);
}

Result<TapeHeader> take_header(ByteReader& reader, std::span<const std::byte> bytes, std::uint32_t& version) {
  if (!as_text(bytes).starts_with(kTapeMagic)) {
    return Error{"This is not a tape: byte 0 does not begin the word " + std::string(kTapeMagic) +
                 ". Name the tape in a run's folder."};
  }
  const Error ends_early{"The tape ends at byte " + std::to_string(bytes.size()) +
                         ", within its header: nothing of the run is on it. Record the run again."};
  if (bytes.size() >= kTapeMagic.size() + 4) {
    version = ByteReader(bytes.subspan(kTapeMagic.size())).get<std::uint32_t>();
    if (version < kOldestTapeVersion || version > kTapeVersion) {
      return Error{"The tape is of format version " + std::to_string(version) +
                   " (byte 8), and this program reads " + std::to_string(kOldestTapeVersion) + " to " +
                   std::to_string(kTapeVersion) + ": use the program that recorded it."};
    }
  }
  const auto prefix = take_block(reader, kTapeMagic.size() + 8);
  if (!prefix) return prefix.error();
  if (!*prefix) return ends_early;
  const auto size = ByteReader((*prefix)->last(4)).get<std::uint32_t>();
  const std::size_t start = reader.offset();
  const auto json = take_block(reader, size);
  if (!json) return json.error();
  if (!*json) return ends_early;
  Result<TapeHeader> header = parse_tape_header(as_text(**json));
  if (!header) return damaged(start, "the header cannot be read (" + header.error().sentence + ')');
  return header;
}

// Counts are not to be trusted though the checksum fits: what they promise is read one by one, and the first
// that is not there ends it, so that no more is kept than the bytes hold.
std::optional<Error> take_entries(std::span<const std::byte> payload, std::size_t start,
                                  std::uint32_t version, std::vector<TapeEntry>& entries) {
  ByteReader reader(payload);
  const auto first = reader.get<std::uint64_t>();
  const auto count = reader.get<std::uint32_t>();
  if (!reader.ok() || first != entries.size())
    return damaged(start, "a chunk does not follow the one before it");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t at = start + reader.offset();
    TapeEntry& entry = entries.emplace_back();
    double values[8];
    for (double& value : values) value = reader.get_double();
    entry.sample.X_DH = {Quat(values[0], values[1], values[2], values[3]),
                         Vec3(values[4], values[5], values[6])};
    entry.sample.age = values[7];
    if (version >= 3) entry.sample.strip_ohm = reader.get_double();
    entry.sample.buttons = reader.get<std::uint32_t>();
    const auto connected = reader.get<std::uint8_t>();
    entry.sample.connected = connected == 1;
    entry.lost_before = static_cast<std::int64_t>(reader.get<std::uint64_t>());
    const auto digest = reader.get<std::uint64_t>();
    if (version >= 4) entry.digest = digest;
    const auto commands = reader.get<std::uint32_t>();
    if (!reader.ok() || connected > 1 || entry.lost_before < 0)
      return damaged(at, "tick " + std::to_string(entries.size() - 1) + " cannot be read");
    for (std::uint32_t j = 0; j < commands; ++j) {
      const auto kind = static_cast<Command::Kind>(reader.get<std::uint32_t>());
      if (kind < Command::Kind::stop || kind > Command::Kind::last) {
        return damaged(at,
                       "tick " + std::to_string(entries.size() - 1) + " has a command that does not exist");
      }
      entry.commands.push_back({kind, reader.get_double()});
    }
  }
  if (reader.left() != 0) return damaged(start + reader.offset(), "a chunk is longer than its entries");
  return std::nullopt;
}

std::optional<Error> check_end(const ByteReader& file, std::span<const std::byte> payload, std::size_t start,
                               std::size_t entries) {
  ByteReader reader(payload);
  const auto total = reader.get<std::uint64_t>();
  if (!reader.ok() || reader.left() != 0 || total != entries)
    return damaged(start, "the end does not tell of the ticks before it");
  if (file.left() != 0) return damaged(file.offset(), "something follows the end");
  return std::nullopt;
}

}  // namespace

Result<Tape> parse_tape(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  std::uint32_t version = 0;
  Result<TapeHeader> header = take_header(reader, bytes, version);
  if (!header) return header.error();
  Tape tape;
  tape.header = std::move(*header);
  while (!tape.complete) {
    const std::size_t frame_start = reader.offset();
    const auto frame = take_block(reader, 8);
    if (!frame) return frame.error();
    if (!*frame) break;
    ByteReader frame_reader(**frame);
    const auto kind = frame_reader.get<std::uint32_t>();
    const auto size = frame_reader.get<std::uint32_t>();
    const std::size_t start = reader.offset();
    const auto payload = take_block(reader, size);
    if (!payload) return payload.error();
    if (!*payload) break;
    std::optional<Error> error;
    if (kind == kTickChunk) {
      error = take_entries(**payload, start, version, tape.entries);
    } else if (kind == kEndChunk) {
      error = check_end(reader, **payload, start, tape.entries.size());
      tape.complete = true;
    } else {
      error = damaged(frame_start, "a chunk is of no kind that there is");
    }
    if (error) return *std::move(error);
  }
  return tape;
}

Result<Tape> read_tape(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return read_error(path, file.error());
  const Result<std::string> bytes = file->first_bytes(std::numeric_limits<std::uint64_t>::max());
  if (!bytes) return read_error(path, bytes.error());
  Result<Tape> tape = parse_tape(std::as_bytes(std::span(*bytes)));
  if (!tape) return Error{path.string() + ": " + tape.error().sentence};
  return tape;
}

}  // namespace fulcrum::record

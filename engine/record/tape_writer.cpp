#include "engine/record/tape_writer.h"

#include <utility>

#include "engine/record/tape_bytes.h"
#include "engine/record/tape_header.h"

namespace fulcrum::record {

Result<TapeWriter> TapeWriter::create(const std::filesystem::path& path, const TapeHeader& header) {
  const Result<std::string> json = tape_header_json(header);
  if (!json) return json.error();
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  std::string text(kTapeMagic);
  put(text, kTapeVersion);
  put(text, static_cast<std::uint32_t>(json->size()));
  put_crc(text, 0);
  const std::size_t start = text.size();
  text += *json;
  put_crc(text, start);
  if (std::optional<Error> error = file->append(text)) return *std::move(error);
  return TapeWriter(std::move(*file));
}

void TapeWriter::entry(const DeviceSample& sample, std::span<const Command> commands,
                       std::int64_t lost_before, std::uint64_t digest) {
  const auto& [X_DH, age, buttons, connected, strip_ohm] = sample;
  for (const double value :
       {X_DH.q.w(), X_DH.q.x(), X_DH.q.y(), X_DH.q.z(), X_DH.p.x(), X_DH.p.y(), X_DH.p.z(), age, strip_ohm})
    put(pending_, value);
  put(pending_, buttons);
  put(pending_, static_cast<std::uint8_t>(connected));
  put(pending_, static_cast<std::uint64_t>(lost_before));
  put(pending_, digest);
  put(pending_, static_cast<std::uint32_t>(commands.size()));
  for (const Command& command : commands) {
    put(pending_, static_cast<std::uint32_t>(command.kind));
    put(pending_, command.value);
  }
  ++pending_entries_;
}

std::optional<Error> TapeWriter::flush() {
  std::string payload;
  payload.reserve(12 + pending_.size());
  put(payload, entries_);
  put(payload, pending_entries_);
  payload += pending_;
  pending_.clear();
  const std::uint32_t entries = std::exchange(pending_entries_, 0);
  std::optional<Error> error = append_chunk(kTickChunk, payload);
  if (!error) entries_ += entries;
  return error;
}

std::optional<Error> TapeWriter::finish() {
  std::string payload;
  put(payload, entries_);
  if (std::optional<Error> error = append_chunk(kEndChunk, payload)) return error;
  return file_.close();
}

std::optional<Error> TapeWriter::append_chunk(std::uint32_t kind, std::string_view payload) {
  std::string chunk;
  chunk.reserve(16 + payload.size());
  put(chunk, kind);
  put(chunk, static_cast<std::uint32_t>(payload.size()));
  put_crc(chunk, 0);
  const std::size_t start = chunk.size();
  chunk += payload;
  put_crc(chunk, start);
  return file_.append(chunk);
}

}  // namespace fulcrum::record

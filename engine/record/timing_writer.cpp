#include "engine/record/timing_writer.h"

#include <utility>

#include "engine/files/number_text.h"

namespace fulcrum::record {

Result<TimingWriter> TimingWriter::create(const std::filesystem::path& path) {
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  TimingWriter writer(std::move(*file));
  writer.pending_ = "tick,cpu_us,wake_late_us,lost_before\n";
  if (std::optional<Error> error = writer.flush()) return *std::move(error);
  return writer;
}

void TimingWriter::row(const TickTiming& timing) {
  append_number(pending_, timing.tick);
  pending_ += ',';
  append_number(pending_, static_cast<double>(timing.cpu_ns) / 1000);
  pending_ += ',';
  append_number(pending_, static_cast<double>(timing.wake_late_ns) / 1000);
  pending_ += ',';
  append_number(pending_, timing.lost_before);
  pending_ += '\n';
}

std::optional<Error> TimingWriter::flush() {
  std::optional<Error> error = file_.append(pending_);
  pending_.clear();
  return error;
}

}  // namespace fulcrum::record

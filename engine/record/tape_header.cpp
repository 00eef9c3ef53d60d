#include "engine/record/tape_header.h"

#include <nlohmann/json.hpp>

namespace fulcrum::record {

Result<std::string> tape_header_json(const TapeHeader& header) {
  const nlohmann::ordered_json document = {{"program_version", header.program_version},
                                           {"simd", header.simd},
                                           {"scenario", header.scenario},
                                           {"scenario_file", header.scenario_file},
                                           {"files", header.files},
                                           {"overrides", header.overrides},
                                           {"seed", header.seed},
                                           {"hand", header.hand},
                                           {"device", header.device},
                                           {"tick_s", header.tick_s},
                                           {"hashes", header.hashes}};
  try {
    return document.dump();
  } catch (const nlohmann::json::type_error&) {
    return Error{
        "A tape embeds the scenario's files and --set arguments as UTF-8 text, and one of them is not: save "
        "the "
        "file as UTF-8."};
  }
}

Result<TapeHeader> parse_tape_header(std::string_view json) {
  TapeHeader header;
  try {
    const nlohmann::json document = nlohmann::json::parse(json);
    document.at("program_version").get_to(header.program_version);
    document.at("simd").get_to(header.simd);
    document.at("scenario").get_to(header.scenario);
    document.at("scenario_file").get_to(header.scenario_file);
    document.at("files").get_to(header.files);
    document.at("overrides").get_to(header.overrides);
    document.at("seed").get_to(header.seed);
    document.at("hand").get_to(header.hand);
    document.at("device").get_to(header.device);
    document.at("tick_s").get_to(header.tick_s);
    document.at("hashes").get_to(header.hashes);
  } catch (const nlohmann::json::exception& exception) {
    return Error{exception.what()};
  }
  if (!(header.tick_s > 0 && header.tick_s <= 1)) return Error{"tick_s is not between 0 and 1 s"};
  return header;
}

}  // namespace fulcrum::record

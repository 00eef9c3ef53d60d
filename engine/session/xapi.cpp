#include "engine/session/xapi.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/files/plain_text.h"

namespace fulcrum::session {
namespace {

using StatementJson = nlohmann::ordered_json;

constexpr double kBestScore = 100;
constexpr double kLongest_s = 1e9;  // 30 years: beyond, a clock was wrong

// RFC 3986, 2.3: these stand for themselves in an address; any other byte is written as %XX.
bool stands_for_itself(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
         c == '_' || c == '~';
}

std::string in_address(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const char c : name) {
    if (stands_for_itself(c)) {
      text += c;
      continue;
    }
    const auto byte = static_cast<std::uint8_t>(c);
    text += {'%', kDigits[byte >> 4], kDigits[byte & 15u]};
  }
  return text;
}

// Where a file lies on this machine is nobody's business: often it says who works there.
std::string name_alone(std::string_view name) {
  constexpr std::string_view kFile = "/scenario.yaml";
  if (name.ends_with(kFile)) name.remove_suffix(kFile.size());
  while (name.ends_with('/')) name.remove_suffix(1);
  name.remove_prefix(name.rfind('/') + 1);  // none: 0
  // As parts of an address, dots would lead elsewhere.
  const bool names_something = !name.empty() && name != "." && name != "..";
  return names_something ? plain_text(name) : "unnamed";
}

// ISO 8601, 4.4.3.2. Hundredths: what a store keeps of a duration (part two, 4.6).
std::string duration_text(double duration_s) {
  const double within = duration_s > 0 ? std::min(duration_s, kLongest_s) : 0;  // of no number, too
  const long long hundredths = std::llround(within * 100);
  const std::string rest = std::to_string(100 + hundredths % 100).substr(1);
  return "PT" + std::to_string(hundredths / 100) + '.' + rest + 'S';
}

StatementJson verb_json(bool completed) {
  const std::string word = completed ? "completed" : "terminated";
  return {{"id", "http://adlnet.gov/expapi/verbs/" + word}, {"display", {{"en", word}}}};
}

StatementJson activity_json(const Statement& statement, const std::string& space) {
  const std::string name = name_alone(statement.scenario);
  const bool titled = !statement.scenario_title.empty() && statement.scenario_title != statement.scenario;
  // A person's own scenario, named by its file, is none of those that come with Fulcrum, and its folder may
  // be called as another's is: its title goes into its identifier, too.
  const bool own = statement.scenario.find('/') != std::string::npos || statement.scenario.ends_with(".yaml");
  std::string id = space + (own ? "scenarios/own/" : "scenarios/") + in_address(name);
  if (own && titled) id += '/' + in_address(plain_text(statement.scenario_title));
  return {{"objectType", "Activity"},
          {"id", std::move(id)},
          {"definition",
           {{"name", {{"en", titled ? plain_text(statement.scenario_title) : name}}},
            {"type", "http://adlnet.gov/expapi/activities/simulation"}}}};
}

StatementJson score_json(double score) {
  const double raw = std::clamp(score, 0.0, kBestScore);
  return {{"scaled", raw / kBestScore}, {"raw", raw}, {"min", 0}, {"max", kBestScore}};
}

StatementJson result_json(const Statement& statement, const std::string& extensions) {
  StatementJson result = {{"completion", statement.completed},
                          {"duration", duration_text(statement.duration_s)}};
  if (statement.score && std::isfinite(*statement.score)) result["score"] = score_json(*statement.score);
  for (const auto& [name, value] : statement.metrics)
    if (std::isfinite(value)) result["extensions"][extensions + in_address(plain_text(name))] = value;
  return result;
}

StatementJson context_json(const Statement& statement, const std::string& extensions) {
  StatementJson context = {{"registration", statement.session_uuid},
                           {"platform", plain_text("Fulcrum " + statement.program_version)},
                           {"extensions", {{extensions + "left_handed", statement.left_handed}}}};
  if (!statement.device.empty()) context["extensions"][extensions + "device"] = name_alone(statement.device);
  if (!statement.hand.empty()) context["extensions"][extensions + "hand"] = plain_text(statement.hand);
  return context;
}

}  // namespace

std::string statement_json(const Statement& statement, std::string_view home_page) {
  while (home_page.ends_with('/')) home_page.remove_suffix(1);
  const std::string home(home_page);
  const std::string extensions = home + "/xapi/extensions/";
  const std::string name = statement.participant.empty() ? "anonymous" : plain_text(statement.participant);
  // No version: the store sets it (part two, 2.4.10).
  const StatementJson document = {
      {"id", statement.uuid},
      {"actor", {{"objectType", "Agent"}, {"account", {{"homePage", home}, {"name", name}}}}},
      {"verb", verb_json(statement.completed)},
      {"object", activity_json(statement, home + "/xapi/")},
      {"result", result_json(statement, extensions)},
      {"context", context_json(statement, extensions)},
      {"timestamp", statement.ended_utc}};
  return document.dump(-1, ' ', false, StatementJson::error_handler_t::replace);
}

}  // namespace fulcrum::session

#include "engine/session/xapi.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/session/example_statement.h"
#include "tests/session/xapi_rules.h"

namespace fulcrum::session {
namespace {

using Json = nlohmann::json;
using test::example_statement;
using test::xapi_faults;

const std::string kHome = "https://school.example/training";

std::string listed(const std::vector<std::string>& faults) {
  std::string list;
  for (const std::string& fault : faults) list += fault + '\n';
  return list;
}

Json said_of(const Statement& statement) {
  const std::string text = statement_json(statement, kHome);
  EXPECT_EQ(listed(xapi_faults(text)), "") << text;
  return Json::parse(text);
}

TEST(Xapi, SaysWhoDidWhat) {
  const Json said = said_of(example_statement());
  EXPECT_EQ(said["id"], example_statement().uuid);
  EXPECT_EQ(said["actor"], Json::parse(R"({"objectType": "Agent",
                            "account": {"homePage": "https://school.example/training", "name": "heron"}})"));
  EXPECT_EQ(said["verb"]["id"], "http://adlnet.gov/expapi/verbs/completed");
  EXPECT_EQ(said["object"]["id"], kHome + "/xapi/scenarios/piping");
  EXPECT_EQ(said["object"]["definition"]["name"]["en"], "A nut behind a pipe");
  EXPECT_EQ(said["result"]["score"], Json::parse(R"({"scaled": 0.875, "raw": 87.5, "min": 0, "max": 100})"));
  EXPECT_EQ(said["result"]["completion"], true);
  EXPECT_EQ(said["result"]["duration"], "PT83.46S");
  EXPECT_EQ(said["result"]["extensions"], Json({{kHome + "/xapi/extensions/peak_force_N", 4.5}}));
  EXPECT_EQ(said["context"]["registration"], example_statement().session_uuid);
  EXPECT_EQ(said["context"]["platform"], "Fulcrum 0.1.0");
  EXPECT_EQ(said["context"]["extensions"], Json({{kHome + "/xapi/extensions/left_handed", true},
                                                 {kHome + "/xapi/extensions/device", "omega"}}));
  EXPECT_EQ(said["timestamp"], "2026-03-04T05:06:07.089Z");
}

TEST(Xapi, SaysThatAHandWasSimulated) {
  Statement statement = example_statement();
  statement.hand = "expert";
  EXPECT_EQ(said_of(statement)["context"]["extensions"][kHome + "/xapi/extensions/hand"], "expert");
}

TEST(Xapi, LeavesOutWhatIsNotKnown) {
  Statement statement = example_statement();
  statement.completed = false;
  statement.score.reset();
  statement.metrics.clear();
  statement.device.clear();
  const Json said = said_of(statement);
  EXPECT_EQ(said["verb"]["id"], "http://adlnet.gov/expapi/verbs/terminated");
  EXPECT_EQ(said["result"], Json::parse(R"({"completion": false, "duration": "PT83.46S"})"));
  EXPECT_EQ(said["context"]["extensions"].size(), 1u);
  EXPECT_FALSE(said.contains("version"));
}

TEST(Xapi, IsTheSameTextAgain) {
  EXPECT_EQ(statement_json(example_statement(), kHome), statement_json(example_statement(), kHome + "/"));
}

TEST(Xapi, RoundsDurationsAndBoundsScores) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  Statement statement = example_statement();
  const auto duration = [&](double duration_s) {
    statement.duration_s = duration_s;
    return said_of(statement)["result"]["duration"].get<std::string>();
  };
  EXPECT_EQ(duration(0), "PT0.00S");
  EXPECT_EQ(duration(0.005), "PT0.01S");
  EXPECT_EQ(duration(59.999), "PT60.00S");
  EXPECT_EQ(duration(-1), "PT0.00S");
  EXPECT_EQ(duration(nan), "PT0.00S");
  EXPECT_EQ(duration(infinite), "PT1000000000.00S");
  const auto score = [&](double given) {
    statement.score = given;
    return said_of(statement)["result"].value("score", Json());
  };
  EXPECT_EQ(score(-5)["raw"], 0.0);
  EXPECT_EQ(score(1e300)["scaled"], 1.0);
  EXPECT_TRUE(score(nan).is_null());
  EXPECT_TRUE(score(infinite).is_null());
  statement.metrics = {{"a", nan}, {"b", -infinite}, {"c", 1e308}, {"c", 2}};
  EXPECT_EQ(said_of(statement)["result"]["extensions"], Json({{kHome + "/xapi/extensions/c", 2.0}}));
}

TEST(Xapi, TellsNoPlaceOnThisMachine) {
  Statement statement = example_statement();
  statement.scenario = "/home/anna/courses/valves/scenario.yaml";
  statement.scenario_title = statement.scenario;
  statement.device = "../devices of anna/my arm.yaml";
  const std::string text = said_of(statement).dump();
  EXPECT_EQ(text.find("anna"), std::string::npos) << text;
  EXPECT_NE(text.find("/xapi/scenarios/own/valves\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"my arm.yaml\""), std::string::npos) << text;
  for (const std::string nameless : {"", "/", "..", "a/.", "///"}) {
    statement.scenario = statement.scenario_title = nameless;  // a scenario without a title
    const bool file = nameless.find('/') != std::string::npos;
    EXPECT_EQ(said_of(statement)["object"]["id"],
              kHome + "/xapi/scenarios/" + (file ? "own/" : "") + "unnamed")
        << nameless;
  }
}

TEST(Xapi, TwoScenariosOfOneFolderNameAreTwoActivities) {
  const auto id = [](const char* scenario, const char* title) {
    Statement statement = example_statement();
    statement.scenario = scenario;
    statement.scenario_title = title;
    return said_of(statement)["object"]["id"].get<std::string>();
  };
  const std::string shipped = id("piping", "A spanner behind the pipes");
  const std::string hers = id("/home/anna/piping/scenario.yaml", "Her pipes");
  const std::string his = id("../his/piping/scenario.yaml", "His pipes?");
  EXPECT_NE(shipped, hers);
  EXPECT_NE(hers, his);
  EXPECT_EQ(hers, id("courses/piping/scenario.yaml", "Her pipes")) << "wherever its folder is moved to";
  EXPECT_EQ(hers, id("courses/piping", "Her pipes"));
  EXPECT_EQ(his, kHome + "/xapi/scenarios/own/piping/His%20pipes%3F");
}

// Each name in each place, and every statement keeps the rules.
TEST(Xapi, KeepsTheRulesWhateverThingsAreCalled) {
  const std::string zero("a\0b", 3);
  const std::vector<std::string> names = {"\"quoted\" and 'so'",
                                          "back\\slash",
                                          "</script><b>",
                                          "\xff\xfe",
                                          "half \xe2\x82",
                                          "\xed\xa0\x80 surrogate",
                                          "\xf0\x9f\x94\xa9 and \xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x94\xa7",
                                          "\xd8\xb9\xd8\xb1\xd8\xa8\xd9\x8a",
                                          zero,
                                          "a\nb\r\tc\x1b[31m\x7f\xc2\x9b",
                                          std::string("\xe2\x80") + "\xae turned",
                                          "%00 %zz ?a=b#c",
                                          " ",
                                          std::string(10'000, 'x'),
                                          std::string(10'000, '\xff'),
                                          "null",
                                          "{\"a\": 1}"};
  for (const std::string& name : names) {
    Statement statement = example_statement();
    statement.participant = statement.scenario = statement.scenario_title = statement.device = name;
    statement.program_version = name;
    statement.metrics = {{name, 1}, {name + "2", 2}};
    const std::string text = said_of(statement).dump();
    for (const char c : text) EXPECT_TRUE(c < 0 || c >= ' ') << text;
    EXPECT_EQ(text.find("\\u00"), std::string::npos) << text;
    EXPECT_EQ(text.find("\\n"), std::string::npos) << text;
  }
}

TEST(Xapi, GivesAnonymousWhoHasNoName) {
  Statement statement = example_statement();
  statement.participant.clear();
  EXPECT_EQ(said_of(statement)["actor"]["account"]["name"], "anonymous");
}

}  // namespace
}  // namespace fulcrum::session

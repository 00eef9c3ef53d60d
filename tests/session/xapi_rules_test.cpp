#include "tests/session/xapi_rules.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "engine/session/xapi.h"
#include "tests/session/example_statement.h"
#include "tests/session/xapi_forms.h"

// The rules are only worth something if they refuse what breaks them.
namespace fulcrum::test {
namespace {

using Json = nlohmann::json;

Json good() {
  return Json::parse(session::statement_json(example_statement(), "https://school.example"));
}

struct Change {
  const char* at;     // a JSON pointer
  const char* value;  // in place of what is there; empty: it is removed
};

std::string first_fault(const Json& json) {
  const auto faults = xapi_faults(json.dump());
  return faults.empty() ? "" : faults.front();
}

Json changed(const Change& change) {
  Json json = good();
  const Json::json_pointer at(change.at);
  if (*change.value != '\0')
    json[at] = Json::parse(change.value);
  else
    json[at.parent_pointer()].erase(at.back());
  return json;
}

TEST(XapiRules, TakeOtherGoodStatements) {
  EXPECT_EQ(first_fault(good()), "");
  for (const Change& change : std::vector<Change>{
           {"/actor", R"({"mbox": "mailto:heron@school.example", "name": "Heron"})"},
           {"/actor", R"({"objectType": "Group", "member": [{"openid": "https://heron.example/"}]})"},
           {"/actor", R"({"mbox_sha1sum": "0123456789abcdef0123456789abcdef01234567"})"},
           {"/object/definition/name/de-AT", "\"Mutter\""},
           {"/object/id", "\"urn:example:piping\""},
           {"/object/id", "\"https://school.example/\xc3\xbc\""},
           {"/result/duration", "\"P3Y1M29DT4H35M59.14S\""},
           {"/result/duration", "\"P4W\""},
           {"/result/extensions", R"({"https://school.example/x": null})"},
           {"/result/score", R"({"scaled": -1})"},
           {"/context/contextActivities", R"({"grouping": [{"id": "https://school.example/c"}]})"},
           {"/context/language", "\"sl-rozaj-biske\""},
           {"/version", "\"1.0.0\""},
           {"/timestamp", "\"2024-02-29T23:59:60.123+05:30\""},
           {"/timestamp", ""},
           {"/id", ""}})
    EXPECT_EQ(first_fault(changed(change)), "") << change.at << ' ' << change.value;
}

TEST(XapiRules, RefuseBrokenOnes) {
  for (const Change& change : std::vector<Change>{
           {"/actor", ""},
           {"/verb", ""},
           {"/object", ""},
           {"/id", "\"\""},
           {"/id", "\"6f1c2a34-9d5e-4b0a-0c11-0123456789ab\""},
           {"/id", "\"6f1c2a349d5e4b0a8c110123456789ab\""},
           {"/id", "7"},
           {"/id", "null"},
           {"/more", "1"},
           {"/Actor", "{}"},
           {"/actor/objectType", "\"agent\""},
           {"/actor/objectType", "\"Person\""},
           {"/actor/account", ""},
           {"/actor/account/homePage", ""},
           {"/actor/account/homePage", "\"school.example\""},
           {"/actor/account/homePage", "\"https:///training\""},
           {"/actor/account/name", ""},
           {"/actor/account/name", "5"},
           {"/actor/account/name", "\"\""},
           {"/actor/account/mail", "\"a\""},
           {"/actor/mbox", "\"mailto:heron@school.example\""},
           {"/actor", R"({"mbox": "heron@school.example"})"},
           {"/actor", R"({"mbox_sha1sum": "0123"})"},
           {"/actor", R"({"objectType": "Group"})"},
           {"/actor", R"({"objectType": "Group", "member": [{"objectType": "Group", "member": []}]})"},
           {"/verb/id", ""},
           {"/verb/id", "\"completed\""},
           {"/verb/id", "\"http://adlnet.gov/expapi/verbs/voided\""},
           {"/verb/display", "\"completed\""},
           {"/verb/display/e", "\"completed\""},
           {"/verb/display/en_US", "\"completed\""},
           {"/verb/display/en", "1"},
           {"/object/objectType", "\"activity\""},
           {"/object/objectType", "\"SubStatement\""},
           {"/object/id", ""},
           {"/object/id", "\"/xapi/scenarios/piping\""},
           {"/object/id", "\"https://school.example/a b\""},
           {"/object/id", "\"https://school.example/%zz\""},
           {"/object/definition/type", "\"simulation\""},
           {"/object/definition/title", "{}"},
           {"/result/score/scaled", "1.01"},
           {"/result/score/scaled", "\"0.5\""},
           {"/result/score/raw", "101"},
           {"/result/score/max", "0"},
           {"/result/score/best", "0"},
           {"/result/completion", "\"true\""},
           {"/result/success", "null"},
           {"/result/duration", "12.5"},
           {"/result/duration", "\"12.5\""},
           {"/result/duration", "\"PT\""},
           {"/result/duration", "\"P\""},
           {"/result/duration", "\"P4W1D\""},
           {"/result/duration", "\"PT1.234S\""},
           {"/result/duration", "\"PT-1S\""},
           {"/result/extensions", "[]"},
           {"/result/extensions", R"({"peak": 1})"},
           {"/context/registration", "\"first\""},
           {"/context/language", "\"english language\""},
           {"/context/contextActivities", R"({"course": []})"},
           {"/context/platform", "1"},
           {"/context/statement", R"({"id": "6f1c2a34-9d5e-4b0a-8c11-0123456789ab"})"},
           {"/context/extensions", "null"},
           {"/timestamp", "\"2026-02-29T05:06:07.089Z\""},
           {"/timestamp", "\"2026-03-04 05:06:07.089Z\""},
           {"/timestamp", "\"2026-03-04T25:06:07.089Z\""},
           {"/timestamp", "\"2026-03-04T05:06:07.089-00:00\""},
           {"/timestamp", "\"2026-03-04T05:06:07.089\""},
           {"/timestamp", "1772600767"},
           {"/version", "\"1.0.3\""},
           {"/version", "\"0.95\""},
           {"/attachments", "[]"}})
    EXPECT_NE(first_fault(changed(change)), "") << change.at << ' ' << change.value;
}

TEST(XapiRules, KnowWhatIsOfActivitiesAlone) {
  Json json = good();
  json["object"] =
      Json::parse(R"({"objectType": "StatementRef", "id": "6f1c2a34-9d5e-4b0a-8c11-0123456789ab"})");
  EXPECT_EQ(first_fault(json), "context.platform: is of activities alone");
  json["context"].erase("platform");
  EXPECT_EQ(first_fault(json), "");
}

TEST(XapiRules, RefuseWhatIsNoJson) {
  const std::string whole = good().dump();
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("7"), whole.substr(1), whole + whole,
        "{\"id\": \"6f1c2a34-9d5e-4b0a-8c11-0123456789ab\", " + whole.substr(1),
        "{\"\xff\": 1, " + whole.substr(1)})
    EXPECT_FALSE(xapi_faults(text).empty()) << text;
}

}  // namespace
}  // namespace fulcrum::test

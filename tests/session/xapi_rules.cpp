#include "tests/session/xapi_rules.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/session/xapi_forms.h"

namespace fulcrum::test {
namespace {

using Json = nlohmann::json;
using Rule = std::function<void(const Json&, const std::string& at)>;

struct Property {
  std::string name;
  Rule rule;
  bool required = false;
};

class Judge {
public:
  std::vector<std::string> faults;

  void statement(const Json& json) {
    if (!json.is_object()) return fault("the statement", "is no object");
    of_activity_ = !json.contains("object") || !json["object"].is_object() ||
                   json["object"].value("objectType", Json("Activity")) == "Activity";
    properties(json, "",
               {{"id", form(is_xapi_uuid, "UUID")},
                {"actor", [this](auto& j, auto& at) { actor(j, at); }, true},
                {"verb", [this](auto& j, auto& at) { verb(j, at); }, true},
                {"object", [this](auto& j, auto& at) { object(j, at); }, true},
                {"result", [this](auto& j, auto& at) { result(j, at); }},
                {"context", [this](auto& j, auto& at) { context(j, at); }},
                {"timestamp", form(is_xapi_timestamp, "timestamp")},
                {"stored", form(is_xapi_timestamp, "timestamp")},
                {"authority", [this](auto& j, auto& at) { actor(j, at); }},
                {"version", one_of({"1.0.0"})}});
    const Json* const verb_id = found(json, "verb", "id");
    const Json* const type = found(json, "object", "objectType");
    if (verb_id != nullptr && *verb_id == "http://adlnet.gov/expapi/verbs/voided" &&
        (type == nullptr || *type != "StatementRef"))
      fault("object", "must be a StatementRef where the verb is voided");
  }

private:
  bool of_activity_ = false;

  void fault(const std::string& at, const std::string& what) { faults.push_back(at + ": " + what); }

  static std::string below(const std::string& at, const std::string& key) {
    return at.empty() ? key : at + '.' + key;
  }

  static const Json* found(const Json& json, const char* outer, const char* inner) {
    if (!json.contains(outer) || !json[outer].is_object() || !json[outer].contains(inner)) return nullptr;
    return &json[outer][inner];
  }

  // An object of these properties and no others.
  void properties(const Json& json, const std::string& at, const std::vector<Property>& known) {
    if (!json.is_object()) return fault(at, "is no object");
    for (const auto& [key, value] : json.items()) {
      const auto property = std::ranges::find(known, key, &Property::name);
      if (property == known.end())
        fault(below(at, key), "is not known");
      else if (value.is_null())
        fault(below(at, key), "is null");
      else
        property->rule(value, below(at, key));
    }
    for (const Property& property : known)
      if (property.required && !json.contains(property.name)) fault(below(at, property.name), "is missing");
  }

  Rule text() {
    return [this](auto& j, auto& at) {
      if (!j.is_string()) fault(at, "is no text");
    };
  }
  Rule boolean() {
    return [this](auto& j, auto& at) {
      if (!j.is_boolean()) fault(at, "is neither true nor false");
    };
  }
  Rule form(bool (*is)(const std::string&), const char* what) {
    return [this, is, what](auto& j, auto& at) {
      if (!j.is_string() || !is(j.template get<std::string>())) fault(at, std::string("is no ") + what);
    };
  }
  Rule one_of(const std::vector<std::string>& words) {
    return [this, words](auto& j, auto& at) {
      if (std::find(words.begin(), words.end(), j) == words.end()) fault(at, "is none of its words");
    };
  }

  void language_map(const Json& json, const std::string& at) {
    if (!json.is_object()) return fault(at, "is no language map");
    for (const auto& [tag, value] : json.items()) {
      if (!is_language_tag(tag)) fault(below(at, tag), "is no language");
      if (!value.is_string()) fault(below(at, tag), "is no text");
    }
  }
  Rule languages() {
    return [this](auto& j, auto& at) { language_map(j, at); };
  }

  // Their values are anybody's, null as well.
  Rule extensions() {
    return [this](auto& j, auto& at) {
      if (!j.is_object()) return fault(at, "is no object");
      for (const auto& [key, value] : j.items())
        if (!is_iri(key)) fault(at, "has the key '" + key + "', which is no IRI");
    };
  }

  void actor(const Json& json, const std::string& at) {
    if (json.is_object() && json.value("objectType", Json("Agent")) == "Group") return group(json, at);
    agent(json, at);
  }

  static int identifiers(const Json& json) {
    int count = 0;
    for (const char* const name : {"mbox", "mbox_sha1sum", "openid", "account"})
      count += json.is_object() && json.contains(name);
    return count;
  }

  std::vector<Property> of_somebody(const char* type) {
    return {{"objectType", one_of({type})},
            {"name", text()},
            {"mbox", form(is_mailto, "mailto IRI")},
            {"mbox_sha1sum", form(
                                 [](auto& t) {
                                   return t.size() == 40 &&
                                          t.find_first_not_of("0123456789abcdefABCDEF") == t.npos;
                                 },
                                 "SHA-1")},
            {"openid", form(is_irl, "URI")},
            {"account",
             [this](auto& j, auto& at) {
               properties(j, at,
                          {{"homePage", form(is_irl, "IRL"), true},
                           {"name", form([](auto& t) { return !t.empty(); }, "name"), true}});
             }}};
  }

  void agent(const Json& json, const std::string& at) {
    properties(json, at, of_somebody("Agent"));
    if (identifiers(json) != 1) fault(at, "must have one identifier");
  }

  void group(const Json& json, const std::string& at) {
    std::vector<Property> known = of_somebody("Group");
    known.push_back({"member", [this](auto& j, auto& where) {
                       if (!j.is_array()) return fault(where, "is no list");
                       for (const Json& one : j) agent(one, where);
                     }});
    properties(json, at, known);
    const int count = identifiers(json);
    if (count > 1 || (count == 0 && !json.contains("member")))
      fault(at, "must have one identifier or members");
  }

  void verb(const Json& json, const std::string& at) {
    properties(json, at, {{"id", form(is_iri, "IRI"), true}, {"display", languages()}});
  }

  void object(const Json& json, const std::string& at) {
    const Json type = json.is_object() ? json.value("objectType", Json("Activity")) : Json();
    if (type == "Agent" || type == "Group") return actor(json, at);
    if (type == "StatementRef") return reference(json, at);
    activity(json, at);
  }

  void reference(const Json& json, const std::string& at) {
    properties(json, at,
               {{"objectType", one_of({"StatementRef"}), true}, {"id", form(is_xapi_uuid, "UUID"), true}});
  }

  void activity(const Json& json, const std::string& at) {
    properties(json, at,
               {{"objectType", one_of({"Activity"})},
                {"id", form(is_iri, "IRI"), true},
                {"definition",
                 [this](auto& j, auto& where) {
                   properties(j, where,
                              {{"name", languages()},
                               {"description", languages()},
                               {"type", form(is_iri, "IRI")},
                               {"moreInfo", form(is_irl, "IRL")},
                               {"extensions", extensions()}});
                 }}});
  }

  void result(const Json& json, const std::string& at) {
    properties(json, at,
               {{"score", [this](auto& j, auto& where) { score(j, where); }},
                {"success", boolean()},
                {"completion", boolean()},
                {"response", text()},
                {"duration", form(is_xapi_duration, "duration")},
                {"extensions", extensions()}});
  }

  void score(const Json& json, const std::string& at) {
    const Rule number = [this](auto& j, auto& where) {
      if (!j.is_number()) fault(where, "is no number");
    };
    properties(json, at, {{"scaled", number}, {"raw", number}, {"min", number}, {"max", number}});
    if (!json.is_object()) return;
    const auto has = [&](const char* name) { return json.contains(name) && json[name].is_number(); };
    const auto beyond = [&](const char* less, const char* more) {
      return has(less) && has(more) && json[less].get<double>() > json[more].get<double>();
    };
    if (has("scaled") && !(json["scaled"] >= -1 && json["scaled"] <= 1))
      fault(at + ".scaled", "is not within -1 and 1");
    if (has("min") && has("max") && json["min"] >= json["max"]) fault(at + ".min", "is not below max");
    if (beyond("min", "raw") || beyond("raw", "max")) fault(at + ".raw", "is not within min and max");
  }

  void context(const Json& json, const std::string& at) {
    properties(json, at,
               {{"registration", form(is_xapi_uuid, "UUID")},
                {"instructor", [this](auto& j, auto& where) { actor(j, where); }},
                {"team", [this](auto& j, auto& where) { group(j, where); }},
                {"contextActivities", [this](auto& j, auto& where) { context_activities(j, where); }},
                {"revision", text()},
                {"platform", text()},
                {"language", form(is_language_tag, "language")},
                {"statement", [this](auto& j, auto& where) { reference(j, where); }},
                {"extensions", extensions()}});
    for (const char* const name : {"revision", "platform"})
      if (!of_activity_ && json.is_object() && json.contains(name))
        fault(at + '.' + name, "is of activities alone");
  }

  void context_activities(const Json& json, const std::string& at) {
    const Rule activities = [this](auto& j, auto& where) {
      if (!j.is_array()) return activity(j, where);
      for (const Json& one : j) activity(one, where);
    };
    properties(
        json, at,
        {{"parent", activities}, {"grouping", activities}, {"category", activities}, {"other", activities}});
  }
};

// A key that comes twice in an object, which a parsed document no longer shows.
class TwiceFinder {
public:
  std::vector<std::string> faults;
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second)
      faults.push_back(parsed.get<std::string>() + ": comes twice");
    return true;
  }

private:
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

std::vector<std::string> xapi_faults(std::string_view statement_json) {
  TwiceFinder twice;
  const Json json = Json::parse(statement_json, std::ref(twice), false);
  if (json.is_discarded()) return {"the statement: is no JSON"};
  Judge judge;
  judge.faults = std::move(twice.faults);
  judge.statement(json);
  return std::move(judge.faults);
}

}  // namespace fulcrum::test

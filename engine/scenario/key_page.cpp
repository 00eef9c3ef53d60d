#include "engine/scenario/key_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/scenario/schema.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {
namespace {

using Json = nlohmann::ordered_json;

std::string number_word(const Json& value) {
  return value.is_number_integer() ? value.dump() : number_text(value.get<double>());
}

std::string range_words(const Json& schema) {
  const bool below = schema.contains("minimum") || schema.contains("exclusiveMinimum");
  const std::string low = schema.contains("minimum") ? number_word(schema["minimum"])
                          : schema.contains("exclusiveMinimum")
                              ? "above " + number_word(schema["exclusiveMinimum"])
                              : "";
  // What no person writes is no limit.
  const bool above = schema.contains("maximum") && schema["maximum"].get<double>() < 1e18;
  if (below && above)
    return low + (schema.contains("minimum") ? " to " : ", at most ") + number_word(schema["maximum"]);
  if (below) return schema.contains("minimum") ? "at least " + low : low;
  return above ? "at most " + number_word(schema["maximum"]) : "a number";
}

// What may be written for a value that is no mapping.
std::string value_words(const Json& schema) {
  if (schema.contains("enum")) {
    std::string words;
    for (const Json& name : schema["enum"])
      words += (words.empty() ? "`" : ", `") + name.get<std::string>() + "`";
    return words;
  }
  if (schema.contains("const")) return "`" + schema["const"].dump() + "`";
  const std::string type = schema.value("type", "");
  if (type == "number" || type == "integer") return range_words(schema);
  if (type == "boolean") return "`true`, `false`";
  if (type == "string") {
    const std::string pattern = schema.value("pattern", "");
    return pattern.empty() ? "text" : pattern.starts_with("^#") ? "`\"#rrggbb\"`" : "a word";
  }
  if (type == "array") {
    const auto least = schema.value("minItems", 0), most = schema.value("maxItems", 0);
    const std::string count = least == most ? std::to_string(least) : "up to " + std::to_string(most);
    return "a list of " + count +
           (schema["items"].contains("minimum") ? ", each " + range_words(schema["items"]) : "");
  }
  return "";
}

std::string choice_words(const Json& schema) {
  std::string words;
  for (const Json& form : schema["oneOf"])
    if (const std::string each = value_words(form); !each.empty())
      words += (words.empty() ? "" : "; or ") + each;
  return words;
}

std::string default_words(const Json& schema) {
  if (!schema.contains("default") || schema["default"] == "") return "";
  const Json& value = schema["default"];
  if (value.is_string()) return "`" + value.get<std::string>() + "`";
  if (value.is_number()) return number_word(value);
  if (!value.is_array()) return value.dump();
  std::string words;
  for (const Json& each : value) words += (words.empty() ? "[" : ", ") + number_word(each);
  return words + "]";
}

// Within a table's cell.
std::string cell(std::string text) {
  for (std::size_t i = 0; (i = text.find('|', i)) != text.npos; i += 2) text.insert(i, 1, '\\');
  return text;
}

class Page {
public:
  void add_file(std::string_view title, std::string_view about, const std::string& schema_text) {
    text_ += "\n## " + std::string(title) + "\n\n" + std::string(about) + "\n\n";
    begin_table();
    add_rows(Json::parse(schema_text), "", false);
    // Each mapping of the file's own has a table of its own.
    for (std::size_t i = 0; i < later_.size(); ++i) {
      const Section section = later_[i];
      text_ += "\n### " + section.path + "\n\n" + sentence(section.about) + "\n\n";
      begin_table();
      add_rows(section.schema, "", true);
    }
    later_.clear();
  }
  std::string take() { return std::move(text_); }

private:
  struct Section {
    std::string path, about;
    Json schema;
  };

  static std::string sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text + ".";
  }

  void begin_table() { text_ += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n"; }

  void add_row(const std::string& path, const std::string& value, const std::string& otherwise,
               const std::string& meaning) {
    text_ += "| `" + path + "` | " + cell(value) + " | " + otherwise + " | " + cell(meaning) + " |\n";
  }

  // The mapping that elements of a list, entries of a mapping or the value itself are; null: none.
  static const Json* inner_of(const Json& property) {
    if (property.contains("properties")) return &property;
    if (property.contains("items") && property["items"].contains("properties")) return &property["items"];
    if (property.contains("additionalProperties") && property["additionalProperties"].is_object())
      return &property["additionalProperties"];
    return nullptr;
  }
  static std::string kind_of(const Json& property) {
    if (property.contains("properties")) return "a mapping";
    return property.contains("items") ? "a list of mappings" : "mappings, each under a name of its own";
  }
  static bool has_forms(const Json& property) {
    return property.contains("oneOf") && property["oneOf"][0].contains("properties");
  }

  // within: of a table that is a mapping's own; deeper ones stand in it with a dotted path.
  void add_rows(const Json& mapping, const std::string& prefix, bool within) {
    const Json required = mapping.value("required", Json::array());
    for (const auto& [name, property] : mapping["properties"].items()) {
      const std::string path = prefix + name;
      const std::string meaning = property.value("description", "");
      const bool wanted = std::find(required.begin(), required.end(), Json(name)) != required.end();
      const std::string otherwise = wanted ? "**required**" : default_words(property);
      const Json* inner = inner_of(property);
      if (has_forms(property)) {
        add_row(path, value_words(property["oneOf"].back()), otherwise, meaning);
        add_forms(property, path, within);
      } else if (inner != nullptr) {
        add_row(path, kind_of(property), otherwise, meaning);
        if (within)
          add_rows(*inner, path + ".", true);
        else
          later_.push_back({path, meaning, *inner});
      } else {
        add_row(path, property.contains("oneOf") ? choice_words(property) : value_words(property), otherwise,
                meaning);
      }
    }
  }

  void add_forms(const Json& property, const std::string& path, bool within) {
    for (const Json& form : property["oneOf"]) {
      if (!form.contains("properties")) continue;
      if (within)
        add_rows(form, path + ".", true);
      else
        later_.push_back({path + ": " + name_of_form(form), form.value("description", ""), form});
    }
  }
  static std::string name_of_form(const Json& form) {
    for (const auto& [name, property] : form["properties"].items())
      if (property.contains("const")) return property["const"].get<std::string>();
    return "";
  }

  std::string text_;
  std::vector<Section> later_;
};

}  // namespace

std::string key_page() {
  Page page;
  page.add_file("scenario.yaml", "The scenario itself.", scenario_schema());
  page.add_file("A hand's path", "The file that `path` of a hand names.", hand_path_schema());
  page.add_file("A device", "`devices/NAME.yaml`, of the content or of the scenario's own folder.",
                device_schema());
  page.add_file("A material", "`materials/NAME.yaml`: what a blow on it sounds and feels like.",
                material_schema());
  return "# Every key\n\nWritten by `fulcrum schema page`. Lengths are metres, angles that end in `_deg` "
         "degrees, all else "
         "SI; a unit stands before the meaning. What is not named is not built.\n" +
         page.take();
}

}  // namespace fulcrum::scenario

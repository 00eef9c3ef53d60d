#include "engine/scenario/schema_writer.h"

#include <cmath>
#include <string>
#include <utility>

namespace fulcrum::scenario {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kWordPattern = "^[A-Za-z0-9_-]+$";
constexpr const char* kHexPattern = "^#[0-9A-Fa-f]{6}$";

Json number_schema(const Range& range) {
  Json schema{{"type", "number"}};
  if (std::isfinite(range.min)) schema[range.above_min ? "exclusiveMinimum" : "minimum"] = range.min;
  if (std::isfinite(range.max)) schema["maximum"] = range.max;
  return schema;
}

Json numbers_schema(std::size_t count, const Range& each) {
  return {{"type", "array"}, {"items", number_schema(each)}, {"minItems", count}, {"maxItems", count}};
}

Json colour_schema() {
  return {{"oneOf",
           Json::array({Json{{"type", "string"}, {"pattern", kHexPattern}}, numbers_schema(3, kFraction)})}};
}

Json names_schema(std::span<const std::string_view> names) {
  Json schema{{"enum", Json::array()}};
  for (const std::string_view name : names) schema["enum"].push_back(name);
  return schema;
}

// One mapping: an object schema with the properties that are described to it.
class ObjectWriter final : public KeyVisitor {
public:
  void version(const Key& key, std::int64_t version) override { add(key, {{"const", version}}); }
  void number(const Key& key, double& value, const Range& range) override {
    add(key, number_schema(range), value);
  }
  void optional_number(const Key& key, std::optional<double>&, const Range& range) override {
    add(key, number_schema(range));
  }
  void integer(const Key& key, std::int64_t& value, std::int64_t min, std::int64_t max) override {
    add(key, {{"type", "integer"}, {"minimum", min}, {"maximum", max}}, value);
  }
  void boolean(const Key& key, bool& value) override { add(key, {{"type", "boolean"}}, value); }
  void text(const Key& key, std::string& value) override {
    add(key, {{"type", "string"}, {"minLength", 1}}, value);
  }
  void word(const Key& key, std::string& value) override {
    add(key, {{"type", "string"}, {"pattern", kWordPattern}}, value);
  }
  void choice(const Key& key, std::size_t& index, std::span<const std::string_view> names) override {
    add(key, names_schema(names), index < names.size() ? Json(names[index]) : Json(nullptr));
  }
  void vector(const Key& key, Vec3& value, const Range& each) override {
    add(key, numbers_schema(3, each), {value.x(), value.y(), value.z()});
  }
  void numbers(const Key& key, std::vector<double>&, const Range& each, std::size_t most) override {
    add(key, {{"type", "array"}, {"items", number_schema(each)}, {"minItems", 1}, {"maxItems", most}});
  }
  void each_axis(const Key& key, Vec3& value, const Range& each) override {
    add(key, {{"oneOf", Json::array({number_schema(each), numbers_schema(3, each)})}},
        {value.x(), value.y(), value.z()});
  }
  void rotation(const Key& key, Quat& value) override {
    add(key, numbers_schema(4, kAnyNumber), {value.w(), value.x(), value.y(), value.z()});
  }
  void colour(const Key& key, Vec3& value) override {
    add(key, colour_schema(), {value.x(), value.y(), value.z()});
  }
  void optional_colour(const Key& key, std::optional<Vec3>&) override { add(key, colour_schema()); }
  void file(const Key& key, FileRef&) override { add(key, {{"type", "string"}, {"minLength", 1}}); }

  void mapping(const Key& key, const Describe& describe) override { add(key, object_of(describe)); }

  void forms(const Key& key, const Key& selector, std::size_t& index, std::span<const Form> forms) override {
    Json variants = Json::array();
    Json names = Json::array();
    for (const Form& form : forms) {
      ObjectWriter inner;
      inner.add(selector, {{"const", form.name}});
      form.describe(inner);
      Json object = inner.take();
      object["description"] = form.doc;
      if (&form != &forms[index]) object["required"].push_back(selector.name);
      variants.push_back(std::move(object));
      names.push_back(form.name);
    }
    variants.push_back({{"enum", names}});
    add(key, {{"oneOf", variants}});
  }

  void list(const Key& key, std::size_t min_count, const Describe& describe_next) override {
    add(key, {{"type", "array"}, {"items", object_of(describe_next)}, {"minItems", min_count}});
  }

  void named(const Key& key, std::size_t min_count,
             const std::function<void(std::string_view, KeyVisitor&)>& describe_next) override {
    const Describe describe = [&](KeyVisitor& inner) { describe_next("", inner); };
    add(key,
        {{"type", "object"}, {"additionalProperties", object_of(describe)}, {"minProperties", min_count}});
  }

  using KeyVisitor::colour;
  using KeyVisitor::vector;

  Json take() {
    Json object{{"type", "object"}, {"properties", std::move(properties_)}, {"additionalProperties", false}};
    if (!required_.empty()) object["required"] = std::move(required_);
    return object;
  }

private:
  static Json object_of(const Describe& describe) {
    ObjectWriter inner;
    describe(inner);
    return inner.take();
  }

  void add(const Key& key, Json schema, const Json& default_value = nullptr) {
    std::string description(key.doc);
    if (!key.unit.empty()) description = std::string(key.unit) + "; " + description;
    schema["description"] = description;
    if (key.required)
      required_.push_back(key.name);
    else if (!default_value.is_null())
      schema["default"] = default_value;
    properties_[std::string(key.name)] = std::move(schema);
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
};

}  // namespace

nlohmann::ordered_json write_schema(std::string_view title, const Describe& describe) {
  ObjectWriter writer;
  describe(writer);
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  schema.update(writer.take());
  return schema;
}

}  // namespace fulcrum::scenario

#include "engine/assets/gltf_light.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/files/plain_text.h"

namespace fulcrum {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";
constexpr double kFarthestLight_m = 1e5;  // as vertices are held to
constexpr float kLargestColour = 1e4F;

class LightReader {
public:
  // written: the same as the file has it. name: what sentences call it.
  LightReader(const tinygltf::Light& source, const tinygltf::Value& written, std::string name)
      : source_(source), written_(written), name_(std::move(name)) {}

  ModelLight read() {
    ModelLight light;
    light.name = name_;
    light.kind = kind();
    read_colour(light);
    // However bright: what it is in candela, the file's unit says, which the scenario knows.
    light.intensity = number("intensity", source_.intensity);
    if (light.kind != ModelLight::Kind::directional && written_.Has("range")) {
      light.range = number("range", source_.range);
      if (*light.range == 0.0) refuse("a range of zero");
    }
    if (light.kind == ModelLight::Kind::spot) read_cones(light);
    return light;
  }

private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw GltfFault("its light " + name_in_quotes(name_) + " has " + what +
                    "; correct it and export it again");
  }

  ModelLight::Kind kind() const {
    if (source_.type == "directional") return ModelLight::Kind::directional;
    if (source_.type == "point") return ModelLight::Kind::point;
    if (source_.type == "spot") return ModelLight::Kind::spot;
    throw GltfFault("its light " + name_in_quotes(name_) + " is of a type that " + kExtension +
                    " does not have; export it as directional, point or spot");
  }

  // tinygltf passes over what is no number.
  double number(const char* key, double read) const {
    if (written_.Has(key) && !written_.Get(key).IsNumber())
      refuse(std::string("a value of '") + key + "' that is no number");
    if (!std::isfinite(read) || read < 0.0)
      refuse(std::string("a value of '") + key + "' that is less than zero or not finite");
    return read;
  }

  void read_colour(ModelLight& light) const {
    if (!written_.Has("color")) return;
    if (source_.color.size() != 3) refuse("a colour that is not of three numbers");
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = source_.color[i];
      if (!std::isfinite(part) || part < 0.0 || part > static_cast<double>(kLargestColour))
        refuse("a colour that is less than zero or out of all bounds");
      light.colour[i] = static_cast<float>(part);
    }
  }

  void read_cones(ModelLight& light) const {
    constexpr double kWidest = std::numbers::pi / 2 + 1e-6;  // files round it
    const tinygltf::Value& cones = written_.Get("spot");
    for (const char* key : {"innerConeAngle", "outerConeAngle"})
      if (cones.Has(key) && !cones.Get(key).IsNumber())
        refuse(std::string("a value of '") + key + "' that is no number");
    light.inner_cone = source_.spot.innerConeAngle;
    light.outer_cone = source_.spot.outerConeAngle;
    if (!(light.outer_cone > 0.0 && light.outer_cone <= kWidest))
      refuse("an outer cone that is not of more than 0 and at most pi / 2");
    if (!(light.inner_cone >= 0.0 && light.inner_cone <= light.outer_cone))
      refuse("an inner cone that is less than zero or wider than the outer one");
  }

  const tinygltf::Light& source_;
  const tinygltf::Value& written_;
  std::string name_;
};

// The file's index of the node's light; none: it has none.
std::optional<std::size_t> index_of(const tinygltf::Model& file, const tinygltf::Node& node) {
  const auto found = node.extensions.find(kExtension);
  if (found == node.extensions.end()) return std::nullopt;
  const tinygltf::Value& value = found->second;
  const int index = value.IsObject() && value.Has("light") && value.Get("light").IsInt()
                        ? value.Get("light").Get<int>()
                        : -1;
  if (index < 0 || static_cast<std::size_t>(index) >= file.lights.size())
    throw GltfFault(
        "node " +
        (node.name.empty() ? std::to_string(&node - file.nodes.data()) : name_in_quotes(node.name)) +
        " refers to a light that the file does not hold; export it again");
  return static_cast<std::size_t>(index);
}

// Turned and moved; its numbers stay, however the node is scaled (KHR_lights_punctual, "Adding Light
// Instances to Nodes").
void place(ModelLight& light, const Eigen::Affine3d& X_MN) {
  light.position_M = X_MN.translation();
  if (!(light.position_M.cwiseAbs().maxCoeff() <= kFarthestLight_m))
    throw GltfFault("its light " + name_in_quotes(light.name) +
                    " is moved out of all bounds, farther than 100 km; check its node's transform");
  if (light.kind == ModelLight::Kind::point) return;
  const Vec3 along = X_MN.linear() * light.direction_M;
  const double length = along.stableNorm();
  if (!(length > 0.0 && std::isfinite(length)))
    throw GltfFault("its light " + name_in_quotes(light.name) +
                    " has no direction; give its node a scale other than zero");
  light.direction_M = along / length;
}

}  // namespace

std::optional<ModelLight> light_of(const tinygltf::Model& file, const tinygltf::Node& node,
                                   const Eigen::Affine3d& X_MN) {
  const std::optional<std::size_t> index = index_of(file, node);
  if (!index) return std::nullopt;
  // Where there are lights, tinygltf has read them from there.
  const tinygltf::Value& written = file.extensions.at(kExtension).Get("lights").Get(static_cast<int>(*index));
  const tinygltf::Light& source = file.lights[*index];
  const std::string name = !source.name.empty() ? source.name
                           : !node.name.empty() ? node.name
                                                : std::to_string(*index);
  ModelLight light = LightReader(source, written, plain_text(name)).read();
  place(light, X_MN);
  return light;
}

}  // namespace fulcrum

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "engine/scenario/describe.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// An angle that is written in degrees and kept in radians; the default is rounded to a whole degree.
void describe_degrees(KeyVisitor& visitor, const Key& key, float& radians, const Range& range) {
  double degrees = std::round(widened(radians) / kDegree);
  visitor.number(key, degrees, range);
  radians = static_cast<float>(degrees * kDegree);
}

void describe_metres(KeyVisitor& visitor, const Key& key, std::optional<float>& length, const Range& range) {
  std::optional<double> read;
  visitor.optional_number(key, read, range);
  if (read) length = static_cast<float>(*read);
}

void describe_eyes(KeyVisitor& visitor, render::EyePair& eyes) {
  describe_metres(visitor, {"eye_distance", "m", "between them, in the scene; none: what suits the picture"},
                  eyes.distance, from_to(0, 10));
  describe_metres(
      visitor, {"convergence", "m", "from 'eye' to the plane that is seen at the screen; none: the target's"},
      eyes.convergence, from_to(0.001, 1000));
}

void describe_views(KeyVisitor& visitor, std::vector<View>& views) {
  std::set<std::string> names;
  visitor.list(
      {"views", "", "cameras by name; the first is where a window starts", true}, 1, [&](KeyVisitor& each) {
        View& view = views.emplace_back();
        each.word({"name", "", "as --view and panels call it", true}, view.name);
        each.rule("name", names.insert(view.name).second, "is the name of an earlier view; choose another");
        each.vector({"eye", "m", "in the world", true}, view.camera.eye, kPosition);
        each.vector({"target", "m", "in the world", true}, view.camera.target, kPosition);
        each.rule("target", view.camera.eye != view.camera.target,
                  "is where the eye is; there is no direction to look in");
        describe_degrees(each, {"fov_deg", "", "vertical field of view"}, view.camera.vertical_fov_rad,
                         from_to(1, 150));
        each.mapping({"stereo", "", "the two eyes that --stereo draws for"},
                     [&](KeyVisitor& inner) { describe_eyes(inner, view.camera.eyes); });
        each.boolean({"cut", "", "shows the models cut open that have a model 'cut_of' them"}, view.cut);
      });
}

void describe_beam(KeyVisitor& visitor, render::KeyLight& light) {
  visitor.vector({"direction", "", "the way the light travels; of any length"}, light.direction, kPosition);
  visitor.rule("direction", light.direction != glm::vec3(0.0F), "must not be [0, 0, 0]");
  visitor.colour({"colour", "", "of the light"}, light.colour);
  visitor.real(
      {"diameter", "m",
       "of its disc, if directional as seen from 1 m; the wider, the softer are shadows; 0: all hard"},
      light.diameter, from_to(0, 2));
  visitor.boolean({"shadow", "", "it throws shadows"}, light.casts_shadow);
}

void describe_light(KeyVisitor& visitor, std::optional<render::KeyLight>& light) {
  enum : std::size_t { kDirectional, kSpot, kNone };
  render::KeyLight beam = light.value_or(render::KeyLight{});
  const Form directional{"directional", "from infinitely far away", [&](KeyVisitor& each) {
                           describe_beam(each, beam);
                           each.real({"intensity", "", "a white matt surface that faces it reads this value"},
                                     beam.intensity, from_to(0, 1000));
                         }};
  const Form spot{
      "spot", "from a place, in a cone", [&](KeyVisitor& each) {
        each.vector({"position", "m", "in the world"}, beam.position, kPosition);
        describe_beam(each, beam);
        each.real({"intensity", "", "what a white matt surface that faces it at 1 m reads"}, beam.intensity,
                  from_to(0, 1000));
        describe_degrees(each, {"cone_deg", "", "full angle of the cone"}, beam.cone_rad, from_to(1, 170));
      }};
  const Form none{"none", "ambient light alone", [](KeyVisitor&) {}};
  std::size_t kind = kDirectional;
  visitor.forms({"light", "", "the one light that throws shadows"}, {"kind", "", "what light it is"}, kind,
                std::array{directional, spot, none});
  beam.kind = kind == kSpot ? render::KeyLight::Kind::spot : render::KeyLight::Kind::directional;
  light = kind == kNone ? std::optional<render::KeyLight>() : beam;
}

void describe_ambient(KeyVisitor& visitor, Scenario& scenario) {
  enum : std::size_t { kStudio, kPicture };
  render::Ambient& ambient = scenario.ambient;
  SurroundingsEntry around;
  const Form studio{"studio", "a sky, a ground and soft boxes", [&](KeyVisitor& each) {
                      each.colour({"sky", "", "from above"}, ambient.sky);
                      each.colour({"ground", "", "from below"}, ambient.ground);
                      each.real({"intensity", "", "times both"}, ambient.intensity, from_to(0, 1000));
                    }};
  const Form picture{
      "picture", "a picture of all around", [&](KeyVisitor& each) {
        each.file(
            {"file", "",
             "an equirectangular .hdr in the scenario's folder, at most 4096 x 2048; its middle is seen "
             "towards +x",
             true},
            around.file);
        each.real({"intensity", "", "times what the picture has"}, ambient.intensity, from_to(0, 1000));
        describe_degrees(each, {"turn_deg", "", "about the vertical, against the clock from above"},
                         around.turn, from_to(-360, 360));
        each.boolean({"seen", "", "behind the scene, in place of the background"}, around.seen);
      }};
  std::size_t kind = kStudio;
  visitor.forms({"ambient", "", "light from everywhere else"}, {"kind", "", "where it comes from"}, kind,
                std::array{studio, picture});
  if (kind == kPicture) scenario.surroundings = std::move(around);
}

void describe_guide(KeyVisitor& visitor, GuideDesc& guide) {
  visitor.vector({"from", "m", "where it sets out, in the world", true}, guide.from_W, kPosition);
  visitor.vector({"to", "m", "where it turns back", true}, guide.to_W, kPosition);
  visitor.rule("to", guide.from_W != guide.to_W, "is where 'from' is; there is no way to go");
  visitor.number({"speed", "m/s", "in the middle of its way; it sets out and stops as a hand does"},
                 guide.speed, above_to(0, 100));
  visitor.number({"wait", "s", "before it sets out for the first time"}, guide.wait, from_to(0, 600));
  visitor.number({"rest", "s", "at either end"}, guide.rest, from_to(0, 600));
  visitor.number({"radius", "m", "of the ball"}, guide.radius, above_to(0, 10));
}

}  // namespace

void describe_look(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping({"guide", "", "a ball that is seen going to and fro, for the hand to go with"},
                  [&](KeyVisitor& inner) { describe_guide(inner, scenario.guide.emplace()); });
  describe_views(visitor, scenario.views);
  describe_light(visitor, scenario.light);
  describe_ambient(visitor, scenario);
  visitor.mapping({"background", "", "what is seen where nothing is"}, [&](KeyVisitor& inner) {
    inner.colour({"top", "", "of the picture"}, scenario.background.top);
    inner.colour({"bottom", "", "of the picture"}, scenario.background.bottom);
  });
}

}  // namespace fulcrum::scenario

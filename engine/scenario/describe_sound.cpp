#include "engine/scenario/describe.h"

namespace fulcrum::scenario {

std::initializer_list<std::string_view> sound_material_key() {
  static const std::initializer_list<std::string_view> kKey{"sound", "material"};
  return kKey;
}

void describe_sound(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping(
      {"sound", "", "blows, sliding and what the task says are heard; without it there is silence"},
      [&](KeyVisitor& inner) {
        SoundEntry& sound = scenario.sound.emplace();
        inner.number({"gain", "", "of blows and sliding"}, sound.gain, kFraction);
        inner.number({"pitch", "", "times the frequencies of materials, by which a hand is shaken"},
                     sound.pitch, from_to(1, 100));
        inner.number({"slide", "", "of sliding beside blows; 0: none is built"}, sound.slide, kFraction);
        inner.word({"material", "",
                    "what a blow on models that name none sounds like, content/materials/MATERIAL.yaml"},
                   sound.material);
      });
}

}  // namespace fulcrum::scenario

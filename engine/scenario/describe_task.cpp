#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "engine/scenario/describe.h"
#include "engine/scenario/hint.h"

namespace fulcrum::scenario {

namespace {

constexpr Range kRadius{1e-6, 10, false};  // m: what is smaller can be neither hit nor drawn
constexpr double kOneDegree = std::numbers::pi / 180;

// Of any length as it is written. Not in the place of a fault: nothing there is used.
void describe_unit(KeyVisitor& visitor, const Key& key, Vec3& unit) {
  visitor.vector(key, unit, kPosition);
  const double length = unit.stableNorm();
  visitor.rule(key.name, length > 0, "must not be [0, 0, 0]");
  if (length > 0) unit /= length;
}

void describe_follow(KeyVisitor& visitor, Checkpoint& checkpoint) {
  visitor.list(
      {"follow", "", "a line from 'position' on, from corner to corner, no farther off it than 'radius'"}, 1,
      [&](KeyVisitor& each) {
        each.vector({"corner", "m", "the next one, in the world", true},
                    checkpoint.follow.emplace_back(Vec3::Zero()), kPosition);
      });
  double length = 0;
  Vec3 from = checkpoint.position;
  for (const Vec3& corner : checkpoint.follow) {
    length += (corner - from).norm();
    from = corner;
  }
  visitor.rule("follow", checkpoint.follow.empty() || length > 2 * checkpoint.radius,
               "is no longer than twice 'radius', so that there is no way to go: make the line longer, or "
               "'radius' smaller");
}

void describe_conditions(KeyVisitor& visitor, Checkpoint& checkpoint) {
  visitor.choice_of({"needs", "",
                     "place: to be there; touch: something is touched all the while; stop: the "
                     "force is stopped there and taken up again"},
                    checkpoint.needs);
  visitor.mapping(
      {"press", "", "the scene is pushed as hard as this all the while, and no harder"},
      [&](KeyVisitor& inner) {
        ForceRange& force = checkpoint.force.emplace();
        inner.number({"least", "N", "of the scene on the tool"}, force.least, from_to(0, 1000));
        inner.number({"most", "N", "of the scene on the tool", true}, force.most, above_to(0, 1000));
        inner.rule("least", force.least < force.most, "must be below 'most'");
      });
  visitor.mapping({"facing", "", "the tool is held so all the while"}, [&](KeyVisitor& inner) {
    Facing& facing = checkpoint.facing.emplace();
    inner.rotation({"orientation", "", "of the tool's model in the world [w, x, y, z]", true}, facing.q_WT);
    double within = 10;
    inner.number({"within_deg", "", "the angle of any turn between the two"}, within, above_to(0, 180));
    facing.within = within * kOneDegree;
  });
}

void describe_ways(KeyVisitor& visitor, Checkpoint& checkpoint) {
  describe_follow(visitor, checkpoint);
  visitor.mapping(
      {"insert", "", "to go in from 'position', straight, no farther off the axis than 'radius'"},
      [&](KeyVisitor& inner) {
        Insertion& insert = checkpoint.insert.emplace();
        describe_unit(inner, {"direction", "", "in the world; of any length", true}, insert.direction_W);
        inner.number({"depth", "m", "at which it is in, and up to a 'radius' more", true}, insert.depth,
                     above_to(0, 10));
      });
  visitor.rule("insert", !checkpoint.insert || checkpoint.follow.empty(),
               "cannot be beside 'follow': make two checkpoints of it");
  visitor.mapping({"turn", "", "to turn the tool, in one go or in several"}, [&](KeyVisitor& inner) {
    Turn& turn = checkpoint.turn.emplace();
    describe_unit(
        inner,
        {"axis", "", "in the world, of any length; the turn is against the clock seen from its tip", true},
        turn.axis_W);
    double angle = 90;
    inner.number({"angle_deg", "", "of the turn", true}, angle, above_to(0, 36000));
    turn.angle = angle * kOneDegree;
  });
}

void describe_checkpoints(KeyVisitor& visitor, std::vector<Checkpoint>& checkpoints) {
  std::set<std::string> names, mirrored_names;
  visitor.list(
      {"checkpoints", "", "where the tool's touch point has to go, and what it is to do there", true}, 1,
      [&](KeyVisitor& each) {
        const std::set<std::string> earlier = names;
        Checkpoint& checkpoint = checkpoints.emplace_back();
        checkpoint.written = checkpoints.size() - 1;
        each.text({"name", "", "as results and panels call it", true}, checkpoint.name);
        const bool differs = names.insert(checkpoint.name).second;
        each.rule("name", differs, "is the name of an earlier one; choose another");
        std::string& mirrored = checkpoint.mirrored_name;
        each.text({"mirrored_name", "",
                   "its name where 'left_handed' mirrors the scene, such as 'left 1' of 'right 1'; "
                   "without it the same"},
                  mirrored);
        const std::string& seen = mirrored.empty() ? checkpoint.name : mirrored;
        each.rule(mirrored.empty() ? "name" : "mirrored_name", mirrored_names.insert(seen).second || !differs,
                  "is the name of an earlier one where the scene is mirrored; choose another");
        each.vector({"position", "m", "in the world", true}, checkpoint.position, kPosition);
        each.number({"radius", "m", "how near counts as there"}, checkpoint.radius, kRadius);
        each.optional_number({"dwell", "s", "how long to stay at this one; without it that of the task"},
                             checkpoint.dwell, from_to(0, 600));
        describe_conditions(each, checkpoint);
        describe_ways(each, checkpoint);
        each.boolean({"optional", "", "the task is completed without it, too"}, checkpoint.optional);
        each.text({"after", "", "the name of an earlier one that comes first, where 'order' is any"},
                  checkpoint.after);
        each.rule("after", checkpoint.after.empty() || earlier.contains(checkpoint.after),
                  "is not the name of an earlier checkpoint");
        each.text({"hint", "",
                   "what to do, in the window while it is the next; {move}, {turn}, {finely}, {stop} "
                   "and {go_on} stand for how the device in hand does that"},
                  checkpoint.hint);
        const std::string fault = hint_fault(checkpoint.hint);
        each.rule("hint", fault.empty(), fault);
      });
}

void describe_avoid(KeyVisitor& visitor, std::vector<Avoided>& avoid) {
  visitor.list(
      {"avoid", "", "balls that the touch point should stay out of; coming into one is counted"}, 1,
      [&](KeyVisitor& each) {
        Avoided& ball = avoid.emplace_back();
        each.text({"name", "", "what is there", true}, ball.name);
        each.vector({"position", "m", "of its middle, in the world", true}, ball.position, kPosition);
        each.number({"radius", "m", "of the ball"}, ball.radius, kRadius);
      });
}

void describe_score(KeyVisitor& visitor, ScoreWeights& score) {
  visitor.mapping(
      {"score", "", "the most points that each criterion has; at 0 it is told and not judged"},
      [&](KeyVisitor& inner) {
        const auto points = [&](std::string_view name, std::string_view doc, double& value) {
          inner.number({name, "", doc}, value, from_to(0, 1000));
        };
        points("checkpoints", "those reached", score.checkpoints);
        points("optional", "those reached that need not be", score.optional);
        points("time", "beside the expert's", score.time);
        points("path", "what the touch point went, beside the expert's", score.path);
        points("force_95", "the force's 95th percentile, beside the expert's", score.force);
        points("smoothness", "of the motion, beside the expert's", score.smoothness);
        points("touches", "on the way, beside the expert's", score.touches);
        points("hard_touches", "a fifth is lost with each", score.hard_touches);
        points("slips", "off a line or out of a bore: a fifth is lost with each", score.slips);
        points("avoid", "coming into what is to be avoided: a fifth is lost with each", score.avoid);
      });
}

void describe_variant(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping(
      {"variants", "", "a task that is another one for every 'seed'"},
      [&](KeyVisitor& inner) {
        VariantDesc& variant = scenario.variant;
        inner.boolean({"shuffle", "", "the checkpoints come in an order that the seed chooses"},
                      variant.shuffle);
        inner.integer({"pick", "", "so many of those that are not optional, as the seed chooses; 0: all"},
                      variant.pick, 0, 10000);
        inner.number({"spread", "m", "by which the seed moves each checkpoint, any way"}, variant.spread,
                     from_to(0, 1));
        const auto required = std::ranges::count(scenario.checkpoints, false, &Checkpoint::optional);
        inner.rule("pick", variant.pick <= required,
                   "is more than there are checkpoints that are not optional: " + std::to_string(required));
      });
}

}  // namespace

void describe_task(KeyVisitor& visitor, Scenario& scenario) {
  std::vector<Checkpoint>& checkpoints = scenario.checkpoints;
  describe_checkpoints(visitor, checkpoints);
  visitor.choice_of({"order", "",
                     "given: each checkpoint when those before it are reached; any: each when the one is "
                     "that it comes 'after'"},
                    scenario.order);
  const bool given = scenario.order == Order::given;
  const bool all_optional = std::ranges::all_of(checkpoints, &Checkpoint::optional);
  visitor.rule("checkpoints", checkpoints.empty() || !all_optional,
               "are all optional, so that there is nothing to do");
  visitor.rule("checkpoints", checkpoints.empty() || !given || all_optional || !checkpoints.back().optional,
               "end with an optional one, which would never be asked for: move it up, or say 'order: any'");
  visitor.rule("checkpoints",
               !given || std::ranges::all_of(checkpoints, &std::string::empty, &Checkpoint::after),
               "have an 'after', which is for 'order: any': in the order given each comes after those before "
               "it");
  visitor.number({"dwell", "s", "how long the touch point must stay at a checkpoint without a break"},
                 scenario.dwell, from_to(0, 600));
  visitor.mapping({"hard_touch", "", "touches that are too hard are counted; without it none are"},
                  [&](KeyVisitor& inner) {
                    inner.number(
                        {"force", "N", "of the scene on the tool, above which a touch is too hard", true},
                        scenario.hard_touch.emplace(), above_to(0, 1000));
                  });
  describe_avoid(visitor, scenario.avoid);
  describe_score(visitor, scenario.score);
  describe_variant(visitor, scenario);
}

}  // namespace fulcrum::scenario

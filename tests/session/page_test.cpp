// The pages: they stand alone, hold what they are to hold, and nothing that anybody writes becomes markup.

#include <gtest/gtest.h>

#include "engine/session/history_page.h"
#include "engine/session/trial_page.h"

namespace fulcrum::session {
namespace {

Trial hostile_trial() {
  Trial trial;
  trial.scenario = "<script>alert(1)</script>";
  trial.title = "A & B \"quoted\" \xff";
  trial.began = "2026-11-25T09:00:01.000Z";
  trial.device = "<img src=x>";
  trial.whole = true;
  trial.metrics.time = 12;
  trial.metrics.checkpoints = 2;
  trial.metrics.checkpoints_reached = 1;
  trial.events = {{3.5, TrialEvent::Kind::checkpoint, "</svg><b>"}, {4, TrialEvent::Kind::fault, "x < y"}};
  trial.folder = "/tmp/'; rm -rf ~";
  return trial;
}

void expect_self_contained(const std::string& html) {
  for (const char* forbidden :
       {"<script", "<img", "<link", "<iframe", "href=", "<a ", "@import", "url(", "<b></b>", "</svg><b>"})
    EXPECT_EQ(html.find(forbidden), html.npos) << forbidden;
}

std::string page_of(const Trial& trial, const TrialCurves& curves) {
  const Score all = score(trial.metrics, nullptr);
  return trial_html({.trial = trial,
                     .about = "Do <this>.",
                     .participant = "P1",
                     .score = all,
                     .curves = curves,
                     .hard_touch = 2.0,
                     .expert_time = 10.0,
                     .faults = {"It stopped & waited."},
                     .limits = {},
                     .replay_command = "fulcrum replay '/tmp/x'"});
}

TEST(TrialPage, HoldsItsFiguresAndNoMarkupOfOthers) {
  TrialCurves curves{Envelope(1e-3), Envelope(1e-3), Envelope(1e-3), Envelope(1e-3)};
  for (int i = 0; i < 12000; ++i) {
    curves.force.add(i < 6000 ? 1 : 3);
    curves.torque.add(0.01);
    curves.depth.add(1e-4);
    curves.speed.add(0.05);
  }
  const std::string html = page_of(hostile_trial(), curves);
  expect_self_contained(html);
  for (const char* wanted :
       {"Not completed, after 12.0 s, with 1 of 2 checkpoints.", "Do &lt;this&gt;.",
        "It stopped &amp; waited.", "20 of 40", "checkpoint 1", "the limit of a hard touch", "fulcrum replay",
        "Force of contact", "Speed", "@media print"})
    EXPECT_NE(html.find(wanted), html.npos) << wanted;
}

TEST(TrialPage, TellsHowOldPicturesWere) {
  const TrialCurves none{Envelope(1e-3), Envelope(1e-3), Envelope(1e-3), Envelope(1e-3)};
  const Trial trial = hostile_trial();
  const Score all = score(trial.metrics, nullptr);
  TrialPage page{.trial = trial, .about = {}, .participant = {}, .score = all, .curves = none};
  EXPECT_EQ(trial_html(page).find("From hand to pixel"), std::string::npos);
  page.age.emplace();
  page.age->stages = {{"", "Median (ms)"}, {{"Draw", "12.5"}}, false};
  page.age->frames.title = "Age";
  const std::string html = trial_html(page);
  expect_self_contained(html);
  for (const char* wanted : {"From hand to pixel", "Draw", "12.5"})
    EXPECT_NE(html.find(wanted), html.npos) << wanted;
}

TEST(TrialPage, SaysThatATrialWasGuided) {
  const TrialCurves none{Envelope(1e-3), Envelope(1e-3), Envelope(1e-3), Envelope(1e-3)};
  Trial trial = hostile_trial();
  EXPECT_EQ(page_of(trial, none).find("Guided"), std::string::npos);
  trial.metrics.guided = true;
  const std::string html = page_of(trial, none);
  EXPECT_NE(html.find("Guided: no points."), html.npos);
  EXPECT_EQ(html.find("of 40"), html.npos);
}

TEST(TrialPage, StandsForATrialWithoutATick) {
  const TrialCurves none{Envelope(1e-3), Envelope(1e-3), Envelope(1e-3), Envelope(1e-3)};
  Trial trial = hostile_trial();
  trial.metrics = {};
  trial.events.clear();
  const std::string html = page_of(trial, none);
  expect_self_contained(html);
  EXPECT_EQ(html.find("nan"), html.npos);
}

TEST(HistoryPage, HasACurveForEachParticipantAndScenario) {
  std::vector<StoredTrial> trials;
  for (int i = 0; i < 30; ++i) {
    StoredTrial stored{hostile_trial(), {"s", "P" + std::to_string(i % 10), "b", "0.1.0"}};
    stored.trial.score = 3.0 * i;
    trials.push_back(stored);
    stored.trial.scenario = "ear";
    trials.push_back(stored);
  }
  trials.back().trial.whole = false;
  trials.back().trial.scenario = "left";
  trials.front().trial.scenario = "led";
  trials.front().trial.metrics.guided = true;
  const std::string html = history_html(trials);
  expect_self_contained(html);
  EXPECT_NE(html.find("(ear)"), html.npos);
  EXPECT_EQ(html.find("(left)"), html.npos);
  EXPECT_EQ(html.find("(led)"), html.npos);
  for (int i = 0; i < 10; ++i) EXPECT_NE(html.find("P" + std::to_string(i)), html.npos);
  expect_self_contained(history_html({}));
}

}  // namespace
}  // namespace fulcrum::session

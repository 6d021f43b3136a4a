#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/studio/live/hub.h"
#include "ganglion/studio/live/messages.h"
#include "ganglion/studio/live/run_session.h"

namespace ganglion::studio {
namespace {

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

constexpr std::uint8_t kNone = shown::kUnknownCell;
constexpr std::size_t kCells = 16 + 40;  // where a field's sample lists its cells

/// A field of three columns and two rows with one layer.
shown::Exhibit field_of(std::vector<std::uint8_t> cells) {
  shown::Field field;
  field.frame = "world";
  field.origin = {-1, -2};
  field.cell = {0.5, 0.5};
  field.columns = 3;
  field.rows = 2;
  field.layers.push_back({.name = "heat", .title = {"Heat", "Calor"}});
  field.cells = {std::move(cells)};
  return {{"Map", "Mapa"}, std::move(field)};
}

std::uint32_t cells_in(const std::string& sample) { return at<std::uint32_t>(sample, 48); }

/// What a page holds after applying a sample.
void apply_sample(const std::string& sample, std::vector<std::uint8_t>& cells) {
  if (at<std::uint32_t>(sample, 16) == 0) cells.assign(6, kNone);
  const auto count = cells_in(sample);
  for (std::uint32_t i = 0; i < count; ++i) {
    cells.at(at<std::uint32_t>(sample, kCells + 4 * i)) = at<std::uint8_t>(sample, kCells + 4 * count + i);
  }
}

TEST(OutcomeJson, TellsOfSuccessOnlyWhereSomebodyJudged) {
  const auto success = [](ganglion::Verdict verdict) {
    lab::Outcome result;
    result.verdict = verdict;
    return outcome_json(result, "")["success"];
  };
  EXPECT_TRUE(success(ganglion::Verdict::NotJudged).is_null());
  EXPECT_EQ(success(ganglion::Verdict::Failed), Json(false));
  EXPECT_EQ(success(ganglion::Verdict::Succeeded), Json(true));
}

TEST(FieldState, TellsTheWholeAndThenWhatChanged) {
  FieldState field;
  ASSERT_TRUE(field.take(field_of({kNone, 1, kNone, kNone, 2, kNone}), 1));
  const std::string whole = field.sample({7, 1, 0.5}, 0);
  EXPECT_EQ(at<std::uint8_t>(whole, 0), 6);
  EXPECT_EQ(at<std::uint16_t>(whole, 2), 7);
  EXPECT_EQ(at<std::uint32_t>(whole, 4), 1u);
  EXPECT_EQ(at<double>(whole, 8), 0.5);
  EXPECT_EQ(at<std::uint32_t>(whole, 20), 3u);
  EXPECT_EQ(at<std::uint32_t>(whole, 24), 2u);
  EXPECT_EQ(at<double>(whole, 28), -1);
  EXPECT_EQ(at<double>(whole, 36), -2);
  EXPECT_EQ(at<std::uint32_t>(whole, 44), 1u);
  EXPECT_EQ(cells_in(whole), 2u) << "cells that are unknown are not told";
  const Json words = Json::parse(whole.substr(kCells + 2 * 5));
  EXPECT_EQ(whole.size(), kCells + 2 * 5 + at<std::uint32_t>(whole, 52));
  EXPECT_EQ(words["title"]["es"], "Mapa");
  EXPECT_EQ(words["layers"][0]["title"]["es"], "Calor");
  EXPECT_EQ(words["cell"], Json({0.5, 0.5}));
  ASSERT_TRUE(field.take(field_of({kNone, 1, 9, kNone, kNone, kNone}), 2));
  const std::string delta = field.sample({7, 2, 1}, 1);
  EXPECT_EQ(at<std::uint32_t>(delta, 16), 1u);
  EXPECT_EQ(cells_in(delta), 2u) << "one cell that came, one that is unknown again";
  EXPECT_EQ(at<std::uint32_t>(delta, 52), 0u) << "words are told once";
  std::vector<std::uint8_t> page;
  apply_sample(whole, page);
  apply_sample(delta, page);
  EXPECT_EQ(page, (std::vector<std::uint8_t>{kNone, 1, 9, kNone, kNone, kNone}));
}

TEST(FieldState, TakesPatches) {
  FieldState field;
  EXPECT_FALSE(field.take({{}, shown::Patch{0, 0, 1, 1, {{5}}}}, 1)) << "of nothing";
  ASSERT_TRUE(field.take(field_of({1, 2, 3, 4, 5, 6}), 1));
  ASSERT_TRUE(field.take({{}, shown::Patch{1, 1, 2, 1, {{8, 9}}}}, 2));
  EXPECT_FALSE(field.take({{}, shown::Patch{2, 1, 2, 1, {{8, 9}}}}, 3));
  EXPECT_FALSE(field.take({{}, shown::Marks{}}, 3));
  EXPECT_EQ(field.seq(), 2u);
  std::vector<std::uint8_t> page(6, 0);
  apply_sample(field.sample({1, 2, 0}, 1), page);
  EXPECT_EQ(page, (std::vector<std::uint8_t>{0, 0, 0, 0, 8, 9}));
}

TEST(FieldState, GivesTheSameToOneWhoMissedStatesBetween) {
  FieldState field;
  std::vector<std::uint8_t> cells(6, 0), page;
  field.take(field_of(cells), 1);
  apply_sample(field.sample({1, 1, 0}, 0), page);
  for (std::uint32_t seq = 2; seq < 6; ++seq) {
    cells[seq] = static_cast<std::uint8_t>(seq);
    cells[0] = static_cast<std::uint8_t>(seq * 10);
    field.take(field_of(cells), seq);
  }
  apply_sample(field.sample({1, 5, 0}, 1), page);
  EXPECT_EQ(page, cells);
}

TEST(LiveFeed, NeverWaitsForSomebodyWhoDoesNotLook) {
  LiveFeed feed;
  const std::vector<SignalColumn> columns = {{"a", "m"}};
  feed.add_table("/robot0/signals", columns);
  feed.arm();
  for (std::uint32_t tick = 0; tick < 100'000; ++tick) {
    const double value = tick;
    feed.write_row(0, tick, tick, std::span(&value, 1));
  }
  std::uint32_t rows = 0;
  for (; feed.row() != nullptr; feed.pop_row()) EXPECT_EQ(feed.row()->tick, rows++) << "what it kept is in order";
  EXPECT_EQ(rows, 1024u);
  const double value = 1;
  feed.write_row(0, 0, 0, std::span(&value, 1));
  EXPECT_EQ(feed.row()->seq, 100'001u) << "the gap tells that some were left out";
}

TEST(LiveFeed, LosesNoEventAndKeepsTheNewestState) {
  LiveFeed feed;
  feed.arm();
  for (int i = 0; i < 3000; ++i) {
    feed.write_json("/log", "foxglove.Log", i, "{}");
    feed.write_exhibit("/robot0/exhibit/m/field/map", i, "...");
  }
  int logs = 0;
  double newest_s = 0;
  do {
    for (; feed.message() != nullptr; feed.pop_message()) {
      if (feed.message()->topic == "/log") {
        EXPECT_EQ(feed.message()->time_s, logs++);
      } else {
        newest_s = feed.message()->time_s;
      }
    }
  } while (!feed.flush() || feed.message() != nullptr);
  EXPECT_EQ(logs, 3000);
  EXPECT_EQ(newest_s, 2999);
}

TEST(LiveFeed, HandsRowsWholeFromOneThreadToAnother) {
  LiveFeed feed;
  const std::vector<SignalColumn> columns(8);
  feed.add_table("/robot0/signals", columns);
  feed.arm();
  constexpr std::uint32_t kTicks = 50'000;
  std::thread run([&] {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      const std::vector<double> values(8, tick);
      feed.write_row(0, tick, tick, values);
    }
    feed.write_json("/log", "foxglove.Log", 0, "{}");
  });
  std::uint32_t torn = 0, last = 0;
  while (feed.message() == nullptr || feed.row() != nullptr) {
    const LiveFeed::Row* row = feed.row();
    if (row == nullptr) continue;
    for (const double value : row->values) torn += value != row->tick;
    torn += row->tick < last;
    last = row->tick;
    feed.pop_row();
  }
  run.join();
  EXPECT_EQ(torn, 0u);
}

TEST(RunEvent, SaysALineOfTheLogInBothLanguages) {
  const auto said = [](const char* json) { return event_of("foxglove.Log", 1, json)->content["message_es"]; };
  EXPECT_EQ(said(R"({"message":"reached","message_es":"alcanzado"})"), "alcanzado");
  EXPECT_EQ(said(R"({"message":"reached"})"), "reached") << "older files hold English only";
  EXPECT_EQ(said(R"({"message":3})"), "");
}

class HubTest : public ::testing::Test {
 protected:
  HubTest() {
    const std::vector<SignalColumn> columns = {{"a", ""}};
    feed_->add_table("/robot0/signals", columns);
    feed_->write_json("/scene", "ganglion.Scene", 0, R"({"walls":[]})");
    feed_->arm();
    hub_.watch(feed_);
  }
  void row(std::uint32_t tick) {
    const double value = tick;
    feed_->write_row(0, tick, tick, std::span(&value, 1));
  }
  Hub hub_{"session"};
  std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>();
};

TEST_F(HubTest, SparesASlowViewerOldRowsButNoEvent) {
  Viewer slow(hub_, [] {});
  ASSERT_FALSE(slow.next()->binary);  // hello
  for (std::uint32_t tick = 0; tick < 2000; ++tick) {
    row(tick);
    if (tick % 100 == 0) feed_->write_json("/log", "foxglove.Log", tick, "{}");
    hub_.drain();
  }
  int events = 0, rows = 0;
  std::uint32_t last = 0;
  while (const auto out = slow.next()) {
    if (out->binary) {
      ++rows;
      last = at<std::uint32_t>(*out->bytes, 16);
    } else {
      ++events;
    }
  }
  EXPECT_EQ(events, 1 + 20) << "the streams, and every line of the log";
  EXPECT_EQ(rows, 256);
  EXPECT_EQ(last, 1999u) << "of rows the newest";
}

TEST_F(HubTest, SendsAFieldToALateViewerWholeAndToOthersWhatChanged) {
  Viewer early(hub_, [] {});
  early.next();
  feed_->write_exhibit("/robot0/exhibit/m/field/map", 1, encode(field_of({1, kNone, kNone, kNone, kNone, kNone})));
  hub_.drain();
  std::vector<std::uint8_t> page;
  const auto take = [&](Viewer& viewer) {
    std::uint32_t cells = 0;
    while (const auto out = viewer.next()) {
      if (!out->binary) continue;
      apply_sample(*out->bytes, page);
      cells = cells_in(*out->bytes);
    }
    return cells;
  };
  EXPECT_EQ(take(early), 1u);
  feed_->write_exhibit("/robot0/exhibit/m/field/map", 2, encode(field_of({1, 2, 3, kNone, kNone, kNone})));
  hub_.drain();
  EXPECT_EQ(take(early), 2u);
  EXPECT_EQ(page, (std::vector<std::uint8_t>{1, 2, 3, kNone, kNone, kNone}));
  Viewer late(hub_, [] {});
  EXPECT_EQ(take(late), 3u);
}

TEST_F(HubTest, TellsWhoShowsWhatAndWhatItIsInBothLanguages) {
  Viewer viewer(hub_, [] {});
  viewer.next();
  feed_->write_exhibit("/robot0/exhibit/all/marks/goals", 1, encode({{"Goals", "Objetivos"}, shown::Marks{}}));
  feed_->write_exhibit("/robot0/exhibit/all/marks/bad", 1, "no message");
  hub_.drain();
  Json streams, told;
  while (const auto out = viewer.next()) {
    if (out->binary && at<std::uint8_t>(*out->bytes, 0) == 7) told = Json::parse(out->bytes->substr(16));
    if (!out->binary) streams = Json::parse(*out->bytes)["streams"];
  }
  EXPECT_EQ(told["title"]["es"], "Objetivos");
  EXPECT_EQ(streams[1]["kind"], "exhibit");
  EXPECT_EQ(streams[1]["of"], Json({{"robot", 0}, {"owner", "all"}, {"form", "marks"}, {"name", "goals"}}));
}

TEST_F(HubTest, ResumesWhereAViewerWas) {
  hub_.event("file", {{"path", "a"}});
  hub_.event("file", {{"path", "b"}});
  Viewer back(hub_, [] {});
  back.resume("session", 1);
  EXPECT_TRUE(Json::parse(*back.next()->bytes)["resumed"]);
  EXPECT_EQ(Json::parse(*back.next()->bytes)["path"], "b");
  EXPECT_FALSE(back.next());
  Viewer other(hub_, [] {});
  other.resume("another", 1);
  EXPECT_FALSE(Json::parse(*other.next()->bytes)["resumed"]);
}

TEST_F(HubTest, GivesUpAViewerWhoIsFartherBehindThanItRemembers) {
  Viewer slow(hub_, [] {});
  slow.next();
  for (int i = 0; i < 20'001; ++i) hub_.event("log", Json::object());
  EXPECT_FALSE(slow.next());
  EXPECT_TRUE(slow.lost());
}

TEST_F(HubTest, TellsThinlyWhereARunIsFasterThanItIsLookedAt) {
  Viewer viewer(hub_, [] {});
  viewer.next();
  for (std::uint32_t tick = 0; tick < 500; ++tick) row(tick);
  hub_.drain();
  std::vector<std::uint32_t> ticks;
  while (const auto out = viewer.next()) {
    if (out->binary) ticks.push_back(at<std::uint32_t>(*out->bytes, 16));
  }
  EXPECT_EQ(ticks, (std::vector<std::uint32_t>{496, 497, 498, 499}));
}

TEST_F(HubTest, PutsRowsThatWaitTogetherIntoOneMessageForWhoAsksForIt) {
  Viewer viewer(hub_, [] {});
  viewer.bundle_rows();
  viewer.next();
  for (std::uint32_t tick = 7; tick < 9; ++tick) row(tick);
  hub_.drain();
  viewer.next();  // the streams
  const auto out = viewer.next();
  ASSERT_TRUE(out);
  EXPECT_EQ(out->bytes->size(), 16u + 2 * (8 + 32)) << "a row of one value has 16 + 8 + 8 bytes";
  EXPECT_EQ(at<std::uint8_t>(*out->bytes, 0), 5);
  for (const std::size_t start : {std::size_t{16}, std::size_t{56}}) {
    EXPECT_EQ(at<std::uint64_t>(*out->bytes, start), 32u);
    EXPECT_EQ(at<std::uint8_t>(*out->bytes, start + 8), 1);
    EXPECT_EQ(at<std::uint32_t>(*out->bytes, start + 8 + 16), start == 16 ? 7u : 8u);
  }
  EXPECT_FALSE(viewer.next());
  row(9);
  hub_.drain();
  EXPECT_EQ(at<std::uint8_t>(*viewer.next()->bytes, 0), 1) << "one row needs no bundle";
}

}  // namespace
}  // namespace ganglion::studio

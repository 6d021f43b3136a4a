#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/link/wire/cobs.h"
#include "ganglion/link/wire/codec.h"
#include "ganglion/link/wire/description.h"
#include "ganglion/link/wire/frames.h"
#include "ganglion/link/wire/words.h"

namespace ganglion::link {
namespace {

using namespace std::string_literals;

TEST(Crc16, HasThePublishedCheckValue) {
  EXPECT_EQ(crc16("123456789"), 0x29B1);
  EXPECT_EQ(crc16(""), 0xFFFF);
}

/// A packet's bytes but its payload's checksum, which stands at its end in two bytes.
TEST(Packet, StuffsAsThePaperDoes) {
  std::string packet;
  append_packet("\x11\x22\0\x33"s, packet);  // its checksum, 0x0745, worked out bit by bit in another language
  EXPECT_EQ(packet, "\x03\x11\x22\x04\x33\x07\x45\0"s);
}

TEST(Packet, OpensWhatWasPacked) {
  for (const std::size_t size : {1u, 2u, 252u, 253u, 254u, 255u, 256u, 508u, 509u, 1000u}) {
    for (const int zeros_every : {0, 1, 2, 7, 254, 255}) {
      std::string payload;
      for (std::size_t n = 0; n < size; ++n) {
        const bool zero = zeros_every > 0 && n % static_cast<std::size_t>(zeros_every) == 0;
        payload += zero ? '\0' : static_cast<char>(n % 255 + 1);
      }
      std::string packet;
      append_packet(payload, packet);
      ASSERT_EQ(packet.find('\0'), packet.size() - 1) << size << " " << zeros_every;
      packet.pop_back();
      std::string_view opened;
      ASSERT_TRUE(open_packet(packet, opened)) << size << " " << zeros_every;
      EXPECT_EQ(opened, payload);
    }
  }
}

TEST(Packet, NoticesEveryFlippedBit) {
  std::string packet;
  append_packet("drive on\0and on"s, packet);
  packet.pop_back();
  for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
    std::string spoilt = packet;
    spoilt[bit / 8] = static_cast<char>(spoilt[bit / 8] ^ (1 << bit % 8));
    std::string_view payload;
    EXPECT_FALSE(open_packet(spoilt, payload)) << bit;
  }
}

std::vector<std::string> frames_of(FrameReader& reader, std::string_view bytes, std::size_t piece) {
  std::vector<std::string> frames;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    reader.feed(bytes.substr(at, piece));
    for (;;) {
      const auto frame = reader.next();
      EXPECT_TRUE(frame) << frame.error().what.en;
      if (!frame || !*frame) break;
      frames.emplace_back(**frame);
    }
  }
  return frames;
}

TEST(FrameReader, CutsStreamsHoweverTheyArrive) {
  const std::string binary =
      "\0\0\0\x02"
      "ab\0\0\0\0\0\0\0\x01"
      "c"s;
  const std::string json = "{1}\n{22}\n";
  for (std::size_t piece = 1; piece <= binary.size(); ++piece) {
    FrameReader one(Carrier::Stream), other(Carrier::Stream);
    EXPECT_EQ(frames_of(one, binary, piece), (std::vector<std::string>{"ab", "", "c"}));
    EXPECT_EQ(*one.encoding(), Encoding::Binary);
    EXPECT_EQ(frames_of(other, json, piece), (std::vector<std::string>{"{1}", "{22}"}));
    EXPECT_EQ(*other.encoding(), Encoding::Json);
  }
}

TEST(FrameReader, LeavesOutDamagedPacketsAndFindsTheNext) {
  std::string bytes = "noise";
  bytes += '\0';
  append_packet("first", bytes);
  append_packet("second", bytes);
  bytes[10] = 'X';  // in the first
  bytes += std::string(3 << 20, 'x') + '\0';
  append_packet("{third}", bytes);
  FrameReader reader(Carrier::Packets);
  EXPECT_EQ(frames_of(reader, bytes, 1000), (std::vector<std::string>{"second", "{third}"}));
  EXPECT_EQ(reader.take_damaged(), 3u);
  EXPECT_EQ(*reader.encoding(), Encoding::Json);
}

/// Act { tick 300, ttl_ms 40, values [1, -2] }, put together by hand after protobuf's rules.
const std::string kActBytes =
    "\x22\x17"
    "\x08\xAC\x02"
    "\x10\x28"
    "\x22\x10\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\0\xC0"s;

TEST(Codec, WritesWhatAHandWrittenDecoderReads) {
  wire::Act message;
  message.set_tick(300);
  message.set_ttl_ms(40);
  message.add_values(1);
  message.add_values(-2);
  std::string bytes;
  ASSERT_TRUE(FrameWriter(Carrier::Stream, Encoding::Binary).append(message, bytes));
  EXPECT_EQ(bytes, "\0\0\0\x19"s + kActBytes);
}

TEST(Codec, ReadsBothEncodingsAlike) {
  wire::Sense sense;
  sense.set_tick(4'000'000'000u);
  sense.set_time_s(0.1);
  for (const double value : {0.1, -1e-300, 1.7976931348623157e308, 5e-324, 2.0 / 3}) sense.add_values(value);
  for (const double value : {INFINITY, -INFINITY}) sense.add_ages_s(value);
  sense.add_cost_j(0);
  for (const Encoding encoding : {Encoding::Binary, Encoding::Json}) {
    std::string bytes;
    ASSERT_TRUE(FrameWriter(Carrier::Stream, encoding).append(sense, bytes));
    FrameReader reader(Carrier::Stream);
    reader.feed(bytes);
    Messages messages;
    ASSERT_EQ(decode(**reader.next(), encoding, messages).value(), FrameKind::Sense);
    EXPECT_EQ(messages.sense.SerializeAsString(), sense.SerializeAsString());
  }
}

TEST(Codec, RefusesRubbish) {
  Messages messages;
  for (const std::string& bytes : {"\x22\x05\xFF\xFF\xFF\xFF\xFF"s, "\xFF"s, "\x0A\x7F"s}) {
    EXPECT_FALSE(decode(bytes, Encoding::Binary, messages));
  }
  for (const std::string json :
       {"", "{", "[]", "{\"act\":5}", "{\"act\":{\"tick\":-1}}", "{\"act\":{\"tick\":1e99}}"}) {
    EXPECT_FALSE(decode(json, Encoding::Json, messages)) << json;
  }
  EXPECT_EQ(decode("{\"beam\":{}}", Encoding::Json, messages).value(), FrameKind::Unknown);
  const std::string deep = "{\"x\":" + std::string(100'000, '[') + "}";
  EXPECT_FALSE(decode(deep, Encoding::Json, messages));
}

Description described() {
  Description robot;
  robot.name = "R";
  robot.tick_s = 0.05;
  robot.body = Body{0.3, 0.2, 0.15, {{"sonar", "Sonar", {{0.1, -0.05}, Angle::from_rad(0.5)}, 0.7, 3}}};
  robot.sensations = {{"sonar.range", "m", ValueType::Real, {}, 0.02, 3, 0.1},
                      {"gps.fix", "m", ValueType::Circular, {"x", "y"}, -INFINITY, INFINITY}};
  robot.sensations[0].dead = 0;
  robot.commands = {{"drive", {{"left", "m/s", -1, 1, 0}, {"right", "m/s", -0.5, 1, 0.1}}}};
  return robot;
}

TEST(Description, ComesBackAsItWas) {
  wire::Describe message;
  write_description(described(), message);
  const auto back = read_description(message);
  ASSERT_TRUE(back) << back.error().what.en;
  EXPECT_TRUE(differences(described(), *back).empty());
  EXPECT_EQ(back->sensations[0].dead, 0);
  EXPECT_TRUE(std::isnan(back->sensations[1].dead));
}

TEST(Description, IsRefusedWhereItMakesNoSense) {
  const auto refused = [](auto&& change) {
    wire::Describe message;
    write_description(described(), message);
    change(message);
    return !read_description(message);
  };
  EXPECT_FALSE(refused([](wire::Describe&) {}));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.set_tick_s(0); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.set_tick_s(NAN); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.set_tick_s(9e-7); }));
  EXPECT_FALSE(refused([](wire::Describe& m) { m.set_tick_s(1e-6); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.set_robots(10'001); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_sensations(1)->set_name("sonar.range"); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_sensations(1)->set_name(""); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_sensations(0)->set_min(4); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_sensations(0)->set_type(static_cast<wire::ValueType>(9)); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_commands(0)->clear_elements(); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_commands(0)->mutable_elements(0)->set_safe(2); }));
  EXPECT_TRUE(refused([](wire::Describe& m) { m.mutable_commands(0)->mutable_elements(0)->set_max(INFINITY); }));
  EXPECT_TRUE(refused([](wire::Describe& m) {
    for (int n = 0; n < 1001; ++n) m.add_sensations()->set_name(fmt::format("s{}", n));
  }));
}

TEST(Description, IsRefusedWhereItsFramesWouldBeTooLarge) {
  const auto channels = [](std::uint32_t robots, int count) {
    wire::Describe message;
    message.set_tick_s(0.1);
    message.set_robots(robots);
    for (int n = 0; n < count; ++n) message.add_sensations()->set_name(fmt::format("s{}", n));
    return read_description(message).has_value();
  };
  EXPECT_TRUE(channels(0, 1000));
  EXPECT_TRUE(channels(8192, 8));  // 8,192 robots of 8 values and 8 ages of 8 bytes: 1 MiB
  EXPECT_FALSE(channels(8193, 8));
}

TEST(Description, NamesWhatDiffers) {
  Description robot = described();
  robot.sensations[0].max = 4;
  robot.commands[0].elements[1].safe = 0;
  robot.sensations[1].elements = {"x", "y", "z"};
  const auto found = differences(described(), robot);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(text_of(found[0]).en, "sonar.range: max: the robot has 4, the file 3");
  EXPECT_EQ(text_of(found[0]).es, "sonar.range: máximo: el robot tiene 4, el archivo 3");
  EXPECT_FALSE(found[0].grave);
  EXPECT_EQ(found[1].text.en, "elements: the robot has \"x, y, z\", the file \"x, y\"");
  EXPECT_TRUE(found[1].grave);
  EXPECT_EQ(found[2].text.en, "safe value of right: the robot has 0, the file 0.1");
}

TEST(Words, GoInBothLanguages) {
  const Sentence reason{"the run is over", "la ejecución terminó"};
  wire::Bye bye;
  write_words(reason, bye);
  EXPECT_EQ(bye.reason(), reason.en);
  EXPECT_EQ(bye.reason_es(), reason.es);
  EXPECT_EQ(read_words(bye), reason);
  write_words(Sentence::quoted("Robby"), bye);
  EXPECT_EQ(bye.reason_es(), "") << "it reads the same";
  EXPECT_EQ(read_words(bye), Sentence::quoted("Robby"));
}

TEST(Words, AreQuotedWhereTheyCameInOneLanguage) {
  wire::Event event;
  event.set_text("battery low");
  EXPECT_EQ(read_words(event), Sentence::quoted("battery low"));
  event.set_text_es("batería baja");
  EXPECT_EQ(read_words(event), (Sentence{"battery low", "batería baja"}));
  event.clear_text();
  EXPECT_EQ(read_words(event), Sentence::quoted("batería baja"));
  EXPECT_TRUE(read_words(wire::Bye()).empty());
}

TEST(Words, HoldNothingThatIsNoUtf8) {
  wire::Bye bye;
  const auto sent = [&bye](const char* words) {
    write_words(Sentence::quoted(words), bye);
    std::string bytes;
    EXPECT_TRUE(FrameWriter(Carrier::Stream, Encoding::Json).append(bye, bytes)) << words;
    return bye.reason();
  };
  for (const char* good : {"", "plain", "añ € 😀", "\xF4\x8F\xBF\xBF"}) EXPECT_EQ(sent(good), good);
  EXPECT_EQ(sent("a\xFFñ\xC3"), "a?ñ?");
  for (const char* bad : {"\xC0\xAF", "\xC1\xBF", "\x80\xBF"}) EXPECT_EQ(sent(bad), "??");
  for (const char* bad : {"\xED\xA0\x80", "\xE0\x9F\xBF", "\xE2\x82\xC3"}) EXPECT_EQ(sent(bad), "???");
  for (const char* bad : {"\xF4\x90\x80\x80", "\xF0\x8F\xBF\xBF", "\xF8\x88\x80\x80"}) EXPECT_EQ(sent(bad), "????");
}

TEST(Frames, SpellEveryNumberInOneWay) {
  SenseFrame sense = make_sense_frame(described());
  sense.values = {-0.0, -std::numeric_limits<double>::quiet_NaN(), INFINITY};
  sense.ages_s = {0, 1};
  wire::Sense message;
  write_senses({&sense, 1}, false, message);
  EXPECT_FALSE(std::signbit(message.values(0)));
  EXPECT_FALSE(std::signbit(message.values(1)));
  SenseFrame back = make_sense_frame(described());
  message.set_values(0, -0.0);
  ASSERT_TRUE(read_senses(message, {&back, 1}));
  EXPECT_FALSE(std::signbit(back.values[0]));
  EXPECT_EQ(back.values[2], INFINITY);
  message.add_values(1);
  EXPECT_FALSE(read_senses(message, {&back, 1}));
}

TEST(Frames, CarrySingleNumbersForSmallRobots) {
  ActFrame act = make_act_frame(described());
  act.values = {0.1, -0.25};
  wire::Act message;
  write_acts({&act, 1}, true, message);
  EXPECT_EQ(message.values_size(), 0);
  EXPECT_EQ(message.values32(0), 0.1f);
  EXPECT_EQ(message.ttl_s_size(), 0);
  ActFrame back = make_act_frame(described());
  ASSERT_TRUE(read_acts(message, {&back, 1}));
  EXPECT_EQ(back.values, (std::vector<double>{0.1f, -0.25}));
  EXPECT_EQ(back.ttl_s, act.ttl_s);
}

TEST(Frames, CarryTimesToLiveExactly) {
  ActFrame act = make_act_frame(described());
  for (const double ttl_s : {0.3, 0.04, 0.3 - 0.1, 1.0 / 3, 0.0}) {
    act.ttl_s = {ttl_s};
    wire::Act message;
    write_acts({&act, 1}, false, message);
    ActFrame back = make_act_frame(described());
    ASSERT_TRUE(read_acts(message, {&back, 1}));
    EXPECT_EQ(back.ttl_s[0], ttl_s);
  }
  act.ttl_s = {0.2504};
  EXPECT_EQ(ttl_ms_of({&act, 1}), 251u);
}

}  // namespace
}  // namespace ganglion::link

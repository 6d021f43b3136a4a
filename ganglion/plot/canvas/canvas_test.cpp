#include "ganglion/plot/canvas/canvas.h"

#include <gtest/gtest.h>

#include "ganglion/plot/canvas/axes.h"
#include "ganglion/plot/canvas/picture.h"
#include "ganglion/plot/testing/markup.h"

/// Fontconfig keeps what it found until the process ends; that is no leak of ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }  // NOLINT: the name is LSan's

namespace ganglion::plot {
namespace {

Picture small_picture(std::string words) {
  return {"small", "A <title>", "Says & shows", 100, 50, [words](Canvas& canvas) {
            canvas.clip({20, 20}, {30, 10});
            canvas.line({10, 10}, {90.12345, 40}, {Colour::hex(0xff0000), 2, {}});
            canvas.text({50, 25}, words, Anchor::Middle);
            canvas.unclip();
          }};
}

TEST(RoundTicks, AreRoundNumbersWithinTheRange) {
  EXPECT_EQ(round_ticks(0, 10, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(round_ticks(-3.2, 3.2, 4), (std::vector<double>{-2, 0, 2}));
  EXPECT_EQ(round_ticks(0, 6.18, 10), (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(RoundTicks, AreNoneForARangeThatIsNone) {
  EXPECT_TRUE(round_ticks(1, 1, 5).empty());
  EXPECT_TRUE(round_ticks(0, INFINITY, 5).empty());
  EXPECT_TRUE(round_ticks(NAN, 1, 5).empty());
}

TEST(RoundTicks, NeverExceedTheirNumber) {
  for (const double upper : {1e-9, 0.37, 1.0, 4.99, 17.0, 2.5e8})
    for (int most = 2; most < 12; ++most) {
      const auto ticks = round_ticks(-upper / 3, upper, most);
      EXPECT_GE(ticks.size(), 1u) << upper << " " << most;
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most)) << upper;
    }
}

TEST(Axes, KeepMetresEquallyLongBothWays) {
  const Axes axes = equal_axes({0, 0}, {6, 5}, {62, 44}, {600, 600});
  EXPECT_DOUBLE_EQ(axes.scale(), 100);
  EXPECT_DOUBLE_EQ(axes.size_px.y, 500);
  EXPECT_EQ(axes.at({0, 0}), (Vector2{62, 544}));
  EXPECT_EQ(axes.at({6, 5}), (Vector2{662, 44}));
}

TEST(Viridis, EndsInItsPublishedColours) {
  const Colour low = viridis(0), high = viridis(1);
  EXPECT_NEAR(low.red * 255, 0x44, 0.01);
  EXPECT_NEAR(low.blue * 255, 0x54, 0.01);
  EXPECT_NEAR(high.red * 255, 0xfd, 0.01);
  EXPECT_NEAR(high.green * 255, 0xe7, 0.01);
}

TEST(Viridis, GrowsBrighterAllTheWay) {
  for (int i = 0; i < 100; ++i) EXPECT_LT(viridis(i / 100.0).brightness(), viridis((i + 1) / 100.0).brightness());
}

TEST(CleanText, ReplacesWhatIsNoTextInXml) {
  EXPECT_EQ(clean_text("a\nb\x01"
                       "c"),
            "a b\uFFFDc");
  EXPECT_EQ(clean_text("señal"), "señal");
  EXPECT_EQ(clean_text("\xc3"), "\uFFFD");                      // cut
  EXPECT_EQ(clean_text("\xc0\xaf"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(clean_text("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_LE(clean_text(std::string(5000, 'x')).size(), 400u);
}

TEST(EscapeMarkup, LeavesNoLetterThatMeansSomething) {
  EXPECT_EQ(escape_markup("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
}

TEST(Picture, IsWellFormedSvgThatKeepsItsWords) {
  const auto svg = render(small_picture("risk < 1 & more"), PictureFormat::Svg);
  ASSERT_TRUE(svg) << svg.error().what.en;
  EXPECT_EQ(fault_in_markup(*svg), "");
  EXPECT_NE(svg->find("<title id=\"title\">A &lt;title&gt;</title>"), std::string::npos);
  EXPECT_NE(svg->find("<desc id=\"desc\">Says &amp; shows</desc>"), std::string::npos);
  EXPECT_EQ(texts_in(*svg), std::vector<std::string>{"risk &lt; 1 &amp; more"});
}

TEST(Picture, RoundsToHundredthsOfAPixel) {
  const auto svg = render(small_picture("x"), PictureFormat::Svg);
  ASSERT_TRUE(svg);
  EXPECT_NE(svg->find("90.12"), std::string::npos);
  EXPECT_EQ(svg->find("90.123"), std::string::npos);
}

TEST(Picture, IsTheSameFileEveryTime) {
  EXPECT_EQ(render(small_picture("x"), PictureFormat::Svg).value(),
            render(small_picture("x"), PictureFormat::Svg).value());
}

TEST(Picture, HasTwoDotsPerPixelInPng) {
  const auto png = render(small_picture("x"), PictureFormat::Png);
  ASSERT_TRUE(png);
  EXPECT_EQ(png->substr(1, 3), "PNG");
  EXPECT_EQ(png->substr(16, 8), std::string("\0\0\0\xc8\0\0\0\x64", 8));  // 200 x 100, big-endian
}

TEST(Picture, IsPdfToo) {
  const auto pdf = render(small_picture("x"), PictureFormat::Pdf);
  ASSERT_TRUE(pdf);
  EXPECT_EQ(pdf->substr(0, 5), "%PDF-");
}

TEST(Picture, RefusesASizeThatCairoCannotDraw) {
  Picture picture = small_picture("x");
  picture.height_px = 1e6;
  const auto svg = render(picture, PictureFormat::Png);
  ASSERT_FALSE(svg);
  EXPECT_EQ(svg.error().code, ErrorCode::TooLarge);
}

TEST(PictureForAPage, HasItsShapesOnceAndItsWordsTwice) {
  const auto svg = render_for_page(small_picture("start"), small_picture("inicio"), "p1-");
  ASSERT_TRUE(svg);
  EXPECT_EQ(fault_in_markup(*svg), "");
  EXPECT_EQ(svg->find("<svg "), svg->rfind("<svg "));
  EXPECT_EQ(texts_in(*svg), (std::vector<std::string>{"start", "inicio"}));
  EXPECT_NE(svg->find("class=\"said-es\""), std::string::npos);
}

TEST(PictureForAPage, HasIdsOfItsOwn) {
  const auto svg = render_for_page(small_picture("a"), small_picture("b"), "p7-");
  ASSERT_TRUE(svg);
  for (std::size_t at = svg->find(" id=\""); at != std::string::npos; at = svg->find(" id=\"", at + 1))
    EXPECT_EQ(svg->substr(at + 5, 3), "p7-");
  EXPECT_NE(svg->find("url(#p7-i"), std::string::npos);
}

TEST(FittedText, EndsInAnEllipsisWhereItIsTooLong) {
  std::string fitted;
  Picture picture = small_picture("");
  picture.draw = [&](Canvas& canvas) {
    fitted = canvas.fitted("a very long name of a component", 60);
    EXPECT_LE(canvas.text_width(fitted), 60);
    EXPECT_EQ(canvas.fitted("short", 60), "short");
  };
  ASSERT_TRUE(render(picture, PictureFormat::Svg));
  EXPECT_TRUE(fitted.starts_with("a very"));
  EXPECT_TRUE(fitted.ends_with("…"));
}

}  // namespace
}  // namespace ganglion::plot

/// What reports are made of: compression, hashes, text that stays text, packed geometry, the SVG map.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/deflate.hpp"
#include "io/html_text.hpp"
#include "io/random.hpp"
#include "io/report_payload.hpp"
#include "io/report_residual.hpp"
#include "io/sha256.hpp"
#include "io/write_report.hpp"
#include "io/write_svg_map.hpp"
#include "oracle/inflate.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::content_of;
using test::ScratchFolder;
using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

void expect_comes_back(const Bytes& bytes) {
  const auto back = oracle::Inflate::run(deflate(bytes));
  ASSERT_TRUE(back) << bytes.size();
  EXPECT_TRUE(*back == bytes) << bytes.size();
}

TEST(Deflate, ComesBackWhole) {
  expect_comes_back({});
  expect_comes_back({0});
  expect_comes_back(Bytes(3, 7));
  expect_comes_back(Bytes(100'000, 255));
  Random random(1);
  for (const std::uint64_t letters : {1u, 2u, 3u, 40u, 256u}) {
    for (const std::size_t size : {2u, 10u, 257u, 258u, 259u, 70'000u}) {
      Bytes bytes;
      for (std::size_t i = 0; i < size; ++i)
        bytes.push_back(static_cast<std::uint8_t>(random.below(letters)));
      expect_comes_back(bytes);
    }
  }
}

TEST(Deflate, ComesBackWithMatchesFromFarAway) {
  Random random(2);
  Bytes block;
  for (std::size_t i = 0; i < 20'000; ++i) block.push_back(static_cast<std::uint8_t>(random.below(256)));
  for (const std::size_t gap : {12'767u, 12'768u, 12'769u}) {  // around the window of 32,768
    Bytes bytes = block;
    bytes.insert(bytes.end(), gap, 0);
    bytes.insert(bytes.end(), block.begin(), block.end());
    expect_comes_back(bytes);
  }
}

TEST(Deflate, KeepsCodesShortWhateverTheCounts) {
  // Counts of Fibonacci make the deepest trees: 25 levels without a limit.
  Bytes bytes;
  std::size_t a = 1, b = 1;
  for (std::uint8_t letter = 0; letter < 25; ++letter) {
    bytes.insert(bytes.end(), a, letter);
    a = std::exchange(b, a + b);
  }
  Random random(3);
  for (std::size_t i = bytes.size(); i > 1; --i) std::swap(bytes[i - 1], bytes[random.below(i)]);
  bytes.resize(60'000);
  expect_comes_back(bytes);
}

TEST(Deflate, MakesTextSmaller) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "the same words, " + std::to_string(i) + "; ";
  EXPECT_LT(deflate(bytes_of(text)).size(), text.size() / 4);
}

TEST(Sha256, HasTheValuesOfTheStandard) {
  EXPECT_EQ(sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256(bytes_of("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(bytes_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(Bytes(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfSitesDependsOnEveryBitButNotOnTheirOrder) {
  const std::vector<Point3> sites = {{0, 1, 2}, {3, 4, 5}, {-1, 0, 7}};
  const std::string hash = hash_of_sites(sites);
  EXPECT_EQ(hash_of_sites(std::vector<Point3>{sites[2], sites[0], sites[1]}), hash);
  std::vector<Point3> changed = sites;
  changed[1].z = std::nextafter(5.0, 6.0);
  EXPECT_NE(hash_of_sites(changed), hash);
  changed = sites;
  changed[0].x = -0.0;
  EXPECT_NE(hash_of_sites(changed), hash);
}

TEST(HtmlText, StaysText) {
  EXPECT_EQ(markup_text("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(markup_text(std::string("\0\x01\x7f", 3)), "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(markup_text("caf\xc3\xa9 \xf0\x9f\x8f\x94"), "caf\xc3\xa9 \xf0\x9f\x8f\x94");
  EXPECT_EQ(markup_text("\xc3(\xff\xed\xa0\x80\xc0\xaf"),  // cut short, no byte, a surrogate, overlong
            "\xef\xbf\xbd(\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(markup_text("\xe2\x82"), "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(HtmlText, ScriptStringsHoldNoMarkup) {
  EXPECT_EQ(script_string("</script><!--\"\\\n"), R"("\u003c/script\u003e\u003c!--\u0022\u005c\u000a")");
  EXPECT_EQ(script_string("\xe2\x80\xa8\xf0\x9f\x8f\x94"), R"("\u2028\ud83c\udfd4")");
  EXPECT_EQ(script_string("\xff"), R"("\ufffd")");
}

TEST(FloatFrame, SpansAnyRangeOfDoubles) {
  constexpr double kMost = std::numeric_limits<double>::max(),
                   kLeast = std::numeric_limits<double>::denorm_min();
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{{0, 1},
                                                                        {-kMost, kMost},
                                                                        {kMost / 2, kMost},
                                                                        {0, kLeast},
                                                                        {5, 5},
                                                                        {-1e-310, 1e-310},
                                                                        {1e9, 1e9 + 1}}) {
    const FloatFrame frame = FloatFrame::around(low, high);
    for (const double value : {low, high}) {
      const float held = frame(value);
      ASSERT_TRUE(std::isfinite(held)) << low << ' ' << high;
      const double half = 0.5 * frame.origin + 0.5 * static_cast<double>(held) * frame.unit;
      EXPECT_LE(std::fabs(half - 0.5 * value), 1e-6 * (0.5 * high - 0.5 * low) + kLeast)
          << low << ' ' << high;
    }
  }
  EXPECT_EQ(FloatFrame::around(300'000, 500'000).unit, 1);
}

/// The doubles as the page makes them.
std::vector<double> told(const std::vector<double>& near, const Residuals& residuals) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  std::vector<double> values;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const std::uint64_t folded = residuals.values[i];
    const std::uint64_t residual = (folded & 1) != 0 ? ~(folded >> 1) : folded >> 1;
    if (residuals.steps > 0) {
      const double step = std::floor(near[i] * residuals.steps + 0.5);
      values.push_back((step + static_cast<double>(static_cast<std::int64_t>(residual))) / residuals.steps);
    } else {
      const auto bits = std::bit_cast<std::uint64_t>(near[i]);
      const std::uint64_t rank = ((bits & kSign) != 0 ? ~bits : bits | kSign) + residual;
      values.push_back(std::bit_cast<double>((rank & kSign) != 0 ? rank ^ kSign : ~rank));
    }
  }
  return values;
}

/// Packs and unpacks the values; they must come back bit for bit.
Residuals expect_told(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  const FloatFrame frame = FloatFrame::around(low, high);
  std::vector<double> near;
  for (const double value : values) near.push_back(frame.value(frame(value)));
  const Residuals residuals = find_residuals(values, near);
  const std::vector<double> back = told(near, residuals);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i]), std::bit_cast<std::uint64_t>(values[i])) << values[i];
    EXPECT_TRUE(residuals.bytes == 8 || residuals.values[i] >> (8 * residuals.bytes) == 0);
  }
  return residuals;
}

TEST(Residuals, BringBackEveryBit) {
  constexpr double kMost = std::numeric_limits<double>::max(),
                   kLeast = std::numeric_limits<double>::denorm_min();
  expect_told({-kMost, -1, -0.0, 0, kLeast, 1, kMost});
  expect_told({kMost / 2, std::nextafter(kMost, 0), kMost});
  expect_told({-0.0, -0.0});
  expect_told({-kLeast, 0, kLeast, 3 * kLeast});
  expect_told({1, std::nextafter(1, 2), 1e9, 0.1});
  Random random(7);
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i)
    values.push_back(std::ldexp(random.unit() - 0.5, static_cast<int>(random.below(2000)) - 1000));
  expect_told(values);
}

TEST(Residuals, OfDecimalsAndFloatsAreSmall) {
  Random random(8);
  std::vector<double> metres, millimetres, floats;
  for (int i = 0; i < 1000; ++i) {
    metres.push_back(450'000 + static_cast<double>(random.below(30'000)));
    millimetres.push_back((5'000'000'000.0 + static_cast<double>(random.below(100'000'000))) / 1000);
    floats.push_back(static_cast<double>(static_cast<float>(1000 + 20'000 * random.unit())));
  }
  EXPECT_EQ(expect_told(metres).bytes, 0u);
  EXPECT_EQ(expect_told(millimetres).bytes, 1u);
  EXPECT_EQ(expect_told(millimetres).steps, 1000);
  EXPECT_LE(expect_told(floats).bytes, 2u);
  EXPECT_EQ(expect_told({42, 42}).bytes, 0u);
}

TEST(Payload, OfVeryManyVerticesLeavesOutWhatCostsBytes) {
  Report report;
  report.points.resize(kMostExactVertices + 1);
  Random random(9);
  for (std::uint32_t v = 0; v < report.points.size(); ++v) {
    report.points[v] = {random.unit(), static_cast<double>(random.below(1000)), 5};
    report.names.push_back(v);
  }
  for (auto& next : report.downstream) next.assign(report.points.size(), kNoVertex);
  const Payload many = pack(report);
  EXPECT_EQ(many.x.residual_bytes, std::nullopt);
  EXPECT_EQ(many.y.residual_bytes, 0u);
  EXPECT_EQ(many.z.residual_bytes, 0u);
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64({}), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
}

/// A square whose diagonal was exchanged: 0 - 2 before, 1 - 3 after.
Report square(const std::string& file) {
  Report report;
  report.file = report.crs = file;
  report.points = {{0, 0, 1}, {4, 0, 3}, {4, 4, 2}, {0, 4, 5}};
  report.names = {0, 1, 2, 3};
  report.before = {{0, 1, 2}, {0, 2, 3}};
  report.after = {{0, 1, 3}, {1, 2, 3}};
  report.after_order = {1, 1};
  report.downstream = {std::vector<std::uint32_t>{kNoVertex, 0, 0, 0}, {kNoVertex, 0, kNoVertex, 0}};
  report.remaining = {{.vertex = 0, .boundary = true, .reason = "unremovable", .spill_level = INFINITY}};
  report.vertices = 4;
  report.triangles = 2;
  return report;
}

template <class Write>
std::string written(const Write& write) {
  const ScratchFolder folder;
  const std::string path = folder / "out";
  auto file = OutputFile::open(path);
  EXPECT_TRUE(file);
  EXPECT_FALSE(write(*file));
  EXPECT_FALSE(file->commit());
  return content_of(path);
}

constexpr const char* kHostile = "</script><script>alert(1)</script>\"'<!--@DATA@";

TEST(WriteReport, HoldsNoMarkupOfItsData) {
  const std::string page = written([](OutputFile& file) { return write_report(file, square(kHostile)); });
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/script&gt;"), std::string::npos);
  EXPECT_NE(page.find("\"file\":\"\\u003c/script"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(WriteReport, IsTheSameEveryTime) {
  const auto page = [] {
    return written([](OutputFile& file) { return write_report(file, square("a.xyz")); });
  };
  EXPECT_EQ(page(), page());
}

TEST(WriteReport, OfNothingIsAPage) {
  const std::string page = written([](OutputFile& file) { return write_report(file, Report{}); });
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

TEST(WriteSvgMap, DrawsEveryLayerAndNoMarkupOfItsData) {
  const MapLayers all{true, true, true, true, true, true};
  const std::string map =
      written([&](OutputFile& file) { return write_svg_map(file, square(kHostile), all); });
  EXPECT_TRUE(map.starts_with("<svg "));
  EXPECT_TRUE(map.ends_with("</svg>\n"));
  EXPECT_EQ(map.find("<script"), std::string::npos);
  EXPECT_NE(map.find("stroke-dasharray"), std::string::npos);
  EXPECT_NE(map.find("<circle"), std::string::npos);
  EXPECT_EQ(map.find("nan"), std::string::npos);
}

TEST(WriteSvgMap, LeavesOutLayers) {
  MapLayers none{};
  none.edges = none.changes = none.pits = false;
  const std::string map = written([&](OutputFile& file) { return write_svg_map(file, square("a"), none); });
  EXPECT_EQ(map.find("<circle"), std::string::npos);
  EXPECT_EQ(map.find("stroke-dasharray"), std::string::npos);
  EXPECT_TRUE(
      written([&](OutputFile& file) { return write_svg_map(file, Report{}, none); }).ends_with("</svg>\n"));
}

}  // namespace
}  // namespace thalweg::io

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <string>

#include "io/number.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::same_bits;

std::string printed(double value) {
  char buffer[kNumberSize];
  return {buffer, put_number(buffer, value)};
}

TEST(Number, NastyDoublesRoundTripBitForBit) {
  for (const double value : test::nasty_doubles()) {
    const ParsedNumber back = parse_number(printed(value));
    EXPECT_EQ(back.fault, NumberFault::none) << printed(value);
    EXPECT_TRUE(same_bits(back.value, value)) << printed(value);
  }
}

TEST(Number, HasTheDigitsOfTheShortestDecimal) {
  for (const double value : test::nasty_doubles()) {
    const double size = std::fabs(value);
    char buffer[512];
    const auto format = size >= 1e-5 && size < 1e15 ? std::chars_format::fixed : std::chars_format::general;
    const auto end = value == 0 || format == std::chars_format::general
                         ? std::to_chars(buffer, buffer + sizeof buffer, value).ptr
                         : std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr;
    EXPECT_EQ(printed(value), std::string(buffer, end));
  }
}

TEST(Number, IsPrintedWithoutExponentWhereReadable) {
  EXPECT_EQ(printed(400000), "400000");
  EXPECT_EQ(printed(-0.0), "-0");
  EXPECT_EQ(printed(0.001), "0.001");
  EXPECT_EQ(printed(-12.5), "-12.5");
  EXPECT_EQ(printed(0.00001), "0.00001");
  EXPECT_EQ(printed(1e300), "1e+300");
}

TEST(Number, AcceptsEverySpellingOfAFiniteNumber) {
  const std::pair<const char*, double> cases[] = {
      {"1", 1},     {"+1", 1},     {"-1", -1},        {".5", 0.5},    {"5.", 5},
      {"+.5", 0.5}, {"1e3", 1000}, {"1E+3", 1000},    {"1e-3", 1e-3}, {"007", 7},
      {"0e999", 0}, {"-0", -0.0},  {"4e-324", 5e-324}};
  for (const auto& [text, value] : cases) {
    const ParsedNumber parsed = parse_number(text);
    EXPECT_EQ(parsed.fault, NumberFault::none) << text;
    EXPECT_TRUE(same_bits(parsed.value, value)) << text;
  }
}

TEST(Number, TooSmallForADoubleIsZeroOfThatSign) {
  for (const char* text : {"1e-400", "2e-324", "0.00001e-330", "123456e-340", "1e-99999999999999999999"}) {
    const ParsedNumber parsed = parse_number(text);
    EXPECT_EQ(parsed.fault, NumberFault::none) << text;
    EXPECT_TRUE(same_bits(parsed.value, 0.0)) << text;
  }
  EXPECT_TRUE(same_bits(parse_number("-1e-999").value, -0.0));
}

TEST(Number, NamesEveryFault) {
  for (const char* text : {"1e999", "-1e999", "+1e309", "0.001e400", "1000e306", "1e99999999999999999999"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::overflow) << text;
  }
  for (const char* text : {"nan", "NaN", "-nan", "NAN"})
    EXPECT_EQ(parse_number(text).fault, NumberFault::nan) << text;
  for (const char* text : {"inf", "-Inf", "+inf", "infinity"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::infinite) << text;
  }
  for (const char* text : {"1,5", "-12,25", "1.234,5"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::decimal_comma) << text;
  }
  for (const char* text :
       {"abc", "1x", "0x10", "--1", "+-1", "++1", "-", "+", ".", "1e", "1e+", "1 2", "1.2.3", ",5"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::not_a_number) << text;
  }
  EXPECT_EQ(parse_number("").fault, NumberFault::empty);
}

TEST(Number, QuotesWhatIsFoundSafely) {
  EXPECT_EQ(in_quotes("n/a"), "\"n/a\"");
  EXPECT_EQ(in_quotes(std::string_view("a\x1b[31m\0\xff\"", 9)), "\"a\\x1b[31m\\x00\\xff\\\"\"");
  EXPECT_EQ(in_quotes(std::string(1000, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

}  // namespace
}  // namespace thalweg::io

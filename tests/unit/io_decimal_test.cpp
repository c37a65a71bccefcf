/// The fast way from decimals to doubles against std::from_chars and strtod, bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "io/decimal.hpp"
#include "io/number.hpp"
#include "io/random.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::same_bits;

/// Whether scan_decimal, where it answers at all, agrees with std::from_chars in value and end.
bool agrees(const std::string& text, bool& answered) {
  const char* const first = text.data();
  const char* const last = first + text.size();
  double ours = 0;
  const char* const end = scan_decimal(first, last, ours);
  answered = end != nullptr;
  if (!answered) return true;
  double theirs = 0;
  const auto [their_end, fault] = std::from_chars(first, last, theirs);
  return fault == std::errc() && end == their_end && same_bits(ours, theirs);
}

void expect_agreement(const std::string& text) {
  bool answered = false;
  EXPECT_TRUE(agrees(text, answered)) << text;
}

std::string random_digits(Random& random, std::size_t most) {
  std::string out;
  for (std::size_t i = random.below(most + 1); i > 0; --i) out += static_cast<char>('0' + random.below(10));
  return out;
}

TEST(Decimal, RandomStringsAreThoseOfFromChars) {
  Random random(20221122);
  std::size_t count = 0;
  for (int i = 0; i < 1000000; ++i) {
    std::string text = random.below(2) == 0 ? "-" : "";
    text += random_digits(random, 10);
    if (random.below(8) != 0) text += "." + random_digits(random, 18);
    if (random.below(4) == 0) {
      text += random.below(2) == 0 ? "e" : "E";
      text += std::string_view("+-").substr(random.below(2), random.below(2));
      text += random_digits(random, 2);
    }
    if (random.below(4) == 0) text += " ,x\n"[random.below(4)];
    bool answered = false;
    ASSERT_TRUE(agrees(text, answered)) << text;
    count += answered ? 1 : 0;
  }
  EXPECT_GT(count, 600000u);  // the fast way is the usual one
}

TEST(Decimal, ShortestAndLongerFormsOfRandomDoublesReadBack) {
  Random random(20221122);
  std::array<char, 64> buffer{};
  for (int i = 0; i < 300000; ++i) {
    const double value =
        std::ldexp(static_cast<double>(random.next() >> 11), static_cast<int>(random.below(120)) - 110);
    char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    const std::string text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    expect_agreement(text);
    ASSERT_TRUE(same_bits(parse_number(text).value, value)) << text;
    std::snprintf(buffer.data(), buffer.size(), "%.*g", static_cast<int>(15 + random.below(6)), value);
    expect_agreement(buffer.data());
    ASSERT_TRUE(same_bits(parse_number(buffer.data()).value, std::strtod(buffer.data(), nullptr)));
  }
}

/// Halfway between two doubles, and a little to either side: where a wrong rounding shows.
TEST(Decimal, TiesAreRoundedToEvenAndTheirNeighboursAway) {
  Random random(20221122);
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t odd =
        (std::uint64_t{1} << 53 | random.next() >> 11) << 1 | 1;  // 54 bits and half of one
    const int halvings = static_cast<int>(random.below(4));
    std::uint64_t digits = odd;
    for (int h = 0; h < halvings; ++h) digits *= 5;  // odd / 2^h = digits / 10^h
    std::string text = std::to_string(digits);
    if (halvings > 0) text.insert(text.size() - static_cast<std::size_t>(halvings), ".");
    expect_agreement(text);
    expect_agreement(text + (halvings > 0 ? "1" : ".1"));
    expect_agreement(std::to_string(digits - 1));
    expect_agreement(std::to_string(digits + 1) + "e-" + std::to_string(random.below(28)));
    expect_agreement(std::to_string(digits) + "e" + std::to_string(random.below(28)));
    if (HasFailure()) return;
  }
}

TEST(Decimal, EveryPowerWithHardDigits) {
  for (const char* digits :
       {"1", "9007199254740991", "9007199254740992", "9007199254740993", "18446744073709551615",
        "9999999999999999999", "9223372036854775807", "9223372036854775808", "7450580596923828125",
        "4503599627370497", "3", "99999999", "100000000"}) {
    for (int exponent = -40; exponent <= 40; ++exponent) {
      expect_agreement(std::string(digits) + "e" + std::to_string(exponent));
      expect_agreement("-" + std::string(digits) + "E" + std::to_string(exponent));
    }
  }
}

TEST(Decimal, WhatIsNoNumberOrNotSimpleIsLeftToOthers) {
  for (const char* text : {"", "-", ".", "-.", "e5", "1e", "1e+", "1e99999", "nan", "inf", "+1", "x", " 1",
                           "1e28", "1e-28", "12345678901234567890", "0.12345678901234567891"}) {
    double value = 0;
    const std::string_view view = text;
    EXPECT_EQ(scan_decimal(view.data(), view.data() + view.size(), value), nullptr) << text;
  }
  for (const char* text :
       {"0", "-0", "0.", ".0", "-.5", "000000000000000000000001.5", "0.0000000000000000000012", "00000000",
        "1.2.3", "1-2", "0e5", "0e-99", "-0e+12"}) {
    bool answered = false;
    EXPECT_TRUE(agrees(text, answered)) << text;
    EXPECT_TRUE(answered) << text;
  }
}

/// The end of the text is the end of the number, whatever digits lie beyond it.
TEST(Decimal, NothingIsReadBeyondTheEnd) {
  const std::string digits = "123456789.123456789";
  for (std::size_t size = 1; size <= digits.size(); ++size) {
    double value = 0;
    const char* const last = digits.data() + size;
    EXPECT_EQ(scan_decimal(digits.data(), last, value), last);
    EXPECT_TRUE(same_bits(value, std::strtod(digits.substr(0, size).c_str(), nullptr)));
  }
}

}  // namespace
}  // namespace thalweg::io

#include "io/scalar.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace thalweg::io {
namespace {

/// Calls work(T()) with the C++ type of a scalar.
template <class Work>
void with_type(ScalarType type, Work&& work) {
  switch (type) {
    case ScalarType::int8:
      return work(std::int8_t());
    case ScalarType::uint8:
      return work(std::uint8_t());
    case ScalarType::int16:
      return work(std::int16_t());
    case ScalarType::uint16:
      return work(std::uint16_t());
    case ScalarType::int32:
      return work(std::int32_t());
    case ScalarType::uint32:
      return work(std::uint32_t());
    case ScalarType::int64:
      return work(std::int64_t());
    case ScalarType::uint64:
      return work(std::uint64_t());
    case ScalarType::float32:
      return work(float());
    case ScalarType::float64:
      return work(double());
  }
}

template <class T, bool swapped>
T load(const char* bytes) noexcept {
  std::array<unsigned char, sizeof(T)> value;
  std::memcpy(value.data(), bytes, sizeof(T));
  if constexpr (swapped) std::reverse(value.begin(), value.end());
  return std::bit_cast<T>(value);
}

template <class T>
double exact(T value) noexcept {
  const auto real = static_cast<double>(value);
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
    // 2^63 or 2^64, to which the largest are rounded, would overflow on the way back.
    constexpr double kBeyond = std::is_signed_v<T> ? 0x1p63 : 0x1p64;
    if (real >= kBeyond || static_cast<T>(real) != value) return std::numeric_limits<double>::quiet_NaN();
  }
  return real;
}

/// Calls each(i, value) for the value of every record.
template <bool swapped, class T, class Each>
void for_each_value(const char* first, std::size_t stride, std::size_t count, Each&& each) noexcept {
  for (std::size_t i = 0; i < count; ++i) each(i, load<T, swapped>(first + i * stride));
}

template <class Each>
void for_each_value(const Column& column, const char* records, std::size_t stride, std::size_t count,
                    Each&& each) noexcept {
  const char* const first = records + column.offset;
  with_type(column.type, [&]<class T>(T) {
    column.swap ? for_each_value<true, T>(first, stride, count, each)
                : for_each_value<false, T>(first, stride, count, each);
  });
}

bool all_finite(std::span<const Point3> points) noexcept {
  constexpr std::uint64_t kExponent = 0x7ff0000000000000u;
  constexpr std::uint64_t kOne = 0x0010000000000000u;
  const auto overflow = [](double value) { return (std::bit_cast<std::uint64_t>(value) & kExponent) + kOne; };
  std::uint64_t overflows = 0;  // the highest bit of an exponent of all ones
  for (const Point3& p : points) overflows |= overflow(p.x) | overflow(p.y) | overflow(p.z);
  return overflows >> 63 == 0;
}

}  // namespace

std::size_t size_of(ScalarType type) noexcept {
  constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_real(ScalarType type) noexcept {
  return type == ScalarType::float32 || type == ScalarType::float64;
}

double value_of(const Column& column, const char* record) noexcept {
  double value = 0;
  for_each_value(column, record, 0, 1, [&](std::size_t, auto v) { value = static_cast<double>(v); });
  return value;
}

void convert(const Column& column, const char* records, std::size_t stride, std::size_t axis,
             std::span<Point3> points) noexcept {
  constexpr std::array<double Point3::*, 3> kAxes = {&Point3::x, &Point3::y, &Point3::z};
  double Point3::*const coordinate = kAxes[axis];
  for_each_value(column, records, stride, points.size(),
                 [&](std::size_t i, auto value) { points[i].*coordinate = exact(value); });
}

void convert(const Column& column, const char* records, std::size_t stride, std::span<std::uint32_t> values,
             std::size_t values_apart) noexcept {
  const std::size_t count = (values.size() + values_apart - 1) / values_apart;
  for_each_value(column, records, stride, count, [&](std::size_t i, auto value) {
    if constexpr (std::is_integral_v<decltype(value)>)
      values[i * values_apart] = static_cast<std::uint32_t>(value);
  });
}

void from_little_endian(std::span<Point3> points) noexcept {
  if constexpr (std::endian::native == std::endian::little) return;
  for (Point3& p : points) {
    for (double* coordinate : {&p.x, &p.y, &p.z})
      *coordinate = load<double, true>(reinterpret_cast<const char*>(coordinate));
  }
}

std::optional<PointFault> find_not_finite(std::span<const Point3> points, bool nan_z) {
  if (all_finite(points)) return std::nullopt;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double values[] = {points[i].x, points[i].y, points[i].z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = values[axis];
      if (std::isfinite(value) || (axis == 2 && nan_z && std::isnan(value))) continue;
      return PointFault{i, std::string(1, "xyz"[axis]) + (std::isnan(value) ? " is NaN" : " is infinite") +
                               ": correct or remove it"};
    }
  }
  return std::nullopt;
}

}  // namespace thalweg::io

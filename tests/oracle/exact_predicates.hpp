/// The predicates straight from their determinants, in GMP's rational numbers: no filter, no scaling, nothing
/// shared with src/.
#pragma once

#include <gmpxx.h>

#include "thalweg/point.hpp"

namespace oracle {

struct ExactVector {
  mpq_class x, y;
};

/// from -> to, exactly.
inline ExactVector exact_vector(thalweg::Point2 from, thalweg::Point2 to) {
  return {mpq_class(to.x) - mpq_class(from.x), mpq_class(to.y) - mpq_class(from.y)};
}

inline mpq_class squared(const ExactVector& v) {
  return v.x * v.x + v.y * v.y;
}

inline int orient2d(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c) {
  const ExactVector u = exact_vector(a, b);
  const ExactVector v = exact_vector(a, c);
  return sgn(mpq_class(u.x * v.y - u.y * v.x));
}

/// The 3 x 3 determinant expanded along its first row.
inline int incircle(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c, thalweg::Point2 d) {
  const ExactVector u = exact_vector(d, a);
  const ExactVector v = exact_vector(d, b);
  const ExactVector w = exact_vector(d, c);
  const mpq_class v2 = squared(v);
  const mpq_class w2 = squared(w);
  return sgn(mpq_class(u.x * (v.y * w2 - v2 * w.y) - u.y * (v.x * w2 - v2 * w.x) +
                       squared(u) * (v.x * w.y - v.y * w.x)));
}

inline int compare_distance(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c) {
  return sgn(mpq_class(squared(exact_vector(a, b)) - squared(exact_vector(a, c))));
}

/// incircle with each point lifted by a power of a tiny number, the larger the point in (x, y) the larger the
/// lift: the lifts are real, chosen so small that they change no sign but 0. Meant for small integer
/// coordinates (|.| <= 32).
inline int incircle_lifted(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c, thalweg::Point2 d) {
  const thalweg::Point2 points[4] = {a, b, c, d};
  mpq_class lift[4];
  for (int i = 0; i < 4; ++i) {
    mp_bitcnt_t larger = 0;
    for (const thalweg::Point2& p : points) {
      if (p.x > points[i].x || (p.x == points[i].x && p.y > points[i].y)) ++larger;
    }
    // Twice an area is an integer below 2^14, so 2^20 between the lifts lets the larger one outweigh all
    // others.
    lift[i] = mpq_class(1) >> (20 * (larger + 1));
  }
  mpq_class row[3][3];
  for (int i = 0; i < 3; ++i) {
    const ExactVector u = exact_vector(d, points[i]);
    row[i][0] = u.x;
    row[i][1] = u.y;
    row[i][2] = squared(u) + lift[i] - lift[3];
  }
  return sgn(mpq_class(row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
                       row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
                       row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0])));
}

}  // namespace oracle

/// What properties of minimize_pits draw beside the cloud, and what they compare.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "support/run.hpp"

namespace support {

inline rc::Gen<unsigned> orders() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, 9u));
}

inline thalweg::Method any_method() {
  const thalweg::Method method =
      *rc::gen::element(thalweg::Method::delaunay, thalweg::Method::flip, thalweg::Method::hull,
                        thalweg::Method::best, thalweg::Method::exact);
  RC_LOG() << "method " << method_name(method) << "\n";
  return method;
}

inline std::vector<oracle::Tri> shape(const thalweg::Minimized& m) {
  return oracle::normal_form(triangles_of(m.triangulation));
}

}  // namespace support

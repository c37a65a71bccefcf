/// The random numbers of the command: those of the generators, so that a seed means the same everywhere.
#pragma once

#include "io/random.hpp"

namespace thalweg::cli {

using io::Random;

}  // namespace thalweg::cli

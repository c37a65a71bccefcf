#include "thalweg/predicates.hpp"

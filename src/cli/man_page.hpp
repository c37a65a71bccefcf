/// The manual page, made of what --help is made of.
#pragma once

#include <string>

namespace thalweg::cli {

/// The text of thalweg(1) for man(1): the same for the same version, without a date.
std::string man_page();

}  // namespace thalweg::cli

/// Text that goes into a page or a drawing without becoming part of its markup.
#pragma once

#include <string>
#include <string_view>

namespace thalweg::io {

/// `text` as valid UTF-8 for the content or a quoted attribute of HTML or XML: & < > " ' are escaped, bytes
/// that are no UTF-8 and characters that XML forbids become U+FFFD.
std::string markup_text(std::string_view text);

/// `text` as a JSON string, quotes included, that may stand inside a <script> element: plain ASCII without <,
/// > or &, so that neither an end tag nor a comment can begin in it.
std::string script_string(std::string_view text);

}  // namespace thalweg::io

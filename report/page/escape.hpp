#pragma once

#include <string>
#include <string_view>

namespace jointid::report {

/// `text` for HTML content and quoted attributes: & < > " ' become entities, control characters but line ends and tabs blanks.
std::string html(std::string_view text);

/// JSON for the inside of a <script> element: every < becomes \u003c, so that nothing in it can end the element or open a
/// comment.
std::string script_json(std::string json);

}  // namespace jointid::report

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace rebound::report {

/// `text` with & < > " ' as character references: harmless in HTML text and attributes.
std::string escape_html(std::string_view text);

/// `object` as JSON that is harmless inside a <script> element: no '<' is left, so a
/// name such as "</script>" ends nothing. The value read back is the same.
/// Errors: Error(bad_input) for text that is not UTF-8.
std::string script_safe_json(const nlohmann::json& object);

/// The whole page as one HTML text: drawing library, renderer, style and data inside.
/// Its content security policy forbids every network request.
std::string page_html(const std::string& title, const nlohmann::json& object);

}  // namespace rebound::report

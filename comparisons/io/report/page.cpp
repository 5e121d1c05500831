#include "comparisons/io/report/page.hpp"

#include <array>
#include <utility>

#include "comparisons/io/report/embedded.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::report {

std::string escape_html(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string script_safe_json(const nlohmann::json& object) {
  std::string text;
  try {
    text = object.dump();
  } catch (const nlohmann::json::type_error&) {
    throw Error(ExitCode::bad_input, "a text of the report is not UTF-8");
  }
  // In JSON a '<' only occurs inside strings, where its escape means the same.
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string page_html(const std::string& title, const nlohmann::json& object) {
  const std::string data = script_safe_json(object);
  const std::string safe_title = escape_html(title);
  const std::array<std::pair<std::string_view, std::string_view>, 5> parts{{
      {"{{title}}", safe_title},
      {"{{style}}", embedded::style},
      {"{{data}}", data},
      {"{{renderer}}", embedded::renderer},
      {"{{drawing_library}}", embedded::drawing_library},
  }};
  // One pass over the template: what is put in is never searched for places.
  std::string out;
  std::string_view rest = embedded::page_template;
  for (const auto& [place, content] : parts) {
    const std::size_t at = rest.find(place);
    if (at == std::string_view::npos) {
      throw Error(ExitCode::input_output_failed,
                  "the page template has no place " + std::string(place) + " where it is due");
    }
    out += rest.substr(0, at);
    out += content;
    rest.remove_prefix(at + place.size());
  }
  out += rest;
  return out;
}

}  // namespace rebound::report

#pragma once

#include <string_view>

/// The renderer's source files, compiled in by embed.cmake.
namespace rebound::report::embedded {

extern const std::string_view page_template;
extern const std::string_view style;
extern const std::string_view drawing_library;
extern const std::string_view renderer;

}  // namespace rebound::report::embedded

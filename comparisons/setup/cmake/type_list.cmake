# include_listed_types(LIST MACRO FOLDER SOURCES)
#
# LIST holds lines MACRO(Type …), one a type. Writes generated/FOLDER/<name>_headers.hpp of the
# build folder, <name> being MACRO without REBOUND_ in lower case: an #include of FOLDER/<type>.hpp
# for every line, <type> being Type in snake case. SOURCES becomes the list of those <type>.cpp
# that there are. A line whose header is missing, and a list without a line, end the configuration.
function(include_listed_types list macro folder sources)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} lines REGEX "^${macro}\\(")
  if(NOT lines)
    message(FATAL_ERROR "${list} lists nothing: no line begins with ${macro}(")
  endif()
  set(includes "")
  set(found "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^${macro}\\(([A-Za-z0-9]+).*" "\\1" type "${line}")
    string(REGEX REPLACE "([a-z0-9])([A-Z])" "\\1_\\2" file "${type}")
    string(TOLOWER "${file}" file)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${folder}/${file}.hpp)
      message(FATAL_ERROR "${list} lists ${type}, but there is no ${folder}/${file}.hpp")
    endif()
    string(APPEND includes "#include \"${folder}/${file}.hpp\"\n")
    if(EXISTS ${PROJECT_SOURCE_DIR}/${folder}/${file}.cpp)
      list(APPEND found ${PROJECT_SOURCE_DIR}/${folder}/${file}.cpp)
    endif()
  endforeach()
  string(REGEX REPLACE "^REBOUND_" "" name "${macro}")
  string(TOLOWER "${name}" name)
  file(RELATIVE_PATH shown ${PROJECT_SOURCE_DIR} ${list})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${folder}/${name}_headers.hpp
    CONTENT "#pragma once\n\n// Written by CMake from ${shown}.\n${includes}" @ONLY)
  set(${sources} ${found} PARENT_SCOPE)
endfunction()

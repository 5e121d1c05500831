# cmake -DOUTPUT=... -DTEMPLATE=... -DSTYLE=... -DLIBRARY=... -DRENDERER=a;b -P embed.cmake
# Writes a C++ source that holds the renderer's files as raw string literals.
cmake_policy(SET CMP0007 NEW)

function(literal name file_list wrap_begin wrap_end)
  set(text "${wrap_begin}")
  foreach(file IN LISTS file_list)
    file(READ "${file}" content)
    if(content MATCHES "\\)embedded\"")
      message(FATAL_ERROR "${file} holds the end mark of a raw string literal")
    endif()
    string(APPEND text "${content}")
  endforeach()
  string(APPEND text "${wrap_end}")
  file(APPEND "${OUTPUT}.part"
    "const std::string_view ${name} = R\"embedded(" "${text}" ")embedded\";\n")
endfunction()

file(WRITE "${OUTPUT}.part"
  "#include \"comparisons/io/report/embedded.hpp\"\n"
  "namespace rebound::report::embedded {\n")
literal(page_template "${TEMPLATE}" "" "")
literal(style "${STYLE}" "" "")
literal(drawing_library "${LIBRARY}" "" "")
# One scope for all files of the renderer, and nothing of it on the page's window.
literal(renderer "${RENDERER}" "(() => {\n\"use strict\";\n" "})();\n")
file(APPEND "${OUTPUT}.part" "}  // namespace rebound::report::embedded\n")
file(RENAME "${OUTPUT}.part" "${OUTPUT}")

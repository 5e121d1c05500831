# cmake -DOUTPUT=... -DHEADER=... -DFUNCTION=... -DTYPE=... "-DFILES=a;b" -P embed_files.cmake
# Writes a C++ source with `const std::vector<TYPE>& FUNCTION()`, declared in HEADER: the texts of
# the files, each as {name without its ending, text}.
set(text "#include \"${HEADER}\"\n\nnamespace rebound {\n\n"
         "const std::vector<${TYPE}>& ${FUNCTION}() {\n"
         "  static const std::vector<${TYPE}> list{\n")
list(JOIN text "" text)
file(WRITE "${OUTPUT}.part" "${text}")
foreach(one IN LISTS FILES)
  get_filename_component(name "${one}" NAME_WE)
  file(READ "${one}" content)
  if(content MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${one} holds the end mark of a raw string literal")
  endif()
  file(APPEND "${OUTPUT}.part" "      {\"${name}\", R\"embedded(" "${content}" ")embedded\"},\n")
endforeach()
file(APPEND "${OUTPUT}.part" "  };\n  return list;\n}\n\n}  // namespace rebound\n")
file(RENAME "${OUTPUT}.part" "${OUTPUT}")

# cmake -DOUTPUT=... "-DSCHEMAS=a;b" -P embed_schemas.cmake
# Writes a C++ source that holds the schemas of output, each by the name of its file.
set(text "#include \"comparisons/app/stored_schemas.hpp\"\n\nnamespace rebound {\n\n"
         "const std::vector<StoredSchema>& stored_schemas() {\n"
         "  static const std::vector<StoredSchema> list{\n")
list(JOIN text "" text)
file(WRITE "${OUTPUT}.part" "${text}")
foreach(schema IN LISTS SCHEMAS)
  get_filename_component(name "${schema}" NAME_WE)
  file(READ "${schema}" content)
  if(content MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${schema} holds the end mark of a raw string literal")
  endif()
  file(APPEND "${OUTPUT}.part" "      {\"${name}\", R\"embedded(" "${content}" ")embedded\"},\n")
endforeach()
file(APPEND "${OUTPUT}.part" "  };\n  return list;\n}\n\n}  // namespace rebound\n")
file(RENAME "${OUTPUT}.part" "${OUTPUT}")

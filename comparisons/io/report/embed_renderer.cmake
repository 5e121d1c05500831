# Puts the report's renderer and the drawing library into one C++ source, ${embedded_renderer}.
set(report_folder ${CMAKE_CURRENT_LIST_DIR})
set(drawing_library ${report_folder}/vendor/plotly-cartesian.min.js)
set(drawing_library_sha256 7c593b9eda0e74a1d07335cf89cbf7a55ffc114909980c3729af835453bdb02a)
file(SHA256 ${drawing_library} found_sha256)
if(NOT found_sha256 STREQUAL drawing_library_sha256)
  message(FATAL_ERROR "${drawing_library} is not the file that vendor/README.md describes")
endif()

# In the order in which they are put together: helpers first, the page last.
set(renderer_files text.js marks.js figure.js animation.js table.js matrix.js overlays.js report.js)
list(TRANSFORM renderer_files PREPEND ${report_folder}/renderer/)
set(page_template ${report_folder}/renderer/page.html)
set(style ${report_folder}/renderer/style.css)
set(embedded_renderer ${CMAKE_CURRENT_BINARY_DIR}/embedded.cpp)

add_custom_command(
  OUTPUT ${embedded_renderer}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded_renderer} -DTEMPLATE=${page_template} -DSTYLE=${style}
          -DLIBRARY=${drawing_library} "-DRENDERER=${renderer_files}"
          -P ${report_folder}/embed.cmake
  DEPENDS ${report_folder}/embed.cmake ${page_template} ${style} ${drawing_library} ${renderer_files}
  COMMENT "Embedding the report's renderer"
  VERBATIM)

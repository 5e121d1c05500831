# discover_suites(TARGET LABELS TIMEOUT [LONG-SUITE...]): one CTest entry for every suite that the built program
# lists, so that none can be forgotten or renamed away; tests of a suite share what it has computed.
# An entry that runs no test fails. Suites that are named take minutes: they have the label `long` besides.
function(discover_suites target labels timeout)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DNAME=${target} -DPROGRAM=$<TARGET_FILE:${target}> -DOUTPUT=${file}
            "-DLABELS=${labels}" "-DLONG=${ARGN}" -DTIMEOUT=${timeout} -P ${PROJECT_SOURCE_DIR}/comparisons/setup/cmake/list_suites.cmake
    BYPRODUCTS ${file} VERBATIM)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake
    "if(EXISTS \"${file}\")\n  include(\"${file}\")\nelse()\n  add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY
    TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
endfunction()

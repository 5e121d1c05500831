# require_tool(VARIABLE PROGRAM PACKAGE): finds a program that tests need, or ends the
# configuration. A test that skips itself where its tool is missing is one that cannot fail.
function(require_tool variable program package)
  find_program(${variable} NAMES ${program})
  if(NOT ${variable})
    message(FATAL_ERROR "The tests need ${program} (Debian: ${package}). Install it, or leave all "
                        "tests out with -DREBOUND_TESTS=OFF.")
  endif()
  set(${variable} ${${variable}} PARENT_SCOPE)
endfunction()

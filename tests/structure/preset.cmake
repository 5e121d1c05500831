# Builds one preset of CMakePresets.json in a folder of its own and runs its tests.
# In: SOURCE, BUILD (the build of these tests), FOLDER, PRESET, TARGETS, TESTS and BUT (regular expressions: which tests, but not which).
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE status
    OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${status}:\n${text}")
  endif()
  message("${text}")
endfunction()

# Objects that come out as in BUILD are taken over from there; the others are compiled without optimisation.
set(ENV{DONE_SOURCE} ${SOURCE})
set(ENV{NEW_SOURCE} ${SOURCE})
set(ENV{DONE_BUILD} ${BUILD})
set(ENV{NEW_BUILD} ${FOLDER})
run(${CMAKE_COMMAND} --preset ${PRESET} -B ${FOLDER} -DREBOUND_BENCHMARKS=OFF
  "-DCMAKE_CXX_COMPILER_LAUNCHER=/usr/bin/python3\\;-B\\;${SOURCE}/tests/support/reuse_object.py")
string(REPLACE "," ";" TARGETS "${TARGETS}")
run(${CMAKE_COMMAND} --build ${FOLDER} --target ${TARGETS})
run(${CMAKE_CTEST_COMMAND} --test-dir ${FOLDER} --no-tests=error --output-on-failure
  -R ${TESTS} -E ${BUT})

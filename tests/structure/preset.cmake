# Builds one preset of CMakePresets.json in a folder of its own and runs its tests.
# In: SOURCE, FOLDER, PRESET, TARGETS, TESTS and BUT (regular expressions: which tests, but not which).
function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE status
    OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${status}:\n${text}")
  endif()
  message("${text}")
endfunction()

# Without optimisation, for what is built is used for seconds.
run(${CMAKE_COMMAND} --preset ${PRESET} -B ${FOLDER} -DREBOUND_BENCHMARKS=OFF
  -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CURRENT_LIST_DIR}/without_optimisation)
string(REPLACE "," ";" TARGETS "${TARGETS}")
run(${CMAKE_COMMAND} --build ${FOLDER} --target ${TARGETS})
run(${CMAKE_CTEST_COMMAND} --test-dir ${FOLDER} --no-tests=error --output-on-failure
  -R ${TESTS} -E ${BUT})

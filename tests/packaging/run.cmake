# Installs the build into a folder of its own, builds the consumer against it, and runs
# it, the installed program beside it. In: BUILD, SOURCE, FOLDER, GENERATOR.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${status}:\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()
function(expect pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "expected ${pattern} in:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/usr)
run(${CMAKE_COMMAND} -S ${SOURCE}/consumer -B ${FOLDER}/consumer -G ${GENERATOR}
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${FOLDER}/usr)
run(${CMAKE_COMMAND} --build ${FOLDER}/consumer)
# Moved away from the libraries, it still has to find the FE module of this prefix.
run(${CMAKE_COMMAND} -E copy ${FOLDER}/consumer/consumer ${FOLDER}/usr/bin/consumer)
run(${FOLDER}/usr/bin/consumer)
expect("lumped restitution 0\\.66[0-9]+")
if(FEM)
  expect("fem restitution 0\\.9[0-9]+")
endif()
run(${FOLDER}/usr/bin/rebound reproduce)
run(${FOLDER}/usr/bin/rebound doctor)

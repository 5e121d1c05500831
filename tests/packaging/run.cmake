# Installs the build into a folder of its own, builds the consumer against it, and runs
# it, the installed program beside it. In: BUILD, SOURCE, FOLDER, GENERATOR.
include(${CMAKE_CURRENT_LIST_DIR}/run_and_expect.cmake)

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
foreach(file bash-completion/completions/rebound zsh/site-functions/_rebound
    fish/vendor_completions.d/rebound.fish man/man1/rebound.1 man/man1/rebound-diagnose.1)
  if(NOT EXISTS ${FOLDER}/usr/share/${file})
    message(FATAL_ERROR "not installed: share/${file}")
  endif()
endforeach()

# `cpack -G DEB`: what the packages hold, what they need, and that they work from a root of their
# own. In: BUILD, FOLDER, FEM, PYTHON (the interpreter; empty: no module).
include(${CMAKE_CURRENT_LIST_DIR}/run_and_expect.cmake)

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -G DEB -B ${FOLDER})
file(GLOB packages ${FOLDER}/*.deb)
foreach(package IN LISTS packages)
  run(dpkg-deb -x ${package} ${FOLDER}/root)
endforeach()

# The lumped tier needs no deal.II.
file(GLOB program ${FOLDER}/rebound_*.deb)
run(dpkg-deb -f ${program} Depends)
expect("rebound-data \\(= [0-9.]+\\), .*libsundials")
if(output MATCHES "deal.ii|gmsh|openmpi")
  message(FATAL_ERROR "the lumped tier depends on FE libraries: ${output}")
endif()
if(FEM)
  file(GLOB fem ${FOLDER}/rebound-fem_*.deb)
  run(dpkg-deb -f ${fem} Depends)
  expect("libdeal.ii-[0-9.]+ .*libgmsh")
endif()

set(rebound ${FOLDER}/root/usr/bin/rebound)
run(${CMAKE_COMMAND} -E chdir ${FOLDER} ${rebound} init --out first)
run(${CMAKE_COMMAND} -E chdir ${FOLDER} ${rebound} doctor)
run(${rebound} lumped ${FOLDER}/first/lumped.toml)
expect("restitution +0\\.66")
if(FEM)
  run(${rebound} fem ${FOLDER}/first/fem.toml)
  expect("restitution_momentum +0\\.779")
  # Without its package FE is refused, or else the build's own library was found above.
  file(REMOVE_RECURSE ${FOLDER}/root/usr/lib/rebound)
  execute_process(COMMAND ${rebound} fem ${FOLDER}/first/fem.toml RESULT_VARIABLE status ERROR_VARIABLE output)
  if(NOT status EQUAL 4)
    message(FATAL_ERROR "FE without its package ended with ${status}: ${output}")
  endif()
endif()
if(PYTHON)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${FOLDER}/root/usr/lib/python3/dist-packages ${PYTHON} -c
    "import rebound_impact as ri
print(ri.__file__, ri.lumped('${FOLDER}/first/lumped.toml').restitution)")
  expect("root/usr/lib/python3/dist-packages/rebound_impact.* 0\\.66")
endif()

# Installs Marrow, moves the installation, builds a project against it and runs that:
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DGENERATOR=... -DVTK_DIR=... -P RunConsumer.cmake
function (run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
file(RENAME "${WORK}/installed" "${WORK}/moved")
foreach (project IN ITEMS Testing/Consumer Examples/Cxx)
  run("${CMAKE_COMMAND}" -S "${SOURCE}/${project}" -B "${WORK}/${project}" -G "${GENERATOR}"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${WORK}/moved" "-DVTK_DIR=${VTK_DIR}")
  run("${CMAKE_COMMAND}" --build "${WORK}/${project}")
endforeach ()
run("${WORK}/Testing/Consumer/consumer")
run("${WORK}/Examples/Cxx/Measures" "${WORK}/measures.png")
run("${WORK}/moved/bin/marrow" --version)

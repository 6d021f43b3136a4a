# SOURCE: the project; COPY: a folder to work in. The copy lies as deep as the project's own build folder, so that the
# compiler cache knows every file but the new ones.
file(REMOVE_RECURSE ${COPY})
file(COPY ${SOURCE}/apps ${SOURCE}/cmake ${SOURCE}/ganglion ${SOURCE}/CMakeLists.txt ${SOURCE}/CMakePresets.json
     DESTINATION ${COPY})

set(kind ${COPY}/ganglion/sensing/copycat)
file(GLOB files ${SOURCE}/ganglion/sensing/closing_speed/*)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  string(REPLACE closing_speed copycat name ${name})
  file(READ ${file} text)
  string(REPLACE closing_speed copycat text "${text}")
  string(REPLACE ClosingSpeed Copycat text "${text}")
  file(WRITE ${kind}/${name} "${text}")
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${COPY} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --preset release -DGANGLION_TESTS=OFF)
run(${CMAKE_COMMAND} --build build/release --target ganglion)
foreach(call "kinds;--json" "kinds;Copycat" "kinds;Copycat;--language;es")
  run(build/release/bin/ganglion ${call})
  if(NOT said MATCHES "Copycat")
    message(FATAL_ERROR "ganglion ${call} does not know the new kind: ${said}")
  endif()
endforeach()
file(REMOVE_RECURSE ${COPY})

# SOURCE: the project; COPY: a folder to work in; PYTHON: python3. The copy lies as deep as the project's own build folder, so that the
# compiler cache knows every file but the new ones; source by source, as ./dev lint has compiled them, since what is compiled
# together names the folder it stands in.
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

# A picture is a kind like any other, of a layer that makes its own list.
file(READ ${SOURCE}/ganglion/plot/picture/bars/bars.cpp text)
string(REPLACE "bars_kind" "copied_bars_kind" text "${text}")
string(REPLACE ".name = \"Bars\"" ".name = \"CopiedBars\"" text "${text}")
file(WRITE ${COPY}/ganglion/plot/picture/copied_bars/copied_bars.cpp "${text}")
file(WRITE ${COPY}/ganglion/plot/picture/copied_bars/CMakeLists.txt "ganglion_add_kind(copied_bars)\n")

# And the kind that CONTRIBUTING.md walks through, as its text stands there.
execute_process(COMMAND ${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/made_files.py ${SOURCE}/CONTRIBUTING.md ${COPY}
                COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${COPY}/ganglion/sensing/low_pass/CMakeLists.txt "ganglion_add_kind(low_pass)\n")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${COPY} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --preset plain -DGANGLION_TESTS=OFF -DGANGLION_STUDIO=OFF)
run(${CMAKE_COMMAND} --build build/plain --target ganglion)
foreach(call "kinds;--json" "kinds;Copycat" "kinds;Copycat;--language;es")
  run(build/plain/bin/ganglion ${call})
  if(NOT said MATCHES "Copycat")
    message(FATAL_ERROR "ganglion ${call} does not know the new kind: ${said}")
  endif()
endforeach()
foreach(call "kinds" "plot;--help")
  run(build/plain/bin/ganglion ${call})
  if(NOT said MATCHES "CopiedBars")
    message(FATAL_ERROR "ganglion ${call} does not know the new picture: ${said}")
  endif()
endforeach()
run(build/plain/bin/ganglion kinds LowPass)
if(NOT said MATCHES "time_constant_s")
  message(FATAL_ERROR "the kind of CONTRIBUTING.md is another than it shows: ${said}")
endif()
# The only program of the tests that is built without the studio says so.
execute_process(COMMAND build/plain/bin/ganglion studio experiments WORKING_DIRECTORY ${COPY} RESULT_VARIABLE code
                ERROR_VARIABLE said)
if(NOT code EQUAL 2 OR NOT said MATCHES "built without the studio")
  message(FATAL_ERROR "a program without the studio ended with ${code} and said: ${said}")
endif()
file(REMOVE_RECURSE ${COPY})

# SOURCE: the project; COPY: a folder to work in; PYTHON: python3. The copy lies as deep as the project's own build folder, so that the
# compiler cache knows every file but the new ones; source by source, as ./dev lint has compiled them, since what is compiled
# together names the folder it stands in.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${COPY})
file(COPY ${SOURCE}/apps ${SOURCE}/cmake ${SOURCE}/ganglion ${SOURCE}/experiments ${SOURCE}/CMakeLists.txt
          ${SOURCE}/CMakePresets.json DESTINATION ${COPY})
file(WRITE ${COPY}/tests/CMakeLists.txt "include(GanglionAreaTests)\n")

# One of each class of kinds, copied into a folder of its own and named anew; nothing else is edited.
# Folder of the class | folder of the kind | its name | the schema it is in, or none
set(table
  "acting|avoid_obstacle|AvoidObstacle|controller"
  "coordination|priority|Priority|controller"
  "goal|constant|Constant|controller"
  "measure|duration|Duration|none"
  "plant|process|Process|plant"
  "sensing|sonar_conditioner|SonarConditioner|controller"
  "sim/drive|tracked|Tracked|robot"
  "sim/sensor|compass|Compass|robot"
  "task|hold|Hold|robot")

set(copies "")
foreach(row IN LISTS table)
  string(REPLACE "|" ";" row "${row}")
  list(GET row 0 class)
  list(GET row 1 folder)
  list(GET row 2 name)
  list(APPEND copies Copied${name})
  file(GLOB files ${SOURCE}/ganglion/${class}/${folder}/*)
  foreach(file IN LISTS files)
    cmake_path(GET file FILENAME to)
    string(REPLACE ${folder} copied_${folder} to ${to})
    file(READ ${file} text)
    string(REPLACE ${folder} copied_${folder} text "${text}")
    string(REPLACE ${name} Copied${name} text "${text}")
    file(WRITE ${COPY}/ganglion/${class}/copied_${folder}/${to} "${text}")
  endforeach()
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

# run(EXPECTED_EXIT_CODE COMMAND...): leaves what it said in `said`.
function(run expected)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${COPY} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "${ARGN} ended with ${code}: ${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

# expect_in(WHERE TEXT WORDS...)
function(expect_in where text)
  foreach(word IN LISTS ARGN)
    string(FIND "${text}" "${word}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${where} does not know ${word}: ${text}")
    endif()
  endforeach()
endfunction()

set(program build/plain/bin/ganglion)
run(0 ${CMAKE_COMMAND} --preset plain -DGANGLION_STUDIO=OFF)
run(0 ${CMAKE_COMMAND} --build build/plain --target ganglion test_kinds)

# Listed wherever their classes are: `--json` is the palette of the studio as well.
foreach(call "kinds" "kinds;--json" "kinds;--markdown;--language;en" "kinds;--markdown;--language;es")
  run(0 ${program} ${call})
  expect_in("ganglion ${call}" "${said}" ${copies})
endforeach()
foreach(row IN LISTS table)
  string(REPLACE "|" ";" row "${row}")
  list(GET row 2 name)
  list(GET row 3 schema)
  foreach(language en es)
    run(0 ${program} kinds Copied${name} --language ${language})
    expect_in("its own page" "${said}" "# Copied${name}")
  endforeach()
  if(NOT schema STREQUAL "none")
    run(0 ${program} schema ${schema})
    expect_in("schema ${schema}" "${said}" "\"Copied${name}\"")
  endif()
endforeach()
foreach(call "kinds" "plot;--help")
  run(0 ${program} ${call})
  expect_in("ganglion ${call}" "${said}" CopiedBars)
endforeach()

# The tests that walk the kinds walk them: one for each, of ticks that take no memory whatever is read.
run(0 build/plain/bin/test_kinds --gtest_filter=EveryKind* --gtest_brief=0)
foreach(name IN LISTS copies)
  expect_in("test_kinds" "${said}" "/${name} (")
endforeach()

# They do what those did that they were copied from; their outputs, measures and names are in the report.
set(short experiments/nimrod --set run.duration_s=5 --set "success=[]" --json)
run(0 ${program} run ${short} --no-record)
string(JSON digest GET "${said}" runs 0 digest)
foreach(file controller robot)
  file(READ ${COPY}/experiments/nimrod/${file}.toml text)
  foreach(name IN LISTS copies)
    string(REPLACE Copied "" original ${name})
    string(REPLACE "kind = \"${original}\"" "kind = \"${name}\"" text "${text}")
  endforeach()
  file(WRITE ${COPY}/experiments/nimrod/${file}.toml "${text}")
endforeach()
run(0 ${program} run ${short} --set "run.stop=[\"copied_duration_s >= 5\"]" --out runs)
expect_in("the run" "${said}" ${digest} "\"copied_duration_s\"")
file(GLOB report ${COPY}/runs/*.html)
file(READ ${report} said)
expect_in("the report" "${said}" "copied_duration_s")

run(0 ${program} kinds LowPass)
if(NOT said MATCHES "time_constant_s")
  message(FATAL_ERROR "the kind of CONTRIBUTING.md is another than it shows: ${said}")
endif()
# The only program of the tests that is built without the studio says so.
run(2 ${program} studio experiments)
expect_in("a program without the studio" "${said}" "built without the studio")
file(REMOVE_RECURSE ${COPY})

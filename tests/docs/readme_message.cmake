# PROGRAM: ganglion; SOURCE: the project; WORK: a folder to write to. The message that both READMEs show is what comes of
# misspelling one wire of the example they show.
file(READ ${SOURCE}/examples/04_two_behaviours/controller.toml text)
string(REPLACE "in.left = \"sonar_left\"" "in.left = \"sonar_lft\"" text "${text}")
string(REPLACE "../../experiments" "${SOURCE}/experiments" text "${text}")
file(WRITE ${WORK}/controller.toml "${text}")
execute_process(COMMAND ${PROGRAM} check controller.toml WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code ERROR_VARIABLE said
                OUTPUT_VARIABLE said)
foreach(page README.md README.es.md)
  file(READ ${SOURCE}/${page} text)
  string(REGEX MATCH "\ncontroller.toml:[0-9]+:[0-9]+: [^\n]*" shown "${text}")
  string(STRIP "${shown}" shown)
  string(FIND "${said}" "${shown}\n" at)
  if(shown STREQUAL "" OR at LESS 0)
    message(FATAL_ERROR "${page} shows \"${shown}\", the program says:\n${said}")
  endif()
endforeach()

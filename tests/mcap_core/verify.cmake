# Run by ctest: writes sample runs and has the format's reference library read them.
if(NOT EXISTS ${SOURCE}/node_modules/@mcap/core OR NOT NODE)
  message(FATAL_ERROR "node or tests/mcap_core/node_modules is missing: run ./dev test, which installs it")
endif()
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${WRITE_SAMPLES} ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} ${SOURCE}/verify.mjs ${FOLDER}/full.mcap ${FOLDER}/empty.mcap ${FOLDER}/recovered.mcap
                OUTPUT_VARIABLE found ERROR_VARIABLE problem RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${found}${problem}")
endif()
# 1000 rows + 100 rows + 250 poses + 1 grid.
foreach(wanted "full.mcap: {\"messages\":1351,\"attachments\":2,\"metadata\":2," "empty.mcap: {\"messages\":0,")
  string(FIND "${found}" "${wanted}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "expected ${wanted}\nfound ${found}")
  endif()
endforeach()

# Of the first half of the file some chunks are saved; recovery adds a metadata record and the outcome is lost.
if(NOT found MATCHES "recovered.mcap: {\"messages\":[1-9][0-9][0-9],\"attachments\":2,\"metadata\":2,")
  message(FATAL_ERROR "the recovered file is not as expected:\n${found}")
endif()

# A reader that finds no fault in a damaged file would prove nothing.
file(COPY_FILE ${FOLDER}/full.mcap ${FOLDER}/damaged.mcap)
file(APPEND ${FOLDER}/damaged.mcap "x")
execute_process(COMMAND ${NODE} ${SOURCE}/verify.mjs ${FOLDER}/damaged.mcap RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "verify.mjs took a damaged file for good")
endif()

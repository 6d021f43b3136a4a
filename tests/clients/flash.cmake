# How much flash clients/c takes on a Cortex-M0+: text and constants of its files, without libgcc, startup and example.
set(limit 2048)
if(NOT GCC OR NOT SIZE)
  message("SKIPPED: NOT TESTED: the flash of the robot in C was not measured. Needed: gcc-arm-none-eabi; ./dev test "
          "clients installs it")
  return()
endif()
file(MAKE_DIRECTORY ${WORK})
foreach(carrier serial stream)
  set(define)
  if(carrier STREQUAL stream)
    set(define -DGANGLION_ROBOT_STREAM)
  endif()
  execute_process(COMMAND ${GCC} -std=c99 -Os -mcpu=cortex-m0plus -mthumb -ffreestanding -Wall -Wextra -Wpedantic -Werror
                          ${define} -c ${SOURCE}/clients/c/ganglion_robot.c -o ${WORK}/${carrier}.o
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${SIZE} ${WORK}/${carrier}.o OUTPUT_VARIABLE table COMMAND_ERROR_IS_FATAL ANY)
  if(NOT table MATCHES "\n *([0-9]+)[ \t]+([0-9]+)[ \t]+([0-9]+)")
    message(FATAL_ERROR "size said:\n${table}")
  endif()
  math(EXPR flash "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")  # what has a value at the start lies in flash, too
  message("${carrier}: ${flash} bytes of flash, ${CMAKE_MATCH_3} of RAM")
  if(flash GREATER limit)
    message(SEND_ERROR "${carrier}: ${flash} bytes of flash, at most ${limit} were promised")
  endif()
endforeach()

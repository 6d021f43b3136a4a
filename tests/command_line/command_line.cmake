# PROGRAM: ganglion; SOURCE: the project; WORK: a folder to write to.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# call(EXPECTED_EXIT_CODE ARGUMENTS...): leaves standard output in `out`, standard error in `err`.
function(call expected)
  execute_process(COMMAND ${PROGRAM} ${ARGN} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE code OUTPUT_VARIABLE out
                  ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "ganglion ${ARGN}: exit code ${code}, expected ${expected}\n${out}${err}")
  endif()
  set(out "${out}" PARENT_SCOPE)
  set(err "${err}" PARENT_SCOPE)
endfunction()

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected \"${pattern}\" in:\n${text}")
  endif()
endfunction()

call(0 run experiments/nimrod --seed 1 --set run.duration_s=3 --json --no-record)
file(READ ${SOURCE}/tests/command_line/run.json pinned)
if(NOT out STREQUAL pinned)
  message(FATAL_ERROR "run --json differs from tests/command_line/run.json:\n${out}")
endif()

# Both sonars dead: it stands still on purpose, on open ground too. That is no success.
call(1 run experiments/nimrod --seed 1 --set run.duration_s=20 --json --no-record
     --set application.robot.sensor.sonar_left.fault=dead --set application.robot.sensor.sonar_right.fault=dead)
expect("${out}" "not met: progress_m >= 0.1 \\(0")

# One run has values, several have quartiles.
call(1 run experiments/nimrod --seed 1 --set run.duration_s=1 --no-record --no-report)
expect("${out}" "\nmeasure +value\nduration_s +1\n")
call(0 run experiments/nimrod --seeds 1..2 --set run.duration_s=1 --no-record)
expect("${out}" "\nmeasure +lower +median +upper\nduration_s +1 +1 +1\n")

call(0 run experiments/nimrod --seeds 1..4 --threads 1 --set run.duration_s=20 --json --no-record)
set(alone "${out}")
call(0 run experiments/nimrod --seeds 1..4 --threads 2 --set run.duration_s=20 --json --no-record)
if(NOT out STREQUAL alone)
  message(FATAL_ERROR "two threads give other results than one")
endif()

call(0 run experiments/nimrod --seed 3 --set run.duration_s=20 --json --no-record)  # a process of its own
string(JSON fresh GET "${out}" runs 0 digest)
string(JSON third GET "${alone}" runs 2 digest)
if(NOT fresh STREQUAL third)
  message(FATAL_ERROR "after two other runs in one process the third gives ${third}, in a fresh one ${fresh}")
endif()

call(0 run experiments/pathfinder --seed 1 --experience ${WORK}/map.sqlite --out ${WORK}/runs)
call(0 replay ${WORK}/runs/seed_0001.mcap)
expect("${out}" "^same: digest ")
call(0 run experiments/pathfinder --seed 2 --experience ${WORK}/map.sqlite --out ${WORK}/runs)
call(0 replay ${WORK}/runs/seed_0002.mcap)  # started with experience: learning included
expect("${out}" "^same: digest ")
call(0 runs digests ${WORK}/runs/seed_0001.mcap ${WORK}/runs/seed_0001.mcap)
expect("${out}" "same +robot0/router\n.* the same, 0 different, 0 in one run only")
call(1 runs digests ${WORK}/runs/seed_0001.mcap ${WORK}/runs/seed_0002.mcap)
expect("${out}" "differs +robot0/router")
call(0 runs recover ${WORK}/runs/seed_0001.mcap --out ${WORK}/saved.mcap)
expect("${out}" "saved [0-9]+ chunks, [0-9]+ messages, [0-9.]+ s of the run, its outcome\nwrote ")
call(0 runs verify ${WORK}/saved.mcap)
call(2 runs recover ${WORK}/saved.mcap --out ${WORK}/saved.mcap)
expect("${err}" "is the file to recover")
call(4 runs recover ${WORK}/saved.mcap --out /dev/full)
expect("${err}" "No space left")
call(0 experience show ${WORK}/map.sqlite)
expect("${out}" "router +DynamicMapRouter")
call(0 experience forget ${WORK}/map.sqlite router)
call(0 runs verify ${WORK}/runs/seed_0001.mcap ${WORK}/runs/seed_0002.mcap)
call(0 runs list ${WORK}/runs)
expect("${out}" "seed_0001.mcap")
call(0 plot ${WORK}/runs/seed_0001.mcap --out ${WORK}/pictures)
expect("${out}" "trajectory.svg")

file(WRITE ${WORK}/alone.json "${alone}")
call(0 runs compare pairs=${WORK}/alone.json ${WORK}/runs --out ${WORK}/compared.html)
expect("${out}" "pairs +4 +[0-4] .*runs +2 +[0-2] ")
file(READ ${WORK}/compared.html page)
expect("${page}" "progress_ratio")  # a measure of the one
expect("${page}" "travel_ratio")  # and of the other
file(WRITE ${WORK}/odd.json "{\"runs\": [{\"success\": true, \"measures\": {\"way_m\": \"far\"}}]}")
call(2 runs compare ${WORK}/odd.json --out ${WORK}/odd.html)
expect("${err}" "odd.json: runs.0..measures.way_m is no number")

foreach(type controller experiment robot world)
  call(0 schema ${type})
  string(JSON title GET "${out}" title)
  expect("${title}" "^Ganglion ${type}$")
  set(printed "${out}")
  call(0 schema ${type} --out ${WORK}/${type}.json)
  file(READ ${WORK}/${type}.json written)
  if(NOT written STREQUAL printed)
    message(FATAL_ERROR "schema ${type} --out writes something else than it prints")
  endif()
endforeach()
file(WRITE ${WORK}/in_the_way "")
call(4 schema robot --out ${WORK}/in_the_way/robot.json)

call(2 run experiments/nimrod --set controller.acting.escpe.trigger_range_m=1)
expect("${err}" "did you mean \"escape\"")
call(0 run experiments/nimrod --faults matrix --seeds 1..2 --set run.duration_s=1)
expect("${out}" "healthy +2 .*sonar_left dead +2 ")
call(2 run experiments/nimrod --set run.duration_s=-1)
expect("${err}" "duration_s is -1, must be in")
call(2 check ${WORK}/nothing.toml)
expect("${err}" "there is no such file")
call(2 kinds Escpe)
expect("${err}" "did you mean \"Escape\"")
call(2 schema robt)

# Robots elsewhere: the program is started and ended with the run, which has the digest of a run in process.
set(started "application.program=[\"${PROGRAM}\", \"sim\", \".\", \"--listen\", \"127.0.0.1:{port}\"]")
call(0 run experiments/nimrod --seed 3 --set run.duration_s=20 --set ${started} --json --no-report --out ${WORK}/linked)
string(JSON linked GET "${out}" runs 0 digest)
if(NOT linked STREQUAL fresh)
  message(FATAL_ERROR "over the link seed 3 gives ${linked}, in process ${fresh}")
endif()
file(READ ${WORK}/linked/seed_0003.program.log output)
expect("${output}" "Nimrod .1 robot. listens at tcp://127.0.0.1:")
call(0 replay ${WORK}/linked/seed_0003.mcap)
call(3 run experiments/nimrod --set "application.program=[\"false\"]" --no-record)
expect("${err}" "false ended and last said: nothing")
call(3 run experiments/nimrod --robot tcp://127.0.0.1:1 --no-record)
expect("${err}" "nothing answers at tcp://127.0.0.1:1: .*ganglion sim")
call(3 doctor --robot tcp://127.0.0.1:1)
call(2 run experiments/nimrod --robot nowhere)
expect("${err}" "is no address: write tcp://HOST:PORT")
call(2 frobnicate)

execute_process(COMMAND ${PROGRAM} studio --help RESULT_VARIABLE no_studio OUTPUT_QUIET ERROR_QUIET)
if(NOT no_studio)  # built with it
  call(2 studio experiments --listen 0.0.0.0:0 --no-browser)
  expect("${err}" "can be reached by other machines: say by which name with --allow-host")
  file(WRITE ${WORK}/open_studio.sh "
    cd '${WORK}'
    '${PROGRAM}' studio . --listen 0.0.0.0:0 --allow-host robot.local --no-browser >studio.out 2>studio.err &
    until grep -q Warning studio.err || ! kill -0 $! 2>/dev/null; do sleep 0.05; done
    kill -INT $!
    wait $!")
  execute_process(COMMAND sh ${WORK}/open_studio.sh TIMEOUT 60)
  file(READ ${WORK}/studio.out url)
  expect("${url}" "^http://[^ ]*:[0-9]+/.token=")
  file(READ ${WORK}/studio.err warning)
  expect("${warning}" "Warning: other machines can reach this server")
endif()
call(0 doctor)

file(WRITE ${WORK}/in.csv "time_s,sonar_left,sonar_right,heading\n0,1,1,0\n1.6,0.3,0.5,0\n3.2,nan,inf,0\n")
call(0 replay experiments/nimrod/controller.listing.toml --inputs ${WORK}/in.csv --out ${WORK}/out.csv)
file(READ ${WORK}/out.csv table)
# u = 3 * 20 cm / 1200 = 0.05 turns right; the dead sonar reads 0 and escapes, back at 200 / 1200.
expect("${table}" "time_s,drive.left,drive.right,arbiter.active\n.*1.6,0.05,-0.05,avoid\n3.2,-0.16666666666666666,-0.16666666666666666,escape\n$")

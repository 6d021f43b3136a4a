# cmake -DOUTPUT=x.cpp -DNAME=kName -DINPUTS=a;b -P embed.cmake: the files, one after the other, as a C++ string.
# Written in pieces, since compilers limit the length of one literal.
set(text "")
foreach(input IN LISTS INPUTS)
  file(READ "${input}" content HEX)
  string(APPEND text "${content}")
endforeach()
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" text "${text}")
string(LENGTH "${text}" length)
set(literals "")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 piece)
  string(APPEND literals "    \"${piece}\"\n")
  math(EXPR at "${at} + 8000")
endwhile()
file(WRITE "${OUTPUT}"
  "#include \"ganglion/report/embedded.h\"\n\nnamespace ganglion::report {\n\nextern const std::string_view ${NAME} =\n${literals};\n\n}  // namespace ganglion::report\n")

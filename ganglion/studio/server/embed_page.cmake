# cmake -DDIST=folder -DWORK=folder -DOUTPUT=x.cpp -P embed_page.cmake: every file below DIST, packed, becomes part of the
# program by .incbin: compilers take minutes for literals of this size, the assembler milliseconds.
file(REMOVE_RECURSE "${WORK}")
file(GLOB_RECURSE files RELATIVE "${DIST}" "${DIST}/*")
list(SORT files)
set(blobs "")
set(declared "")
set(rows "")
set(number 0)
foreach(name IN LISTS files)
  get_filename_component(folder "${WORK}/${name}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  file(COPY_FILE "${DIST}/${name}" "${WORK}/${name}")
  execute_process(COMMAND gzip -9 -n -f "${WORK}/${name}" COMMAND_ERROR_IS_FATAL ANY)
  set(symbol "ganglion_page_${number}")
  string(APPEND blobs
    "    \".global ${symbol}, ${symbol}_end\\n${symbol}:\\n.incbin \\\"${WORK}/${name}.gz\\\"\\n${symbol}_end:\\n\"\n")
  string(APPEND declared "extern const char ${symbol}[], ${symbol}_end[];\n")
  string(APPEND rows "      {\"/${name}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
  math(EXPR number "${number} + 1")
endforeach()
if(number EQUAL 0)
  message(FATAL_ERROR "there is nothing in ${DIST}: the page was not built")
endif()
file(WRITE "${OUTPUT}" "#include \"ganglion/studio/server/assets.h\"

asm(\".section .rodata\\n\"
${blobs}    \".text\\n\");
extern \"C\" {
${declared}}

namespace ganglion::studio {

std::span<const EmbeddedAsset> embedded_assets() noexcept {
  static const EmbeddedAsset kAssets[] = {
${rows}  };
  return kAssets;
}

}  // namespace ganglion::studio
")

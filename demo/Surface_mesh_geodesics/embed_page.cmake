# Writes a C++ source with the bytes of the files that a page is made of.
# Needs -Doutput, -Dtemplate, -Dscript, -Dthree and -Dlicense; the license is cut out of Debian's copyright file. Where
# three.js is not there, the last two are empty, and the program gets no bytes of them.
cmake_minimum_required(VERSION 3.19...3.31)

function(append_array name hexadecimal)
  string(REPEAT "." 64 digits_of_line)
  string(REGEX REPLACE "(${digits_of_line})" "\\1\n" lines "${hexadecimal}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${lines}")
  file(APPEND "${output}.new" "extern const unsigned char ${name}[] = {\n${bytes}0};\n") # no array is empty
  file(APPEND "${output}.new" "extern const std::size_t ${name}_size = sizeof(${name}) - 1;\n\n")
endfunction()

function(append_file name file)
  set(hexadecimal)
  if(file)
    file(READ "${file}" hexadecimal HEX)
  endif()
  append_array(${name} "${hexadecimal}")
endfunction()

# The copyright of all files but those named, and the text of the license Expat, in the machine-readable format.
function(extract_license result)
  file(READ "${license}" text)
  string(REGEX MATCH "Files: \\*\nCopyright: ([^\n]*)\nLicense: Expat" found "${text}")
  set(owner "${CMAKE_MATCH_1}")
  string(REGEX MATCH "\nLicense: Expat\n( [^\n]*(\n [^\n]*)*)" found "${text}")
  set(conditions "${CMAKE_MATCH_1}")
  if(owner STREQUAL "" OR conditions STREQUAL "")
    message(FATAL_ERROR "The license of three.js was not found in ${license}")
  endif()
  string(REGEX REPLACE "\n \\.\n" "\n\n" conditions "${conditions}")
  string(REGEX REPLACE "(^|\n) " "\\1" conditions "${conditions}")
  file(WRITE "${result}" "Copyright ${owner}\n\n${conditions}\n")
endfunction()

set(extracted_license)
if(license)
  set(extracted_license "${output}.license")
  extract_license("${extracted_license}")
endif()
file(WRITE "${output}.new" "// Made by embed_page.cmake.\n\n#include <cstddef>\n\nnamespace geodesics_demo {\n\n")
append_file(page_template "${template}")
append_file(page_script "${script}")
append_file(page_three "${three}")
append_file(page_license "${extracted_license}")
file(APPEND "${output}.new" "} // namespace geodesics_demo\n")
file(RENAME "${output}.new" "${output}")

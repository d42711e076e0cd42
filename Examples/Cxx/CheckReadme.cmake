# The program in the README is the one that is compiled and run here.
#   cmake -DREADME=... -DPROGRAM=... -P CheckReadme.cmake
file(READ "${README}" readme)
file(READ "${PROGRAM}" program)
string(FIND "${readme}" "```cpp\n${program}```" place)
if (place EQUAL -1)
  message(FATAL_ERROR "The program in ${README} is not ${PROGRAM}: copy it again.")
endif ()

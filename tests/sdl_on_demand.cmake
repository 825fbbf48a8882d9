# cmake -D PROGRAM=... -D READELF=... -P sdl_on_demand.cmake
# Fails where a program needs SDL2 in order to start, or a function of SDL that nobody passes on
# (viewer/sdl_on_demand.cpp).
execute_process(COMMAND ${READELF} --wide --dynamic --dyn-syms ${PROGRAM}
  OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "\\(NEEDED\\)[^\n]*libc\\.so")
  message(FATAL_ERROR "${PROGRAM} needs not even libc: not understood:\n${said}")
endif()
string(REGEX MATCHALL "[^\n]*(\\(NEEDED\\)[^\n]*libSDL|UND SDL_)[^\n]*" found "${said}")
if(found)
  list(JOIN found "\n" found)
  message(FATAL_ERROR "${PROGRAM} starts with SDL2:\n${found}")
endif()

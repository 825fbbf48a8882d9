# The Debian packages, by CPack: `sir` with what runs and `sir-dev` with what other programs are
# built with. Build the target `package`, or run cpack in the build's folder.
set(SIR_MAINTAINER "SIR maintainers <maintainers@sir.invalid>" CACHE STRING
  "Who answers for the Debian packages: NAME <MAIL>")

# Both packages have the licence and the packages' own history where Debian has them.
execute_process(COMMAND date -u -R -d ${SIR_DATE} OUTPUT_VARIABLE sir_date_long
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
configure_file(changelog.in changelog.Debian @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog COPYONLY)
execute_process(COMMAND gzip -9nfk changelog.Debian changelog
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
foreach(part program dev)
  set(name sir)
  if(part STREQUAL dev)
    set(name sir-dev)
    install(FILES copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
      COMPONENT debian_dev EXCLUDE_FROM_ALL)
  endif()
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz
    ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
    COMPONENT debian_${part} EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sir)
set(CPACK_PACKAGE_CONTACT ${SIR_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # else the project's stands before each package's own
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program debian_program dev debian_dev)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sir)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
if(SIR_WITH_SDL)  # loaded where a window is opened: shlibdeps cannot see it
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libsdl2-2.0-0)
endif()
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gnuplot-nox, bash-completion")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "CSG ray tracer, 256-colour tables and an emulated Eltek MA120
The image-synthesis laboratory of a master's thesis of 1989, rebuilt: a modeler
of CSG solids, a ray tracer after Roth and Whitted, the choice of 256 colours
for an image, and the display that showed it, 1024x780 pixels in 8 planes with
6 bits a primary, in a window, as PNG or in a terminal.

Five scenes are in /usr/share/sir/images.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME sir-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libglm-dev, libfmt-dev, libgmp-dev, liblcms2-dev, libutf8proc-dev, pkg-config")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "sir, cmake")
set(CPACK_DEBIAN_DEV_DESCRIPTION "libraries of SIR: ray tracer, colour tables, Eltek MA120
Static libraries and headers to read, trace and probe CSG scenes, to choose 256
colours for an image, to show it on an emulated Eltek MA120, and to run the
commands of SIR's modeler. CMake finds them by find_package(sir).")
include(CPack)
cpack_add_component_group(program)
cpack_add_component_group(dev)
cpack_add_component(program GROUP program)
cpack_add_component(debian_program GROUP program)
cpack_add_component(dev GROUP dev)
cpack_add_component(debian_dev GROUP dev)

# Debian's LIGGGHTS library, as installed: target Liggghts::Liggghts, LIGGGHTS_VERSION.
# Refuses any version but the one whose private members liggghts_access.cpp know.
find_path(LIGGGHTS_INCLUDE_DIR fix_mesh_surface.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
find_program(LIGGGHTS_EXECUTABLE liggghts)

set(LIGGGHTS_VERSION "")
if(LIGGGHTS_LIBRARY)
  file(STRINGS ${LIGGGHTS_LIBRARY} banner REGEX "LIGGGHTS-PUBLIC [0-9]+\\.[0-9]+\\.[0-9]+, compiled")
  string(REGEX MATCH "LIGGGHTS-PUBLIC ([0-9]+\\.[0-9]+\\.[0-9]+), compiled" banner "${banner}")
  set(LIGGGHTS_VERSION ${CMAKE_MATCH_1})
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Liggghts
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR LIGGGHTS_EXECUTABLE VERSION_VAR LIGGGHTS_VERSION)
if(NOT LIGGGHTS_VERSION VERSION_EQUAL Liggghts_FIND_VERSION)
  message(FATAL_ERROR "LIGGGHTS ${LIGGGHTS_VERSION} at ${LIGGGHTS_LIBRARY}: footfall reaches into private members of version "
    "${Liggghts_FIND_VERSION} only. Install Debian's libliggghts-dev of that version, or check liggghts_access.cpp against yours.")
endif()

# The package lacks the lists of contact models that LIGGGHTS' own build makes: one #include per model.
set(LIGGGHTS_GENERATED_DIR ${CMAKE_CURRENT_BINARY_DIR}/generated)
foreach(kind surface normal tangential cohesion rolling)
  string(TOUPPER ${kind} upper)
  file(GLOB models ${LIGGGHTS_INCLUDE_DIR}/${kind}_model_*.h)
  set(lines "")
  foreach(model ${models})
    file(STRINGS ${model} registration REGEX "^${upper}_MODEL\\(")
    if(registration)
      get_filename_component(file_name ${model} NAME)
      string(APPEND lines "#include \"${file_name}\"\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${LIGGGHTS_GENERATED_DIR}/style_${kind}_model.h CONTENT "${lines}")
endforeach()

add_library(Liggghts::Liggghts INTERFACE IMPORTED)
set_target_properties(Liggghts::Liggghts PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_GENERATED_DIR};${LIGGGHTS_INCLUDE_DIR}"
  INTERFACE_COMPILE_OPTIONS "SHELL:-include cstring"  # my_page.h calls memset without it
  INTERFACE_LINK_LIBRARIES "${LIGGGHTS_LIBRARY};MPI::MPI_CXX")

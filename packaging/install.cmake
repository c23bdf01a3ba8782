# What `cmake --install` puts where. Optional parts say it in their own CMakeLists.txt. Components:
#   runtime      programs, inputs, man pages, completion, docs               package footfall
#   campaign     calibrate, ground, sweeps with drawn runs                  package footfall-campaign
#   import       robots of other programs                                   package footfall-import
#   python       the Python package                                         package python3-footfall
#   development  headers and libraries: find_package(footfall)               package footfall-dev
include(CMakePackageConfigHelpers)
file(APPEND ${CMAKE_BINARY_DIR}/parts "install\n")

install(TARGETS footfall footfall_studies mbd_solver liggghts_mbd RUNTIME COMPONENT runtime)

# Programs find these from their own place: ../share/footfall (mbd_solver/scene/shipped_files.h).
set(share share/footfall)
install(DIRECTORY inputs examples DESTINATION ${share} COMPONENT runtime)
install(FILES README.md CHANGELOG.md LICENSE packaging/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT runtime
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.txt" PATTERN site EXCLUDE)

# Man pages from --help by help2man, where it is installed; a completion for bash that asks `footfall --help`.
find_program(HELP2MAN help2man)
find_program(GZIP gzip)
set(man ${CMAKE_BINARY_DIR}/man)
set(man_page_files)
if(HELP2MAN AND GZIP)
  # Those of footfall and footfall_studies, whose programs are there: COMMAND(NAME, ...).
  file(STRINGS ${CMAKE_SOURCE_DIR}/mbd_solver/app/commands.def commands REGEX "^COMMAND\\([a-z]+, (landing|studies|campaign),")
  list(TRANSFORM commands REPLACE "^COMMAND\\(([a-z]+),.*" "\\1")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/mbd_solver/app/commands.def)
  foreach(command "" ${commands})
    set(page ${man}/footfall.1.gz)
    set(name "flexible multibody mechanisms against beds of grains")
    if(command)
      set(page ${man}/footfall-${command}.1.gz)
      set(name "the command ${command} of footfall")
    endif()
    add_custom_command(OUTPUT ${page}
      COMMAND sh -c "mkdir -p \"$5\" && \"$1\" --no-info --no-discard-stderr --version-string=${PROJECT_VERSION} --name=\"$2\" \"$3 $4\" | gzip -9n >\"$6\""
        sh ${HELP2MAN} ${name} $<TARGET_FILE:footfall> "${command}" ${man} ${page}
      DEPENDS footfall footfall_studies $<$<TARGET_EXISTS:footfall_campaign>:footfall_campaign> COMMENT "Man page footfall ${command}" VERBATIM)
    list(APPEND man_page_files ${page})
  endforeach()
endif()
add_custom_target(man_pages ALL DEPENDS ${man_page_files})
install(FILES ${man_page_files} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime)
install(FILES packaging/footfall.bash DESTINATION share/bash-completion/completions RENAME footfall COMPONENT runtime)

# Headers by their full paths, as the sources name them.
install(DIRECTORY coupler DESTINATION include/footfall COMPONENT development FILES_MATCHING PATTERN "*.h")
install(DIRECTORY mbd_solver DESTINATION include/footfall COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN app EXCLUDE PATTERN bed EXCLUDE PATTERN studies EXCLUDE PATTERN campaign EXCLUDE PATTERN import EXCLUDE PATTERN fmi EXCLUDE)

# footfall::coupler       the conversation with LIGGGHTS, over MPI
# footfall::mbd_solver    scene, model, integrators, runs
# find_package(footfall COMPONENTS coupler) needs Eigen and MPI alone.
set_target_properties(footfall_options PROPERTIES EXPORT_NAME options)
set_target_properties(coupler PROPERTIES EXPORT_NAME coupler_without_mpi)
set_target_properties(coupler_mpi PROPERTIES EXPORT_NAME coupler)
install(TARGETS footfall_options coupler_base coupler coupler_mpi EXPORT footfallCoupler
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/footfall COMPONENT development)
add_library(mbd_solver_library INTERFACE)
target_link_libraries(mbd_solver_library INTERFACE mbd_session coupler_mpi)
set_target_properties(mbd_solver_library PROPERTIES EXPORT_NAME mbd_solver)
install(TARGETS mbd_base mbd_model mbd_fe mbd_dynamics mbd_integrator mbd_scene mbd_assemble mbd_coupling
  mbd_output mbd_observe mbd_session mbd_solver_library EXPORT footfallMbdSolver
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/footfall COMPONENT development)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/footfall)
foreach(part Coupler MbdSolver)
  install(EXPORT footfall${part} NAMESPACE footfall:: FILE footfall${part}.cmake DESTINATION ${config} COMPONENT development)
endforeach()
configure_package_config_file(${CMAKE_SOURCE_DIR}/packaging/footfallConfig.cmake.in ${CMAKE_BINARY_DIR}/footfallConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/footfallConfigVersion.cmake COMPATIBILITY ExactVersion)
install(FILES ${CMAKE_BINARY_DIR}/footfallConfig.cmake ${CMAKE_BINARY_DIR}/footfallConfigVersion.cmake
  DESTINATION ${config} COMPONENT development)

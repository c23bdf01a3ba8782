# Debian packages: `./footfall package`, or cpack -G DEB in a build folder in which everything has been built.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME footfall)
set(CPACK_PACKAGE_VENDOR footfall)
set(CPACK_PACKAGE_CONTACT "footfall developers <footfall@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime development)
# footfall_package(COMPONENT TARGET NAME DEPENDS DESCRIPTION): a package of its own for an optional part, where it can be built.
function(footfall_package component target name depends description)
  if(TARGET ${target})
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "footfall (= ${PROJECT_VERSION})${depends}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}" PARENT_SCOPE)
  endif()
endfunction()
footfall_package(campaign footfall_campaign footfall-campaign "" "calibrations and sweeps with drawn runs of footfall
Parameters with which runs meet targets, soils fitted to runs on grains, and probabilities of outcomes with intervals, envelopes and sensitivities from
runs whose quantities are drawn from distributions.")
footfall_package(import footfall_import footfall-import "" "scenes of footfall from robots of other programs
Makes a scene of a robot in URDF, MJCF or, where sdformat is, SDF.")
find_package(Python3 QUIET COMPONENTS Interpreter)
math(EXPR python_next "${Python3_VERSION_MINOR} + 1")
footfall_package(python footfall_python python3-footfall
  ", python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${python_next}), python3-numpy" "footfall from Python
Scenes, runs, sweeps and their results as Python objects and numpy arrays,
and mechanisms that Python leads step by step.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-xarray, ipython3")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Libraries by dpkg-shlibdeps. LIGGGHTS of this version alone: the launcher reaches into its private members.
get_directory_property(liggghts DIRECTORY liggghts_fix DEFINITION LIGGGHTS_VERSION)
string(REGEX REPLACE "[0-9]+$" "" liggghts_series "${liggghts}")
string(REGEX MATCH "[0-9]+$" liggghts_patch "${liggghts}")
math(EXPR liggghts_next "${liggghts_patch} + 1")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME footfall)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS
  "libliggghts3 (>= ${liggghts}), libliggghts3 (<< ${liggghts_series}${liggghts_next}~), openmpi-bin, gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "liggghts")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "footfall-campaign, footfall-dev, footfall-import, python3-footfall, paraview")
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "flexible multibody mechanisms against beds of grains
footfall computes what happens when a mechanism touches a bed of grains:
LIGGGHTS moves the grains, a multibody solver moves the mechanism with its
flexible bodies, dampers and controllers. Its first use is a four-legged
lunar lander with magnetorheological dampers.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME footfall-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "footfall (= ${PROJECT_VERSION}), g++, cmake, make | ninja-build, libopenmpi-dev, libeigen3-dev, libsundials-dev, libsuitesparse-dev, libtomlplusplus-dev, libfuzzylite-dev, libmuparser-dev, nlohmann-json3-dev, libpugixml-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "headers and libraries of footfall
With these a program of your own couples its mechanism to LIGGGHTS, or uses
the multibody solver: find_package(footfall), footfall::coupler and
footfall::mbd_solver.")
include(CPack)

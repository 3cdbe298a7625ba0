# System packages only, nothing is downloaded. Heavy headers come in through interface targets that few source files link.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(embree 3 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)

# Debian installs OpenVDB's find module outside of CMake's search path.
list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
find_package(OpenVDB REQUIRED)
add_library(mrsim_openvdb INTERFACE)
target_link_libraries(mrsim_openvdb INTERFACE OpenVDB::openvdb)
# Hidden copies of its template statics mix with those of the library: openvdb::initialize() then
# reads a name that the other copy has set, and crashes.
target_compile_options(mrsim_openvdb INTERFACE -fvisibility=default)

find_package(OpenMesh REQUIRED CONFIG)
add_library(mrsim_openmesh INTERFACE)
target_link_libraries(mrsim_openmesh INTERFACE OpenMeshCore OpenMeshTools)

find_package(CGAL REQUIRED)
add_library(mrsim_cgal INTERFACE)
target_link_libraries(mrsim_cgal INTERFACE CGAL::CGAL Eigen3::Eigen)

# STEP input. Open CASCADE is large, so a build may go without; only the module that reads STEP files is linked against it.
add_library(mrsim_step INTERFACE)
option(MRSIM_STEP "Read STEP files (needs Open CASCADE)" ON)
if(MRSIM_STEP)
  find_package(OpenCASCADE QUIET)
  if(OpenCASCADE_FOUND)
    target_include_directories(mrsim_step SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
    target_link_libraries(mrsim_step INTERFACE TKSTEP TKXSBase TKMesh TKTopAlgo TKBRep TKPrim TKBO
                                               TKShHealing TKG3d TKMath TKernel)
    target_compile_definitions(mrsim_step INTERFACE MRSIM_HAS_STEP)
    set(MRSIM_STEP_MODULE TRUE)
  else()
    message(STATUS "Open CASCADE was not found: STEP files will not be read")
  endif()
endif()

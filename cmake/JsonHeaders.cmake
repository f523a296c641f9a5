# Finds the headers of nlohmann-json when cross-compiling. Debian's include folder also contains
# headers for the build machine, so only this library's headers are used.
find_path(PELT_JSON_HEADERS nlohmann/json.hpp PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/json)
file(CREATE_LINK ${PELT_JSON_HEADERS}/nlohmann ${PROJECT_BINARY_DIR}/json/nlohmann SYMBOLIC)
add_library(nlohmann_json INTERFACE)
target_include_directories(nlohmann_json SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/json)
add_library(nlohmann_json::nlohmann_json ALIAS nlohmann_json)

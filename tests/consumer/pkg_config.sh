#!/bin/sh
# pkg_config.sh COMPILER PKG_CONFIG_PATH EXAMPLES FOLDER: compiles the programs of docs/getting-started.md in FOLDER
# with the flags of pkg-config, and runs the one that needs no file.
set -eu
compiler=$1 examples=$3 folder=$4
export PKG_CONFIG_PATH="$2"
mkdir -p "$folder"

build() {  # build PROGRAM PACKAGE
  # shellcheck disable=SC2046  # flags are words
  "$compiler" -std=c++20 "$examples/$1.cpp" -o "$folder/$1" $(pkg-config --cflags --libs "$2")
}

build plain_arrays pelt
build hello_pelt pelt-asset
LD_LIBRARY_PATH="$2/.." "$folder/plain_arrays"

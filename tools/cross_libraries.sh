# Makes static libraries for another system from Debian's sources. Read by tools/build_windows_libraries and
# tools/build_browser_libraries, which set: folder, root, log, system (its name), toolchain (of CMake), options.

# Debian's sources, from where this system has its packages: the same lists, asked for sources, in a folder of our own.
apt=(-o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/apt/parts"
     -o "Dir::State::lists=$folder/apt/lists" -o APT::Sandbox::User=root)
list_sources() {
  mkdir -p "$folder/apt/parts" "$folder/apt/lists/partial"
  local file
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -e "$file" ] || ! grep -q debian-archive "$file" ||
      sed 's/^Types:.*/Types: deb-src/' "$file" > "$folder/apt/parts/$(basename "$file")"
  done
  [ ! -e /etc/apt/sources.list ] || grep -E '^deb .*\bmain\b' /etc/apt/sources.list | sed 's/^deb /deb-src /' \
    > "$folder/apt/parts/main.list" || true
  apt-get "${apt[@]}" update -qq
}

# fetch_source NAME SOURCE: sets tree, the folder of the source.
fetch_source() {
  echo "building $1 for $system (log: $log)"
  [ -d "$folder/apt/lists/partial" ] || list_sources >> "$log" 2>&1
  mkdir -p "$folder/source" "$folder/build"
  (cd "$folder/source" && apt-get "${apt[@]}" source -qq "$2") >> "$log" 2>&1
  tree=$(find "$folder/source" -maxdepth 1 -type d -name "${2%%-*}-[0-9]*" | head -1)
}

# make_library STAMP SOURCE OPTION...: configured, built and installed into the folder.
make_library() {
  local name=$1 source=$2 tree
  shift 2
  [ ! -e "$folder/$name.done" ] || return 0
  fetch_source "$name" "$source"
  # From there, since programs that HDF5 tries write into the folder that CMake was called in.
  (cd "$folder/build" && cmake -S "$tree" -B "$name" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
    "${options[@]}" -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_BUILD_TYPE=Release \
    -DBUILD_SHARED_LIBS=OFF "$@") >> "$log" 2>&1
  ! declare -F "prepare_$name" > /dev/null || "prepare_$name" "$folder/build/$name" >> "$log" 2>&1
  cmake --build "$folder/build/$name" -j 2 >> "$log" 2>&1
  cmake --install "$folder/build/$name" >> "$log" 2>&1
  touch "$folder/$name.done"
}

trap '[ $? -eq 0 ] || { echo "the libraries for $system were not built; the end of $log:"; tail -5 "$log"; } >&2' EXIT
: > "$log"

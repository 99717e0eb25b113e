# For scripts that unpack packages of Debian without installing them: `source own_archive.sh`.

# open_archive FOLDER KIND RELEASE [ARCHITECTURE]: lets apt-get keep its own lists and packages in a folder, so that those
# of the system do not change. KIND is deb or deb-src. RELEASE is the name of a release, or "this".
# Afterwards, "${archive[@]}" is the command apt-get for this folder.
open_archive()
{
  local folder=$1 kind=$2 release=$3 architecture=${4:-} site
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
  folder=$(cd "$folder" && pwd)
  [ "$release" != this ] || release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
  echo "$kind [${architecture:+arch=$architecture }signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site" \
    "$release main" > "$folder/sources.list"
  archive=(apt-get -o "Dir::Etc::sourcelist=$folder/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Sandbox::User=root)
  [ -z "$architecture" ] || archive+=(-o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture")
  "${archive[@]}" --quiet update
}

# unpack_newer_cgal FOLDER RELEASE: the headers of CGAL of another release, in FOLDER/package/usr/include.
unpack_newer_cgal()
{
  open_archive "$1/apt" deb "$2"
  rm -rf "$1/package" "$1"/apt/libcgal-dev_*.deb
  (cd "$1/apt" && "${archive[@]}" download libcgal-dev)
  dpkg -x "$1"/apt/libcgal-dev_*.deb "$1/package"
}

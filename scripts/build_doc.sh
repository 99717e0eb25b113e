#!/usr/bin/env bash
# Builds the documentation with plain doxygen and fails on any warning. Usage: build_doc.sh [output folder]
# The pages need no network: formulas become plain HTML. Without python3, browsers load MathJax from the network.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
output=${1:-$root/build/doc}
mkdir -p "$output"
rm -rf "$output/html" # pages of what is gone would stay
output=$(cd "$output" && pwd)
log=$output/doxygen_warnings.log
rm -f "$log"

cd "$root"
{
  cat doc/standalone/Doxyfile
  echo "OUTPUT_DIRECTORY = \"$output\""
  echo "WARN_LOGFILE = \"$log\""
  if [ -d doc/Surface_mesh_geodesics/fig ]; then
    echo "IMAGE_PATH = doc/Surface_mesh_geodesics/fig"
  fi
} | doxygen -

if command -v python3 > /dev/null; then
  formulas=$(python3 -B scripts/formulas_to_html.py "$output/html") || echo "$formulas" >> "$log"
fi

# The brief description may say what a function returns: "returns ...".
[ ! -f "$log" ] || sed -i '/warning: return type of member .* is not documented$/d' "$log"

# A concept is documented like a class, but it is not a class and has no header.
for page in "$output"/html/class*.html; do
  if grep -q 'Concepts/.*\.h</a>&gt;</code>' "$page"; then
    sed -i -e '/#include &lt;.*Concepts\/.*\.h<\/a>&gt;<\/code>/d' -e 's/ Class Reference/ Concept Reference/' "$page"
  fi
done

# Doxygen removes an asterisk at the beginning of a line, where emphasis may begin.
if grep -nE '^[[:space:]]*\*[[:alnum:]]' doc/Surface_mesh_geodesics/*.txt >> "$log"; then
  echo "lines begin with emphasis: write <em>...</em>" >> "$log"
fi

# Every example has its page.
for example in examples/Surface_mesh_geodesics/*.cpp; do
  name=Surface_mesh_geodesics/$(basename "$example")
  if [ -f "$example" ] && ! grep -qF "\\example $name" doc/Surface_mesh_geodesics/examples.txt; then
    echo "doc/Surface_mesh_geodesics/examples.txt: no line for $name" >> "$log"
  fi
done

# Files of the code that the manual names exist.
rooms='numeric|surface|window|propagation|paths|Voronoi|certificate|interface|applications'
grep -ohE "\`($rooms)/[A-Za-z0-9_/]+\.h\`" doc/Surface_mesh_geodesics/*.txt | tr -d '`' | sort -u | while read -r file; do
  [ -f "include/CGAL/Surface_mesh_geodesics/internal/$file" ] || echo "the manual names $file, which does not exist" >> "$log"
done

# The table of platforms has a row for each platform that the script tries.
if command -v g++ > /dev/null; then
  {
    diff <(sed -nE '/^\| platform /,/^$/s/^\| ([^|]*[^ |]) +\|.*/\1/p' doc/Surface_mesh_geodesics/Platforms.txt | sed 1d) \
      <(WORK_FOLDER=$output/platforms bash scripts/check_platforms.sh --list) || true # lines that differ are warnings
  } | sed '/g++ [0-9.]*$/d; /^[0-9]/d' >> "$log"
fi

if [ -s "$log" ]; then
  cat "$log" >&2
  echo "$(wc -l < "$log") lines of warnings" >&2
  exit 1
fi
echo "The documentation is in $output/html/index.html"

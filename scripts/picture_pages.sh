#!/usr/bin/env bash
# Takes pictures of two pages that the program surface_mesh_geodesics writes for browsers, distances and a Voronoi
# diagram, after a click on the middle of the surface. Needs Chromium, and a program that was built with three.js.
# usage: picture_pages.sh PROGRAM SCAN WORK_FOLDER OUTPUT_FOLDER
set -euo pipefail
if [ $# -ne 4 ]; then
  sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
program=$(realpath "$1")
scan=$(realpath "$2")
mkdir -p "$3" "$4"
work=$(cd "$3" && pwd)
output=$(cd "$4" && pwd)
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)

# The click of a user in the first view of the surface.
click='<script>
const canvas = document.getElementById("surface"), box = canvas.getBoundingClientRect();
for (const type of ["pointerdown", "pointerup"])
  canvas.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, clientX: box.left + 0.5 * box.width,
    clientY: box.top + 0.6 * box.height }));
</script>'

# picture PICTURE PAGE
picture()
{
  # the last two lines of a page are </body> and </html>
  { head -n -2 "$work/$2"; printf '%s\n</body>\n</html>\n' "$click"; } > "$work/clicked_$2"
  # No sandbox: root has none, and the page is ours. No network: every name is unknown.
  timeout 300 "$browser" --headless=new --no-sandbox --user-data-dir="$work/chromium" --use-angle=swiftshader \
    --enable-unsafe-swiftshader --hide-scrollbars --window-size=1280,800 --virtual-time-budget=20000 \
    --host-resolver-rules='MAP * ~NOTFOUND' --screenshot="$output/$1" "file://$work/clicked_$2" 2> "$work/chromium.log"
}

cd "$work"
"$program" distances "$scan" --source-point 0,0,-1 --snap --html distances.html --quiet
"$program" voronoi "$scan" --site-random 12 --seed 7 --html voronoi.html --quiet
picture page_distances.png distances.html
picture page_Voronoi.png voronoi.html

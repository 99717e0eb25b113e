#!/usr/bin/env bash
# Opens pages for browsers in headless Chromium: they draw, and answer clicks.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

needs_pages
browser=
for name in chromium chromium-browser google-chrome; do
  if [ -z "$browser" ] && command -v $name > /dev/null; then
    browser=$name
  fi
done
if [ -z "$browser" ]; then
  echo "SKIPPED: there is no Chromium"
  exit 77
fi

# Actions of the user, and their effects. drag(): by some pixels; no answer. click(): at a point given as fractions of
# the width and the height of the picture; the answer is added to an attribute. Then the number of colors of the
# picture is added, which can be read only just after drawing. nearest(): the smallest distance that clicks in the
# middle answer. shade(): adds how colorful the picture is at a point, the difference of the largest and the smallest one
# of red, green and blue.
user='function drag(x, y) {
  const canvas = document.getElementById("surface"), event = { pointerId: 1, button: 0, clientX: 100, clientY: 100 };
  canvas.dispatchEvent(new PointerEvent("pointerdown", event));
  Object.assign(event, { clientX: 100 + x, clientY: 100 + y });
  canvas.dispatchEvent(new PointerEvent("pointermove", event));
  canvas.dispatchEvent(new PointerEvent("pointerup", event));
}
function press(x, y) {
  const canvas = document.getElementById("surface"), box = canvas.getBoundingClientRect();
  const event = { pointerId: 1, button: 0, clientX: box.left + x * box.width, clientY: box.top + y * box.height };
  canvas.dispatchEvent(new PointerEvent("pointerdown", event));
  canvas.dispatchEvent(new PointerEvent("pointerup", event));
  return document.getElementById("answer").innerText.replace(/\n(face|A second|looking)[^\n]*/g, "");
}
function choose_site(i) {
  const input = document.getElementById("site");
  input.value = i;
  input.dispatchEvent(new Event("input"));
}
function nearest() {
  let distance = Infinity;
  for (let x = 0.2; x < 0.81; x += 0.05)
    for (let y = 0.2; y < 0.81; y += 0.05) {
      const found = press(x, y).match(/distance ([0-9.e-]+)/);
      if (found) distance = Math.min(distance, Number(found[1]));
    }
  document.body.dataset.nearest = distance;
}
function pixels() {
  const canvas = document.getElementById("surface"), copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height;
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, copy.width, copy.height);
}
function shade(x, y) {
  press(x, y);
  const picture = pixels(), i = Math.floor(y * picture.height) * picture.width + Math.floor(x * picture.width);
  const rgb = [...picture.data.slice(4 * i, 4 * i + 3)];
  document.body.dataset.shades = (document.body.dataset.shades || "") + " " + (Math.max(...rgb) - Math.min(...rgb));
}
function click(x, y) {
  const answer = press(x, y);
  document.body.dataset.colors = new Set(new Uint32Array(pixels().data.buffer)).size;
  document.body.dataset.answers = (document.body.dataset.answers || "") + "|"
    + answer.replace(/\n/g, ", ");
}'

# opened <page> <script> [<size>]: the page after the script has run in it, in a window of this size
opened() {
  {
    head -n -2 "$1" # without the last two lines, </body> and </html>
    printf '<script>%s\n%s</script>\n</body>\n</html>\n' "$user" "$2"
  } > opened.html
  # No sandbox: root has none, and the pages are our own. No network: every name is unknown.
  timeout 100 "$browser" --headless=new --no-sandbox --user-data-dir="$work/profile" --use-angle=swiftshader \
    --enable-unsafe-swiftshader --hide-scrollbars --window-size="${3:-800,800}" --virtual-time-budget=10000 \
    --host-resolver-rules='MAP * ~NOTFOUND' --dump-dom "file://$work/opened.html" 2> browser.log
}

number_of_colors() {
  sed -n 's/.*data-colors="\([0-9]*\)".*/\1/p' "$1"
}

# The middle of the square is half a diagonal away from its corner.
is_silent distances "$grid" --source 0 --html distances.html
opened distances.html \
  "click(0.01, 0.01); click(0.5, 0.5); drag(100, 0); click(0.5, 0.5); click(0.6, 0.5);" > distances.dom
contains distances.dom 'data-state="ready"'
contains distances.dom '"|There is no surface here.|distance 0.70711, at (0.5, 0.5, 0)|'
# turned around its middle by 0.8, the square is narrower: a click next to the middle is farther to the right on it
answers=$(sed -n 's/.*data-answers="\([^"]*\)".*/\1/p' distances.dom)
equals "$(echo "$answers" | cut -d '|' -f 4)" "distance 0.70711, at (0.5, 0.5, 0)"
echo "$answers" | cut -d '|' -f 5 | awk -F '[(,]' '{ exit !($3 > 0.6 && $3 < 0.75 && $4 == 0.5) }'
contains distances.dom '>grid4.off: 16 vertices, 18 faces</p>'
contains distances.dom '>largest 1.414</small>'
contains distances.dom '</span><small>0</small>' # the lowest value of the legend
contains distances.dom "surface_mesh_geodesics distances $grid --source 0 --html distances.html</pre>"
contains distances.dom '>lines of equal distance</div>'
contains distances.dom '>sources</div>'
[ "$(number_of_colors distances.dom)" -gt 20 ] # one for each band and more

# The legend has no curves and no walls where there are none. Its lines are switches: without isolines, a picture has
# fewer colors, since their edges are blurred.
for absent in curves walls; do
  if grep --quiet ">$absent" distances.dom; then
    fail "the legend has a key for $absent"
  fi
done
is_silent distances "$grid" --source-border --html border.html
opened border.html "" > border.dom
contains border.dom '>curves</div>'
opened distances.html 'document.querySelector(".key[role=switch]").click(); click(0.5, 0.5);' > hidden.dom
contains hidden.dom 'aria-checked="false"'
contains hidden.dom 'aria-checked="true"'
[ "$(number_of_colors hidden.dom)" -lt "$(number_of_colors distances.dom)" ]

# The page leaves the key Escape to the help that is open: the browser closes it.
opened distances.html 'const press_escape = () => {
    const event = new KeyboardEvent("keydown", { key: "Escape", cancelable: true });
    document.dispatchEvent(event);
    return event.defaultPrevented;
  };
  document.body.dataset.before = press_escape();
  document.getElementById("show-help").click();
  document.body.dataset.inHelp = press_escape();' > escape.dom
contains escape.dom 'data-before="true"'
contains escape.dom 'data-in-help="false"'

# A double click shows the first view; its clicks are not the ends of a path.
opened distances.html 'window.addEventListener("error", (event) => { document.body.dataset.error = event.message; });
  press(0.5, 0.5); press(0.5, 0.5);
  document.getElementById("surface").dispatchEvent(new MouseEvent("dblclick"));
  document.body.dataset.after = document.getElementById("answer").innerText;' > double.dom
contains double.dom 'data-after="Click on the surface'
equals "$(grep -c -e 'data-error=' double.dom)" 0
if grep --quiet 'data-path=' double.dom; then
  fail "a double click has found a path"
fi

# A low window shows the whole legend: the label of 0 is in it, and the labels that are shown do not overlap.
is_silent distances "$grid" --source 0 --isolines 30 --html bands.html
opened bands.html 'const legend = document.getElementById("legend").getBoundingClientRect();
  const labels = [...document.querySelectorAll(".ramp div small")].filter((e) => e.style.visibility !== "hidden")
    .map((e) => e.getBoundingClientRect());
  document.body.dataset.zero = labels[labels.length - 1].bottom <= legend.bottom
    && document.querySelector(".ramp div:last-child small").style.visibility !== "hidden";
  document.body.dataset.overlap = labels.some((box, i) => i > 0 && box.top < labels[i - 1].bottom - 1);' \
  1280,500 > low.dom
contains low.dom 'data-zero="true"'
contains low.dom 'data-overlap="false"'
[ "$(grep -o '<div style="height: [0-9.]*px' low.dom | wc -l)" -gt 20 ]

# The surface stays in a window that becomes narrow, unless the user has moved it.
narrow='const canvas = document.getElementById("surface");
  canvas.style.width = "300px";
  window.dispatchEvent(new Event("resize"));'
opened distances.html "$narrow click(0.005, 0.5); click(0.5, 0.5);" > narrow.dom
contains narrow.dom '"|There is no surface here.|distance 0.70711, at (0.5, 0.5, 0)'
opened distances.html \
  'document.dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));'" $narrow click(0.005, 0.5);" > moved.dom
contains moved.dom 'data-answers="|distance '

# Two components, one of them without a source.
is_silent path "$data/two_components.off" --source 0 --target all --quiet --html path.html
opened path.html "" > path.dom
contains path.dom 'data-state="ready"'
contains path.dom '>shortest paths</div>'
contains path.dom '>targets</div>'
contains path.dom '>not reached</div>'

# The legend names what is there: with curves as sources there are no dots.
is_silent distances "$grid" --source-border --html border.html
opened border.html "" > border.dom
contains border.dom '>curves</div>'
equals "$(grep -c '>sources</div>' border.dom)" 0

# Vertex 0 is below on the left, vertex 15 above on the right: a click on either side of the boundary, at points that
# are equally far.
is_silent voronoi "$grid" --site 0,15 --html voronoi.html
opened voronoi.html "click(0.45, 0.55); click(0.55, 0.45);" > voronoi.dom
contains voronoi.dom 'data-state="ready"'
first=$(sed -n 's/.*|in the cell of site 0, distance \([0-9.]*\),.*/\1/p' voronoi.dom)
second=$(sed -n 's/.*|in the cell of site 1, distance \([0-9.]*\),.*/\1/p' voronoi.dom)
awk -v d="$first" 'BEGIN { exit !(d > 0.5 && d < 0.7) }'
equals "$first" "$second"
contains voronoi.dom '>boundaries of the cells</div>'
[ "$(number_of_colors voronoi.dom)" -gt 4 ]

# The first site faces the viewer, although it is on a side of the sphere that no view along an axis shows. The number
# of another site turns that site to the viewer.
sphere=$data/../../../examples/Surface_mesh_geodesics/data/bumpy_sphere.off
is_silent voronoi "$sphere" --snap --quiet --site-point -9,-9,-9 --site-point 9,9,9 --html sites.html
opened sites.html \
  "nearest(); click(0.5, 0.5); choose_site(1); click(0.5, 0.5);" > sites.dom
distance=$(sed -n 's/.*data-nearest="\([^"]*\)".*/\1/p' sites.dom)
awk -v d="$distance" 'BEGIN { exit !(d != "" && d < 0.15) }' || fail "the first site is not before the viewer"
answers=$(sed -n 's/.*data-answers="\([^"]*\)".*/\1/p' sites.dom)
equals "$(echo "$answers" | grep -o 'in the cell of site [0-9]*' | paste -sd ,)" \
  "in the cell of site 0,in the cell of site 1"
# A source is turned to a side on which nothing hides it, such as the middle one of three squares.
printf 'OFF\n12 3 0\n' > squares.off
for z in -1 0 1; do
  printf '0 0 %d\n1 0 %d\n1 1 %d\n0 1 %d\n' $z $z $z $z >> squares.off
done
printf '4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n' >> squares.off
is_silent distances squares.off --quiet --source-point 0.5,0.5,0 --html squares.html
opened squares.html "click(0.5, 0.5);" > squares.dom
distance=$(sed -n 's/.*data-answers="|distance \([^,]*\),.*/\1/p' squares.dom)
awk -v d="$distance" 'BEGIN { exit !(d != "" && d < 1e-3) }'

# click_path PAGE CLICKS: `length` is what the page tells, clicks.dom the page, first.txt and second.txt the places of the
# last two clicks
click_path()
{
  opened "$1" "$2" > clicks.dom
  length=$(sed -n 's/.*data-path="\([^"]*\)".*/\1/p' clicks.dom)
  sed -n 's/.*data-ends="\([^"]*\)".*/\1/p' clicks.dom | tr '|' '\n' > ends.txt
  head -n 1 ends.txt > first.txt
  tail -n 1 ends.txt > second.txt
}

# Two clicks show the exact path between both points: the one that the program finds.
is_silent distances "$sphere" --source 0 --html clicks.html
for clicks in "click(0.4, 0.4); click(0.6, 0.62);" "click(0.3, 0.5); click(0.7, 0.45);"; do
  click_path clicks.html "$clicks"
  "$program" path "$sphere" --source-file first.txt --target-file second.txt > clicks.csv
  awk -v a="$length" -v b="$(column clicks.csv length)" 'BEGIN { exit !(a > 0 && b > 0 && (a - b)^2 < 1e-12 * b^2) }' \
    || fail "the path in the page has the length $length, not $(column clicks.csv length)"
  contains clicks.dom "exact path between the two clicks: "
done

# Walls and faces to avoid: the faces are gray and have no distance, a click there is none, and the paths between clicks
# are those of the program. Two clicks are on both sides of the wall, and two in different rooms.
printf '4 5\n5 6\n' > wall.txt
seq 8 9 > middle.txt # of the square
is_silent distances "$grid" --source 0 --walls wall.txt --avoid middle.txt --html avoid.html
for clicks in "click(0.25, 0.8); click(0.5, 0.5); click(0.45, 0.8);" "click(0.25, 0.4); click(0.8, 0.8);"; do
  click_path avoid.html "$clicks"
  "$program" path "$grid" --source-file first.txt --target-file second.txt --walls wall.txt --avoid middle.txt > avoid.csv
  "$program" path "$grid" --source-file first.txt --target-file second.txt > free.csv
  awk -v a="$length" -v b="$(column avoid.csv length)" -v c="$(column free.csv length)" \
    'BEGIN { exit !(b > 1.05 * c && (a - b)^2 < 1e-12 * b^2) }' \
    || fail "the path in the page has the length $length, not $(column avoid.csv length)"
done
contains clicks.dom '>walls, which no path crosses</div>'
contains clicks.dom '>faces that paths avoid</div>'
equals "$(grep -c '>not reached</div>' clicks.dom)" 0
opened avoid.html "click(0.5, 0.45); shade(0.5, 0.45); shade(0.53, 0.5); shade(0.25, 0.8); shade(0.8, 0.2);" > gray.dom
contains gray.dom '"|Paths avoid face 8: it has no distance, and no path begins or ends here."'
shades=$(sed -n 's/.*data-shades="\([^"]*\)".*/\1/p' gray.dom)
echo "$shades" | awk '{ exit !(NF == 4 && $1 < 15 && $2 < 15 && $3 > 40 && $4 > 40) }' || fail "the shades are$shades"
printf '4 5\n5 6\n6 7\n' > rooms.txt
is_silent distances "$grid" --source 0 --walls rooms.txt --quiet --html rooms.html
opened rooms.html "click(0.25, 0.8); click(0.6, 0.8);" > rooms.dom
contains rooms.dom 'data-path="none"'
contains rooms.dom 'no path joins the two clicks around what paths avoid'
contains rooms.dom '>not reached</div>'

# A third click begins anew. Keys: axes, help, theme, and forgetting the clicks.
opened clicks.html 'click(0.4, 0.4); click(0.6, 0.6); click(0.5, 0.5);
  for (const key of ["x", "Y", "u", "l", "d", "h"]) document.dispatchEvent(new KeyboardEvent("keydown", { key: key }));' \
  > keys.dom
equals "$(grep -c 'data-path=' keys.dom)" 0
contains keys.dom 'data-theme="dark"'
contains keys.dom '<dialog id="help" open'
contains keys.dom '>z up</button>'
contains keys.dom '<details class="panel" id="legend">' # closed

# Two fingers zoom and move; one finger turns.
opened clicks.html 'const canvas = document.getElementById("surface");
  const finger = (type, id, x, y) => canvas.dispatchEvent(new PointerEvent(type,
    { pointerId: id, pointerType: "touch", isPrimary: id === 1, button: 0, buttons: 1, clientX: x, clientY: y }));
  finger("pointerdown", 1, 300, 400); finger("pointerdown", 2, 500, 400);
  finger("pointermove", 1, 100, 400); finger("pointermove", 2, 700, 400);
  finger("pointerup", 1, 100, 400); finger("pointerup", 2, 700, 400);
  click(0.02, 0.5);' > touch.dom
contains touch.dom 'data-answers="|distance '

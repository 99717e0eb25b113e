"""Builds the compiled part. Needs CGAL's headers, GMP and MPFR; uses TBB if its headers are there."""

import pathlib
import re

from pybind11.setup_helpers import ParallelCompile, Pybind11Extension, build_ext
from setuptools import setup
from setuptools.command.build_py import build_py

root = pathlib.Path(__file__).resolve().parent
version = re.search(r"VERSION (\d+\.\d+\.\d+)\n", (root.parent / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
has_tbb = any((pathlib.Path(prefix) / "include/tbb/task_arena.h").is_file() for prefix in ("/usr", "/usr/local"))

# Two units, as two processors compile them in the least time. Of a function that both have, the linker takes that of
# the first one, which is compiled for speed (FLAGS_OF_FILES).
sources = ["src/unit_of_distances.cpp", "src/unit_of_lines.cpp"]

extension = Pybind11Extension(
    "surface_mesh_geodesics._core", sources,
    include_dirs=[str(root.parent / "include")],
    libraries=["gmp", "mpfr"] + (["tbb"] if has_tbb else []),
    define_macros=[("NDEBUG", None), ("SURFACE_MESH_GEODESICS_VERSION", f'"{version}"')]
    + ([("CGAL_LINKED_WITH_TBB", None)] if has_tbb else []),
    # Python's own flags have -fwrapv on many systems, which slows distances down by a twentieth, and a protector of the
    # stack, which takes another eighth of the instructions. Neither is needed.
    extra_compile_args=["-O3", "-g0", "-fno-wrapv", "-fno-stack-protector", "-frounding-math", "-pthread"],
    extra_link_args=["-pthread"], cxx_std=17)


# GCC bounds what it inlines by the size of the file, and the loops of distances get the less, the more the file holds
# besides: without these limits, distances take as long as in a small program. (CMakeLists.txt has the same flags.)
# Diagrams and paths are a few percent slower with -O2, at most.
FLAGS_OF_FILES = {"unit_of_distances.cpp": ["--param", "large-unit-insns=200000", "--param",
                                            "large-function-growth=400"], "unit_of_lines.cpp": ["-O2"]}


class build_with_flags_of_files(build_ext):
    """Adds the flags of single files."""

    def build_extension(self, ext):
        compile_one = self.compiler._compile

        def compile_with_flags(obj, src, extension, cc_args, flags, pp_opts):
            more = FLAGS_OF_FILES.get(pathlib.Path(src).name, [])
            compile_one(obj, src, extension, cc_args, flags + more, pp_opts)

        self.compiler._compile = compile_with_flags
        super().build_extension(ext)


class build_py_and_page(build_py):
    """Copies the page for browsers from the program for the command line."""

    def run(self):
        super().run()
        folder = pathlib.Path(self.build_lib) / "surface_mesh_geodesics/page"
        self.mkpath(str(folder))
        for source in sorted((root.parent / "demo/Surface_mesh_geodesics/page").iterdir()):
            self.copy_file(str(source), str(folder / source.name))


ParallelCompile("SURFACE_MESH_GEODESICS_JOBS", default=0).install()
setup(version=version, ext_modules=[extension],
      cmdclass={"build_ext": build_with_flags_of_files, "build_py": build_py_and_page})

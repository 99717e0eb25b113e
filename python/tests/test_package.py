"""The package as a whole: its size, its stub, the time of its import, its memory, its signatures."""

import ast
import inspect
import io
import pathlib
import re
import resource
import subprocess
import sys
import tokenize

import numpy as np
import pytest

import surface_mesh_geodesics as smg
from surface_mesh_geodesics import _core
from meshes import grid

ROOT = pathlib.Path(__file__).resolve().parent.parent


# --- its size ---

def lines_of_python(text):
    """Counts the lines with code: no blank lines, no comments, no docstrings."""
    skipped = (tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER)
    lines = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in skipped:
            lines.update(range(token.start[0], token.end[0] + 1))
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node) is not None:
            lines -= set(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return len(lines)


def lines_of_cpp(text):
    assert "/*" not in text
    return sum(bool(line.strip()) and not line.strip().startswith("//") for line in text.splitlines())


def test_lines_are_counted():
    text = '"""Text.\n\nMore."""\n\n# a comment\nx = """a\nb"""\n\n\ndef f():\n    """Text."""\n    return x\n'
    assert lines_of_python(text) == 4
    assert lines_of_cpp("// Text.\n\nint main()\n{\n  // more\n  return 0; // none\n}\n") == 4


def test_the_module_has_at_most_2000_lines():
    """Of C++ and Python together: src, the package with its stub, and setup.py; without tests and examples."""
    python = [*ROOT.glob("surface_mesh_geodesics/*.py*"), ROOT / "setup.py"]
    cpp = [*ROOT.glob("src/*")]
    assert len(python) > 10 and len(cpp) > 5
    assert (sum(lines_of_python(file.read_text(encoding="utf-8")) for file in python)
            + sum(lines_of_cpp(file.read_text(encoding="utf-8")) for file in cpp)) <= 2000


# --- its stub ---

def stub():
    return ast.parse((ROOT / "surface_mesh_geodesics/_core.pyi").read_text(encoding="utf-8")).body


def test_the_stub_has_the_names_of_the_compiled_part():
    public = {name for name in dir(_core) if not name.startswith("__")} | {"__version__"}
    names = set()
    for node in stub():
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
    assert public == names


def number_of_parameters(function):
    """Of a compiled function, as the first line of its docstring tells."""
    parameters = re.match(r"\w+\((.*)\)( ->|$)", function.__doc__.splitlines()[0])[1]
    return len(re.findall(r"(?:^|, )(?:self|arg\d+): ", parameters))


def test_the_stub_has_the_functions_and_parameters_of_the_compiled_part():
    classes = [node for node in stub() if isinstance(node, ast.ClassDef)]
    assert {node.name for node in classes} == {"Diagram", "Surface"}
    for node in classes:
        compiled = getattr(_core, node.name)
        functions = {f.name: f for f in node.body if isinstance(f, ast.FunctionDef)}
        assert set(functions) - {"__init__"} == {n for n in vars(compiled) if not n.startswith("_")}
        for name, function in functions.items():
            assert len(function.args.args) == number_of_parameters(getattr(compiled, name)), name
            assert function.args.vararg is None and function.returns is not None
    (function,) = [node for node in stub() if isinstance(node, ast.FunctionDef)]
    assert function.name == "oriented" and len(function.args.args) == number_of_parameters(_core.oriented)


def public_functions():
    for name in smg.__all__:
        thing = getattr(smg, name)
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                function = value.__func__ if isinstance(value, classmethod) else value
                if inspect.isfunction(function) and (not member.startswith("_") or member == "__init__"):
                    yield f"{name}.{member}", function
        elif callable(thing):
            yield name, thing


def test_all_public_functions_have_types():
    count = 0
    for name, function in public_functions():
        if function.__module__.startswith("surface_mesh_geodesics"):
            signature = inspect.signature(function)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in signature.parameters.values():
                assert parameter.name in ("self", "cls") or parameter.annotation is not parameter.empty
            count += 1
    assert count > 30 and (pathlib.Path(smg.__file__).parent / "py.typed").exists()


ONE_THREAD = {"isolines", "trace", "direction_of", "peeling_order", "avoiding", "from_edge_lengths", "border_curves"}


def test_all_computations_take_threads():
    """Those that cannot say so in their docstrings, or take no time."""
    for name, member in vars(smg.Solver).items():
        if not name.startswith("_") and inspect.isfunction(member) and name not in ONE_THREAD:
            assert "threads" in inspect.signature(member).parameters, name
    for name in ("isolines", "sample", "signed_distances"):
        assert "one thread" in getattr(smg.Solver, name).__doc__


# --- its time and memory ---

def test_the_import_takes_less_time_than_that_of_numpy():
    """Processor time: the best of several processes, as others disturb."""
    program = ("import time; times = [time.process_time()]; import numpy; times.append(time.process_time()); "
               "import surface_mesh_geodesics; print(times[1] - times[0], time.process_time() - times[1])")
    outputs = [subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
               for _ in range(5)]
    numpy, ours = zip(*[map(float, output.split()) for output in outputs])
    assert min(ours) < min(numpy)


def test_a_thousand_solvers_take_no_more_memory_than_a_hundred():
    V, F = grid(30, 0.1)
    source = [(0, [0.2, 0.3, 0.5]), 5]

    def use(n):
        for _ in range(n):
            s = smg.Solver(V, F)
            s.distances(source, threads=2)
            s.path(source, 30)
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = use(100)
    assert use(1000) - before < 4000  # kB


@pytest.mark.parametrize("call", ["distances", "matrix", "paths", "labels", "trace", "voronoi"])
def test_errors_leave_no_memory_and_no_references(call):
    s = smg.Solver(*grid(4))
    bad = np.array([0, 99])
    count = sys.getrefcount(bad)
    for _ in range(100):
        with pytest.raises((ValueError, IndexError)):
            getattr(s, call)(bad, *{"trace": [0.0, 1.0], "distances": []}.get(call, [[0]]))
    assert sys.getrefcount(bad) == count

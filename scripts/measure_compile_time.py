#!/usr/bin/env python3
"""Usage: scripts/measure_compile_time.py [--repeat N] [--program] [--check] [FOLDER]

Prints what it costs to compile with the package, or with another checkout of it: CPU time at -O3, in units of that of a file that
includes CGAL's kernel and Surface_mesh only. Files are compiled in turns, N times, 3 by default, and the least time of each counts.

With --program, also what the command line program costs from clean, and once the step of a vertex has been touched: some minutes.
With --check, fails if a ratio is above its bound.
"""

import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLAGS = "-std=c++17 -O3 -DNDEBUG -DCGAL_LINKED_WITH_TBB -DCGAL_EIGEN3_ENABLED -isystem /usr/include/eigen3 -c -o /dev/null".split()
LIBRARY = "-DCGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY"
UNIT = """#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
"""
MAIN_OF_UNIT = "int main() { Mesh mesh; return static_cast<int>(num_vertices(mesh)); }\n"
MAIN = """int main()
{
  Mesh mesh;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  return CGAL::Spherical_parameterization::parameterize(mesh, sphere);
}
"""
HEADER = "#include <CGAL/Spherical_parameterization/parameterize.h>\n"
UMBRELLA = "#include <CGAL/spherical_parameterization.h>\n"

# name: source, options, bound
FILES = {
    "kernel and Surface_mesh only": (UNIT + MAIN_OF_UNIT, [], None),
    "parameterize.h and a call": (UNIT + HEADER + MAIN, [], 1.9),
    "spherical_parameterization.h and a call": (UNIT + UMBRELLA + MAIN, [], 2.3),
    "parameterize.h and a call, with the library": (UNIT + HEADER + MAIN, [LIBRARY], 1.3),
    "spherical_parameterization.h and a call, with the library": (UNIT + UMBRELLA + MAIN, [LIBRARY], 1.6),
}


def cpu_of(command, **options):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def program_times(folder, directory):
    """The CPU times of the program from clean, without what is no C++, and after the step of a vertex has been touched."""
    build = os.path.join(directory, "build")
    make = ["cmake", "--build", build, "-j", "1", "--target"]
    subprocess.run(["cmake", "-S", folder, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER_LAUNCHER="],
                   check=True, stdout=subprocess.DEVNULL)
    if (folder / "page").exists():
        subprocess.run([*make, "Spherical_parameterization_page"], check=False, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
    clean = cpu_of([*make, "spherical_parameterization"])
    step, = (folder / "include").rglob("Vertex_step.h")
    step.touch()
    return clean, cpu_of([*make, "spherical_parameterization"])


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--program", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=ROOT)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    compiler = os.environ.get("CXX", "g++")
    has_library = (folder / "src").is_dir()
    times = {}
    with tempfile.TemporaryDirectory() as directory:
        for _ in range(arguments.repeat):
            for name, (source, options, _) in FILES.items():
                if LIBRARY in options and not has_library:
                    continue
                path = pathlib.Path(directory, "file.cpp")
                path.write_text(source)
                time = cpu_of([compiler, *FLAGS, *options, f"-I{folder / 'include'}", str(path)])
                times[name] = min(time, times.get(name, time))
        bounds = {name: bound for name, (_, _, bound) in FILES.items()}
        if arguments.program:
            clean, touched = program_times(folder, directory)
            times["the program from clean"], times["the program, the step of a vertex touched"] = clean, touched
            bounds.update({"the program from clean": 11., "the program, the step of a vertex touched": 4.5})
    unit = times["kernel and Surface_mesh only"]
    is_above = False
    for name, time in times.items():
        bound = bounds[name]
        is_above = is_above or (bound is not None and time > bound * unit)
        print(f"{time / unit:6.2f}  {time:7.1f} s  {name}" + (f" (at most {bound})" if bound else ""))
    if arguments.check and is_above:
        sys.exit("A ratio is above its bound.")


main()

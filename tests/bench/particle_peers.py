#!/usr/bin/env python3
"""Draws particles with isomotion, POV-Ray's blob, VTK and OpenVDB, the same ones from the same file.

    tests/bench/particle_peers.py build/release/isomotion -o FOLDER [--counts 1000,10000,100000]
                                  [--size 512] [--repeat 3] [--vtk-python /usr/bin/python3]

The particles fill a ball and shrink as they become more. POV-Ray sums the same kernels, (1 - r^2/h^2)^2,
and so has the same surface. VTK splats Gaussians into a volume of 256^3, from which flying edges make
triangles; beside it isomotion draws the same sums without a volume. OpenVDB makes a level set of balls
around the particles, by particles_to_vdb.cpp, with three voxels a radius and no wider than VTK's, which
vdb_render draws; isomotion draws the same balls exactly. Needs Debian's povray, python3-vtk9, xvfb,
libopenvdb-dev and libopenvdb-tools; what is not installed is left out, and says so.

Whole processes are timed, from the file to the picture, all programs in turn, and the median is told.
`differ` counts the pixels that a program has otherwise than isomotion with the same kernel, and how
many of these lie off isomotion's silhouettes.
"""
import argparse
import pathlib
import shutil
import statistics
import subprocess
import sys
import time

from compare_jsurf import differences, hits
from many_elements import DISTANCE, places

LEVEL = 0.35
EYE = (2.5, 1.6, 1.4)
FIELD = 40                 # degrees
EXPONENT = 9               # VTK's Gaussians end where they are exp(-9)

POVRAY = """#version 3.7;
background {{ color rgb <1, 0, 1> }}
camera {{ perspective location <{eye[0]}, {eye[1]}, {eye[2]}> right -x up y sky z angle {field} look_at 0 }}
light_source {{ <{eye[0]}, {eye[1]}, {eye[2]}> color rgb 1 shadowless }}
blob {{ threshold {level}
{spheres}
texture {{ pigment {{ color rgb <0, 1, 0> }} finish {{ ambient 0.3 diffuse 0.7 }} }} }}
"""

VTK = """
import sys
import vtk
points_file, picture, size, radius, exponent, level = sys.argv[1:]
points = vtk.vtkPoints()
with open(points_file) as rows:
    next(rows)
    for row in rows:
        points.InsertNextPoint(*map(float, row.split(",")))
cloud = vtk.vtkPolyData()
cloud.SetPoints(points)
splat = vtk.vtkGaussianSplatter()
splat.SetInputData(cloud)
splat.SetModelBounds(-1.2, 1.2, -1.2, 1.2, -1.2, 1.2)
splat.SetSampleDimensions(256, 256, 256)
splat.SetRadius(float(radius) / 2.4)
splat.SetExponentFactor(-float(exponent))
splat.SetAccumulationModeToSum()
splat.NormalWarpingOff()
splat.ScalarWarpingOff()
edges = vtk.vtkFlyingEdges3D()
edges.SetInputConnection(splat.GetOutputPort())
edges.SetValue(0, float(level))
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(edges.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtk.vtkActor()
actor.SetMapper(mapper)
renderer = vtk.vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(1, 0, 1)
camera = renderer.GetActiveCamera()
camera.SetPosition({eye})
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle({field})
renderer.ResetCameraClippingRange()
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(int(size), int(size))
window.AddRenderer(renderer)
window.Render()
shot = vtk.vtkWindowToImageFilter()
shot.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetFileName(picture)
writer.SetInputConnection(shot.GetOutputPort())
writer.Write()
"""


def write_particles(file, count):
    rows = [",".join(f"{v:.7g}" for v in place) for place in places(count)]
    file.write_text("\n".join(["cx,cy,cz", *rows]) + "\n")


def write_scene(file, particles, formula, values):
    parameters = "\n".join(f"{name} = {value:.9g}" for name, value in values.items())
    file.write_text(f"""[surface]
formula = "{formula}"
bounds = {{ sphere = 1.2 }}
[parameters]
{parameters}
[arrays.p]
file = "{particles.name}"
[camera]
position = [{", ".join(map(str, EYE))}]
fov = {FIELD}
[output]
background = [1, 0, 1]
[material]
color = [0, 1, 0]
""")


def programs(count, folder, arguments):
    """Name, command and picture of each, and the name of the one that has the same kernel."""
    grain = (75 / count) ** (1 / 3)
    h, a, r = 0.3 * grain, 62 / grain**2, 0.1 * grain
    particles = folder / f"particles{count}.csv"
    write_particles(particles, count)
    size = arguments.size
    made = []
    for kernel, formula, values in [
            ("(1-r^2/h^2)^2", f"{LEVEL} - sum(p, max(0, 1 - {DISTANCE}/h^2)^2)", {"h": h}),
            ("Gaussians", f"{LEVEL} - sum(p, exp(-a*{DISTANCE}))", {"a": a}),
            ("balls", f"least(p, sqrt({DISTANCE}) - r)", {"r": r})]:
        name = {"h": "kernels", "a": "gaussians", "r": "balls"}[next(iter(values))]
        scene, picture = folder / f"{name}{count}.toml", folder / f"isomotion-{name}{count}.png"
        write_scene(scene, particles, formula, values)
        made.append((f"isomotion, {kernel}", [arguments.isomotion, "render", scene, "--size", f"{size}x{size}",
                                              "--audit", "off", "--quiet", "-o", picture], picture, None))
    if shutil.which("povray"):
        scene, picture = folder / f"blob{count}.pov", folder / f"povray{count}.png"
        spheres = "\n".join(f"sphere {{ <{x:.7g}, {y:.7g}, {z:.7g}>, {h:.9g}, 1 }}" for x, y, z in
                            (map(float, row.split(",")) for row in particles.read_text().splitlines()[1:]))
        scene.write_text(POVRAY.format(eye=EYE, field=FIELD, level=LEVEL, spheres=spheres))
        made.append(("POV-Ray, blob", ["povray", f"+I{scene}", f"+O{picture}", f"+W{size}", f"+H{size}",
                                       "-D", "-GA", "-A"], picture, "isomotion, (1-r^2/h^2)^2"))
    else:
        print("povray is not installed", file=sys.stderr)
    vtk = [arguments.vtk_python, "-c", "import vtk"]
    if shutil.which("xvfb-run") and subprocess.run(vtk, capture_output=True).returncode == 0:
        script, picture = folder / "splat.py", folder / f"vtk{count}.png"
        script.write_text(VTK.replace("{eye}", ", ".join(map(str, EYE))).replace("{field}", str(FIELD)))
        made.append(("VTK, splatter and flying edges",
                     ["xvfb-run", "-a", arguments.vtk_python, script, particles, picture, str(size),
                      f"{(EXPONENT / a) ** 0.5:.9g}", str(EXPONENT), str(LEVEL)],
                     picture, "isomotion, Gaussians"))
    else:
        print("python3-vtk9 or xvfb is not installed", file=sys.stderr)
    if made_of_balls := level_set_maker(folder):
        volume, picture = folder / f"balls{count}.vdb", folder / f"openvdb{count}.png"
        eye = ",".join(map(str, EYE))
        made.append(("OpenVDB, level set of balls",
                     ["sh", "-ec", f"'{made_of_balls}' '{particles}' {r:.9g} {min(r / 3, 2.4 / 256):.9g} '{volume}'; "
                      f"vdb_render '{volume}' '{picture}' -res {size}x{size} -fov {FIELD} "
                      f"-translate {eye} -lookat 0,0,0 -up 0,0,1 -shader normal"],
                     picture, "isomotion, balls"))
    else:
        print("libopenvdb-dev or libopenvdb-tools is not installed", file=sys.stderr)
    return made


def level_set_maker(folder):
    """particles_to_vdb, compiled once; none without OpenVDB."""
    program = folder / "particles_to_vdb"
    if not shutil.which("vdb_render"):
        return None
    if not program.exists():
        source = pathlib.Path(__file__).with_name("particles_to_vdb.cpp")
        subprocess.run(["c++", "-std=c++17", "-O2", source, "-o", program, "-lopenvdb", "-ltbb", "-lImath"],
                       capture_output=True)
    return program if program.exists() else None


def took(command):
    begin = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr.strip()[-2000:]}")
    return time.monotonic() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("isomotion", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--counts", default="1000,10000,100000")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--vtk-python", default="/usr/bin/python3")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    print("| particles | program | process, s | differ | off silhouettes |\n|--:|---|--:|--:|--:|")
    for count in map(int, arguments.counts.split(",")):
        made = programs(count, arguments.output, arguments)
        times = {name: [] for name, *_ in made}
        for _ in range(arguments.repeat):
            for name, command, picture, _ in made:
                picture.unlink(missing_ok=True)
                times[name].append(took(command))
        masks = {name: hits(picture, (0, 0, 0) if name.startswith("OpenVDB") else (255, 0, 255))
                 for name, _, picture, _ in made}
        for name, _, _, same in made:
            differ, off = differences(masks[same], masks[name]) if same else ("", "")
            print(f"| {count} | {name} | {statistics.median(times[name]):.2f} | {differ} | {off} |", flush=True)


if __name__ == "__main__":
    main()

"""A pressed particle in ParaView: the whole section, coloured by zone in the hues of zones.svg; time is delta/R0.

  cd out/inside && paraview --script=../../examples/look-inside.py        # the folder with fields.pvd
  pvbatch examples/look-inside.py out/inside picture.png [FIELD]          # a picture of the last state; FIELD: rho_r, q_Pa, ...
"""
import os
import sys

from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else "."
picture = sys.argv[2] if len(sys.argv) > 2 else None
field = sys.argv[3] if len(sys.argv) > 3 else "zone"
series = os.path.join(folder, "fields.pvd")
if not os.path.exists(series):
    sys.exit(f"{series} is not there: run platen press with fields_at in [output] of the case card")

fields = PVDReader(registrationName="particle", FileName=os.path.abspath(series))
right = Reflect(registrationName="both sides", Input=fields, Plane="X Min")
whole = Reflect(registrationName="both halves", Input=right, Plane="Y Min")

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [900, 800]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

shown = Show(whole, view)
shown.SetRepresentationType("Surface With Edges")
shown.EdgeColor = [0.9, 0.9, 0.9]
shown.Ambient, shown.Diffuse = 1, 0  # the colours themselves, no light
ColorBy(shown, ("CELLS", field))
colours = GetColorTransferFunction(field)
if field == "zone":
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = ["0", "elastic", "1", "shear", "2", "compaction", "3", "tension"]
    colours.IndexedColors = [c / 255 for hue in ("3b6fb5", "f6c945", "b5283b", "7cc07a") for c in bytes.fromhex(hue)]
else:
    colours.ApplyPreset("Viridis (matplotlib)", True)
    shown.RescaleTransferFunctionToDataRange(False, True)
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = field, ""
bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]

label = AnnotateTimeFilter(registrationName="overlap", Input=whole, Format="delta/R0 = {time:g}")
words = Show(label, view)
words.Color = [0.1, 0.1, 0.1]
words.WindowLocation = "Upper Center"

ResetCamera(view)
view.CameraParallelProjection = 1
Render(view)
if picture:
    SaveScreenshot(picture, view)

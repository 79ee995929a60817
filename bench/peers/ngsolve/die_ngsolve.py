#!/usr/bin/env python3
"""A sphere in a die in NGSolve: planes along z move, four walls stand. Tetrahedra of second order with a pressure of first,
on 1/16 of the sphere (0 <= y <= x, z >= 0); contact by penalty on the true sphere, backward Euler. Perfectly plastic,
Cauchy yield, as press_ngsolve.py.

    OMP_NUM_THREADS=1 v/bin/python die_ngsolve.py --E 4500 --h 0.1 --step 0.01
"""
import argparse
import math
import sys
import time

from ngsolve import *
from ngsolve.comp import IntegrationRuleSpace
from netgen.occ import Box, HalfSpace, OCCGeometry, Pnt, Sphere, Vec

p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
p.add_argument("--E", type=float, default=100)
p.add_argument("--nu", type=float, default=0.3)
p.add_argument("--h", type=float, default=0.1, help="edges on the sphere")
p.add_argument("--inner", type=float, default=2, help="edges inside, over those on the sphere")
p.add_argument("--grading", type=float, default=0.3)
p.add_argument("--order", type=int, default=2)
p.add_argument("--step", type=float, default=0.01)
p.add_argument("--first", type=float, default=0.01)
p.add_argument("--stiffness", type=float, default=3e4, help="pressure over penetration, sigma_y/R")
p.add_argument("--walls", type=int, default=1, help="0: simple compression")
p.add_argument("--until", type=float, default=0.47)
p.add_argument("--compile", action="store_true", help="by the C++ compiler: a minute (once, with ccache), then four times faster")
p.add_argument("--out", default="")
a = p.parse_args()
SetNumThreads(1)
ball = Sphere(Pnt(0, 0, 0), 1) * Box(Pnt(0, 0, 0), Pnt(2, 2, 2)) * HalfSpace(Pnt(0, 0, 0), Vec(-1, 1, 0))
for f in ball.faces:
    c = f.center
    if abs(c.z) < 1e-6: f.name = "z0"
    elif abs(c.y) < 1e-6: f.name = "y0"
    elif abs(c.x - c.y) < 1e-6: f.name = "mirror"
    else: f.name, f.maxh = "sphere", a.h
mesh = Mesh(OCCGeometry(ball).GenerateMesh(maxh=a.inner * a.h, grading=a.grading)).Curve(a.order)
V = VectorH1(mesh, order=a.order, dirichlety="y0", dirichletz="z0", dirichletx_bbnd="", dirichlet="")
X = V * H1(mesh, order=a.order - 1)
points = IntegrationRuleSpace(mesh, order=2 * a.order - 1)
rules = points.GetIntegrationRules()
state = [GridFunction(points) for _ in range(6)]      # Cp^-1: 11 22 33 12 13 23
new = [GridFunction(points) for _ in range(6)]
for i in range(3): state[i].vec[:] = 1
gf = GridFunction(X)
print(f"{mesh.ne} tetrahedra, {X.ndof} unknowns", set(mesh.GetBoundaries()), flush=True)
G, K = a.E / (2 * (1 + a.nu)), a.E / (3 * (1 - 2 * a.nu))
one = Id(3)
C = CF((state[0], state[3], state[4], state[3], state[1], state[5], state[4], state[5], state[2]), dims=(3, 3))
delta = Parameter(a.first)


def material(grad):
    F = one + grad
    J = Det(F)
    b = F * C * F.trans
    L = 2 * (b - one) * Inv(b + one)                  # log b, Pade
    L = (L + L.trans) / 2
    m = Trace(L) / 3
    e = (L - m * one) / 2
    q = 3 * G * sqrt(2 / 3 * InnerProduct(e, e) + 1e-20)
    f = IfPos(q - J, J / q, 1)
    return F, J, e, m, f


(u, pr), (v, qr) = X.TnT()
F, J, e, m, f = material(Grad(u))
l = Grad(v) * Inv(F)
A = BilinearForm(X)
A += (InnerProduct(2 * G * f * e, l) + pr * Trace(l) + qr * (log(J) - pr / K)).Compile(a.compile, wait=True) * dx(intrules=rules)
k = a.stiffness
g_z = z + u[2] - (1 - delta)
A += (k * IfPos(g_z, g_z, 0) * v[2]).Compile(a.compile, wait=True) * ds("sphere", bonus_intorder=4)
if a.walls:
    g_x = x + u[0] - 1
    A += (k * IfPos(g_x, g_x, 0) * v[0]).Compile(a.compile, wait=True) * ds("sphere", bonus_intorder=4)
A += 3e3 * a.E * (u[0] - u[1]) * (v[0] - v[1]) * ds("mirror")
U = gf.components[0]
Fg, Jg, eg, mg, fg = material(Grad(U))
H = fg * eg + mg / 2 * one
Cn = Inv(Fg) * ((one + H) * Inv(one - H)) * Inv(Fg).trans
Cn = Det(Cn) ** (-1 / 3) * Cn
new_state = [Cn[i, j].Compile(a.compile, wait=True) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
gz, gx = z + U[2] - (1 - delta), x + U[0] - 1
res, du = gf.vec.CreateVector(), gf.vec.CreateVector()
free = X.FreeDofs()
proj = Projector(free, True)


def forces():
    def one_plane(g, wedges):
        w = Integrate(k * IfPos(g, g, 0) * ds("sphere", bonus_intorder=4), mesh)
        e = Integrate(k * IfPos(g, g, 0) * g * ds("sphere", bonus_intorder=4), mesh)
        return wedges * w / math.pi, e / max(w, 1e-30)
    return one_plane(gz, 8) + (one_plane(gx, 4) if a.walls else (0, 0))


def newton(limit=20):
    A.Apply(gf.vec, res); proj.Project(res)
    norm = res.Norm()
    for it in range(limit):
        A.AssembleLinearization(gf.vec)
        du.data = A.mat.Inverse(free, inverse="umfpack") * res
        t = 1.0
        while True:
            gf.vec.data -= t * du
            A.Apply(gf.vec, res); proj.Project(res)
            n2 = res.Norm()
            if n2 < 0.9999 * norm or (t < 0.1 and n2 < 3 * norm): break
            gf.vec.data += t * du
            t *= 0.5
            if t < 1e-3: return None
        norm = n2
        if norm < 1e-5 * max(forces()[0], 1e-6): return it + 1
    return None


old, older = gf.vec.CreateVector(), gf.vec.CreateVector()
old[:] = 0; older[:] = 0
d, last, cut, steps, its, start, rows = 0.0, None, 1.0, 0, 0, time.time(), []
goal = 0.0
while d < a.until - 1e-9:
    if d >= goal - 1e-9: goal = round(goal + a.step, 9)
    inc = min(goal - d, a.step * cut, a.first if d == 0 else 1.5 * last)
    if goal - d - inc < 0.2 * inc: inc = goal - d
    delta.Set(d + inc)
    gf.vec.data = old
    if last: gf.vec.data += inc / last * (old - older)
    n = newton()
    if n is None:
        cut *= 0.5
        print(f"  cut at {d + inc:.5f}", flush=True)
        if cut < 0.02: break
        continue
    cut = min(1, cut * 1.4)
    for part, cf in zip(new, new_state): part.Interpolate(cf)
    for part, value in zip(state, new): part.vec.data = value.vec
    older.data = old; old.data = gf.vec
    d += inc; last = inc; its += n; steps += 1
    Fz, pz, Fx, px = forces()
    Jm = Integrate(Jg, mesh) / Integrate(CF(1), mesh)
    rows.append((d, pz, px, Fz, Fx, Jm))
    print(f"{d:.5f} pen {pz:.6f} {px:.6f} F {Fz:.5f} side {Fx:.5f} J {Jm:.5f} {steps} steps {its} its {time.time() - start:.0f} s", flush=True)
    if a.out:
        with open(a.out, "w") as out:
            out.write("# " + " ".join(sys.argv[1:]) + f"; {mesh.ne} tetrahedra\ndelta_bar,penetration,penetration_walls,F_bar,F_bar_walls,J\n")
            for row in rows: out.write(",".join(f"{v:.7g}" for v in row) + "\n")

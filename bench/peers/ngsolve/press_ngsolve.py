#!/usr/bin/env python3
"""The simple press in NGSolve: triangles of second order with a pressure of first (Taylor-Hood), contact by
penalty on the true sphere, backward Euler. A peer of `platen press`: elements, linearisation, contact
integration and solver are NGSolve's; only the return mapping is written here.

    python3 -m venv v && v/bin/pip install ngsolve numpy scipy
    OMP_NUM_THREADS=1 v/bin/python press_ngsolve.py --E 100 --step 0.04 --h 0.012 --at 0.02,0.05,0.1

The flow is of first order in the step: run with --step c and c/2, and extrapolate (extrapolate.py).
F = F_e F_p; logarithmic elastic strain; yield of q = J sigma(eps_p) in Kirchhoff stress, which is Cauchy's q = sigma
(--kirchhoff leaves the J out). Radius and yield stress are one (for Hollomon: kappa is one).
"""
import argparse
import math
import sys
import time

import numpy as np
from ngsolve import *
from ngsolve.comp import IntegrationRuleSpace
from netgen.occ import ArcOfCircle, Face, OCCGeometry, Pnt, Segment, Wire

p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
p.add_argument("--E", type=float, default=100, help="E over sigma_y (Hollomon: over kappa)")
p.add_argument("--nu", type=float, default=0.3)
p.add_argument("--n", type=float, default=0, help="Hollomon exponent 1/m; 0: perfectly plastic")
p.add_argument("--kirchhoff", action="store_true", help="yield in Kirchhoff stress")
p.add_argument("--h", type=float, default=0.012, help="edges at the pole; twice that beyond s = 0.25, 3.3 times beyond 0.6")
p.add_argument("--grading", type=float, default=0.2)
p.add_argument("--order", type=int, default=2)
p.add_argument("--step", type=float, default=0.04, help="step over delta_bar")
p.add_argument("--step-max", type=float, default=0.125, help="largest step of delta_bar, over --step")
p.add_argument("--first", type=float, default=1e-3)
p.add_argument("--penetration", type=float, default=1e-3, help="of a pressure of 3 sigma_y, over delta_bar")
p.add_argument("--at", default="0.01,0.02,0.03,0.05,0.1,0.15,0.2,0.25,0.3,0.35,0.4,0.45,0.5")
p.add_argument("--out", default="")
a = p.parse_args()
SetNumThreads(1)
at = [float(x) for x in a.at.split(",")]

# ---- mesh: quarter disc, arcs of three sizes --------------------------------------------------------------
def on_arc(s): return Pnt(math.sin(s), math.cos(s), 0)
cuts = [0, 0.25, 0.6, 1.3, math.pi / 2]
sizes = [a.h, 2 * a.h, 3.3 * a.h, 6 * a.h]
edges = []
for s0, s1 in zip(cuts, cuts[1:]):
    edges.append(ArcOfCircle(on_arc(s0), on_arc((s0 + s1) / 2), on_arc(s1)))
bottom, axis = Segment(Pnt(1, 0, 0), Pnt(0, 0, 0)), Segment(Pnt(0, 0, 0), Pnt(0, 1, 0))
face = Face(Wire(edges + [bottom, axis]))
for e in face.edges:                              # a wire forgets names and sizes
    c = e.center
    if abs(c.x) < 1e-9: e.name = "axis"
    elif abs(c.y) < 1e-9: e.name = "equator"
    else: e.name, e.maxh = "arc", next(size for s, size in zip(cuts[1:], sizes) if math.atan2(c.x, c.y) < s)
mesh = Mesh(OCCGeometry(face, dim=2).GenerateMesh(maxh=0.12, grading=a.grading)).Curve(3)

# ---- spaces -----------------------------------------------------------------------------------------------
V = H1(mesh, order=a.order, dirichlet="axis") * H1(mesh, order=a.order, dirichlet="equator")
X = V * H1(mesh, order=a.order - 1)
points = IntegrationRuleSpace(mesh, order=2 * a.order)
rules = points.GetIntegrationRules()
state = [GridFunction(points) for _ in range(5)]     # Cp^-1: rr, zz, rz, tt; plastic strain
new = [GridFunction(points) for _ in range(5)]
for part, one in zip(state, (1, 1, 0, 1, 0)): part.vec[:] = one
(ur, uz, pr), (vr, vz, qr) = X.TnT()
gf = GridFunction(X)
print(f"{mesh.ne} triangles, {X.ndof} unknowns", mesh.GetBoundaries(), flush=True)

E, nu = a.E, a.nu
G, K = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))
r = x
delta, k = Parameter(a.first), Parameter(1)
Crr, Czz, Crz, Ctt, ep = state


def sigma(e):                                     # Hollomon: total strain e
    return e ** a.n


def material(u_r, u_z):
    """J, deviatoric Kirchhoff stress (rr, zz, rz, tt), F inverse, F33, new state."""
    gr, gz = Grad(u_r), Grad(u_z)
    F11, F12, F21, F22, F33 = 1 + gr[0], gr[1], gz[0], 1 + gz[1], 1 + u_r / r
    J2 = F11 * F22 - F12 * F21
    J = J2 * F33
    # b = F Cp^-1 F^T
    A11, A12 = F11 * Crr + F12 * Crz, F11 * Crz + F12 * Czz
    A21, A22 = F21 * Crr + F22 * Crz, F21 * Crz + F22 * Czz
    b11, b12, b22 = A11 * F11 + A12 * F12, A11 * F21 + A12 * F22, A21 * F21 + A22 * F22
    b33 = F33 * F33 * Ctt
    # logarithm by its Pade form 2 (b - 1)(b + 1)^-1, whose inverse is exact (error x^3/12)
    d = (b11 + 1) * (b22 + 1) - b12 * b12
    l11 = 2 * ((b11 - 1) * (b22 + 1) - b12 * b12) / d
    l22 = 2 * ((b22 - 1) * (b11 + 1) - b12 * b12) / d
    l12 = 4 * b12 / d
    l33 = 2 * (b33 - 1) / (b33 + 1)
    m = (l11 + l22 + l33) / 3
    e11, e22, e33, e12 = (l11 - m) / 2, (l22 - m) / 2, (l33 - m) / 2, l12 / 2
    q = 3 * G * sqrt(2 / 3 * (e11 * e11 + e22 * e22 + e33 * e33 + 2 * e12 * e12) + 1e-20)
    Jy = 1 if a.kirchhoff else J
    if a.n:
        # q - 3 G (e - sigma(e)/E - ep) = J sigma(e) for the total strain e, from a lower bound, by Newton
        ey = (1 / E) ** (1 / (1 - a.n))
        c = 3 * G / E - Jy
        t = ep + q / (3 * G)
        e = IfPos(t - ey, t, ey)
        for _ in range(4):
            e = e - (3 * G * (t - e) + c * sigma(e)) / (-3 * G + c * a.n * sigma(e) / e)
            e = IfPos(e - ey, e, ey)
        # does it flow? compare with the stress at the old plastic strain
        old = IfPos(ep - 1e-14, ep, 0)
        e0 = IfPos(t - ey, ep + ey, ey)
        for _ in range(6):                        # e0 - sigma(e0)/E = ep
            e0 = e0 - (e0 - sigma(e0) / E - ep) / (1 - a.n * sigma(e0) / e0 / E)
            e0 = IfPos(e0 - ey, e0, ey)
        y0, y1 = Jy * sigma(e0), Jy * sigma(e)
        f = IfPos(q - y0, y1 / q, 1)
    else:
        f = IfPos(q - Jy, Jy / q, 1)
    s = [2 * G * f * e11, 2 * G * f * e22, 2 * G * f * e12, 2 * G * f * e33]
    I11, I12, I21, I22 = F22 / J2, -F12 / J2, -F21 / J2, F11 / J2

    def update():
        h11, h22, h12, h33 = f * e11 + m / 2, f * e22 + m / 2, f * e12, f * e33 + m / 2   # L/2
        D = (1 - h11) * (1 - h22) - h12 * h12
        # (1 + L/2)(1 - L/2)^-1
        B11 = ((1 + h11) * (1 - h22) + h12 * h12) / D
        B22 = ((1 + h22) * (1 - h11) + h12 * h12) / D
        B12 = (h12 * (1 - h11) + (1 + h11) * h12) / D
        B33 = (1 + h33) / (1 - h33)
        a11, a12 = I11 * B11 + I12 * B12, I11 * B12 + I12 * B22
        a21, a22 = I21 * B11 + I22 * B12, I21 * B12 + I22 * B22
        c11, c12, c22 = a11 * I11 + a12 * I12, a11 * I21 + a12 * I22, a21 * I21 + a22 * I22
        c33 = B33 / (F33 * F33)
        w = ((c11 * c22 - c12 * c12) * c33) ** (-1 / 3)      # flow keeps the volume
        return c11 * w, c22 * w, c12 * w, c33 * w, ep + (1 - f) * q / (3 * G)

    return J, s, (I11, I12, I21, I22), F33, update


J, s, (I11, I12, I21, I22), F33, _ = material(ur, uz)
dr, dz = Grad(vr), Grad(vz)
l11 = dr[0] * I11 + dr[1] * I21
l12 = dr[0] * I12 + dr[1] * I22
l21 = dz[0] * I11 + dz[1] * I21
l22 = dz[0] * I12 + dz[1] * I22
l33 = vr / r / F33
form = s[0] * l11 + s[1] * l22 + s[2] * (l12 + l21) + s[3] * l33 + pr * (l11 + l22 + l33) + qr * (log(J) - pr / K)
A = BilinearForm(X)
A += (form * r).Compile() * dx(intrules=rules)
g = y + uz - (1 - delta)
order_c = 4 * a.order
A += (k * IfPos(g, g, 0) * vz * r).Compile() * ds("arc", bonus_intorder=order_c)

Ju, _, _, _, upd = material(gf.components[0], gf.components[1])
# components of a GridFunction: Grad by grad()
new_state = [c.Compile() for c in upd()]
gu = y + gf.components[1] - (1 - delta)
arc = mesh.Boundaries("arc")
arc_points = [(math.sin(t), math.cos(t)) for t in np.linspace(1e-4, math.pi / 2 - 1e-4, int(40 / a.h))]
res, du = gf.vec.CreateVector(), gf.vec.CreateVector()
free = X.FreeDofs()
proj = Projector(free, True)


def force():
    F = 2 * Integrate(k * IfPos(gu, gu, 0) * r * ds("arc", bonus_intorder=order_c), mesh)
    W = 2 * Integrate(k * IfPos(gu, gu, 0) * gu * r * ds("arc", bonus_intorder=order_c), mesh)
    return F, W / max(F, 1e-30)                                # F/(pi R^2 sigma_y), mean penetration


def radius():
    """Outermost deformed radius of a touching point of the sphere, between samples linearly."""
    last, best = None, 0
    for X_, Y_ in arc_points:
        mip = mesh(X_ * (1 - 1e-5), Y_ * (1 - 1e-5))
        v = Y_ + gf.components[1](mip) - (1 - delta.Get())
        rr = X_ + gf.components[0](mip)
        if v > 0: best = max(best, rr)
        elif last and last[0] > 0:
            best = max(best, last[1] + (rr - last[1]) * last[0] / (last[0] - v))
        last = (v, rr)
    return best


def newton(limit=25):
    scale = None
    history = []
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
            if t < 1e-3 or not n2 == n2 and t < 1e-3: return None
        norm = n2
        F, _ = force()
        # residual over the force; pressure rows are strains
        if norm < 2e-6 * max(F, 1e-6): return it + 1
    return None


old, older = gf.vec.CreateVector(), gf.vec.CreateVector()
old[:] = 0; older[:] = 0
d, d_old = 0.0, 0.0
start, its, steps = time.time(), 0, 0
rows, todo = [], list(at)
inc = a.first
cut = 1.0
last_inc = None
while todo:
    inc = min(a.step * max(d, a.first / a.step / 2), a.step * a.step_max) * cut
    if last_inc: inc = min(inc, 1.5 * last_inc)
    near = False
    if d + 1.01 * inc >= todo[0]: inc, near = todo[0] - d, True
    delta.Set(d + inc)
    k.Set(3 / (a.penetration * (d + inc)) * (max(0.05, (d + inc) ** a.n) if a.n else 1))
    gf.vec.data = old
    if last_inc: gf.vec.data += (inc / last_inc) * (old - older)
    n = newton()
    if n is None:
        cut *= 0.5
        print(f"  cut at {d + inc:.5f}", flush=True)
        if cut < 0.01: break
        continue
    cut = min(1.0, cut * 1.3)
    for part, cf in zip(new, new_state): part.Interpolate(cf)
    for part, value in zip(state, new): part.vec.data = value.vec
    older.data = old; old.data = gf.vec
    d += inc; last_inc = inc; its += n; steps += 1
    if near or steps % 10 == 0:
        F, pen = force()
        R = radius() if near else float("nan")
        if near:
            todo.pop(0)
            rows.append((d, d - pen, F, R))
        print(f"{d:.5f} {d - pen:.6f} F {F:.5f} a {R:.5f}  {steps} steps {its} its {time.time() - start:.0f} s", flush=True)
if a.out:
    with open(a.out, "w") as out:
        out.write("# " + " ".join(sys.argv[1:]) + f"; {mesh.ne} triangles, {steps} steps\ndelta_bar,delta_bar_less_penetration,F_bar,a_bar\n")
        for row in rows: out.write(",".join(f"{v:.7g}" for v in row) + "\n")

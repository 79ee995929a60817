"""What the axisymmetric peers in NGSolve share: mesh of a quarter section, contact with the plane by penalty on the true
sphere, Newton, steps, output. A material is a module that gives spaces, form and new state (von_mises.py, vmdc.py)."""
import argparse
import math
import sys
import time

import numpy as np
from ngsolve import *
from ngsolve.comp import IntegrationRuleSpace
from netgen.occ import ArcOfCircle, Face, OCCGeometry, Pnt, Segment, Wire

r = x                                             # the axis of rotation is y


def arguments(text):
    p = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--E", type=float, default=100, help="E over sigma_y (Hollomon: over kappa)")
    p.add_argument("--nu", type=float, default=0.3)
    p.add_argument("--h", type=float, default=0.01, help="edges at the pole; twice that beyond s = 0.25, 3.3 times beyond 0.6")
    p.add_argument("--grading", type=float, default=0.2)
    p.add_argument("--order", type=int, default=2)
    p.add_argument("--step", type=float, default=0.04, help="step over delta_bar")
    p.add_argument("--step-max", type=float, default=0.125, help="largest step of delta_bar, over --step")
    p.add_argument("--first", type=float, default=1e-3)
    p.add_argument("--penetration", type=float, default=1e-3, help="of a pressure of 3 sigma_y, over delta_bar")
    p.add_argument("--at", default="0.01,0.02,0.03,0.05,0.1,0.15,0.2,0.25,0.3,0.35,0.4,0.45,0.5")
    p.add_argument("--compile", action="store_true", help="by the C++ compiler: a minute (once, with ccache), then four times faster")
    p.add_argument("--out", default="", help="CSV")
    return p


def mesh_of(h, grading, maxh=0.12):
    """Triangles; the arc in four pieces, each with its edge."""
    on_arc = lambda s: Pnt(math.sin(s), math.cos(s), 0)
    cuts, sizes = [0, 0.25, 0.6, 1.3, math.pi / 2], [h, 2 * h, 3.3 * h, 6 * h]
    edges = [ArcOfCircle(on_arc(a), on_arc((a + b) / 2), on_arc(b)) for a, b in zip(cuts, cuts[1:])]
    edges += [Segment(Pnt(1, 0, 0), Pnt(0, 0, 0)), Segment(Pnt(0, 0, 0), Pnt(0, 1, 0))]
    face = Face(Wire(edges))
    for e in face.edges:                          # a wire forgets names and sizes
        c = e.center
        if abs(c.x) < 1e-9: e.name = "axis"
        elif abs(c.y) < 1e-9: e.name = "equator"
        else: e.name, e.maxh = "arc", next(size for s, size in zip(cuts[1:], sizes) if math.atan2(c.x, c.y) < s)
    return Mesh(OCCGeometry(face, dim=2).GenerateMesh(maxh=maxh, grading=grading)).Curve(3)


class Kinematics:
    """F of u = (u_r, u_z), its inverse and determinant, and the gradient l = dF F^-1 of a test function."""

    def __init__(self, u_r, u_z):
        gr, gz = Grad(u_r), Grad(u_z)
        self.F11, self.F12, self.F21, self.F22, self.F33 = 1 + gr[0], gr[1], gz[0], 1 + gz[1], 1 + u_r / r
        J2 = self.F11 * self.F22 - self.F12 * self.F21
        self.J = J2 * self.F33
        self.I11, self.I12, self.I21, self.I22 = self.F22 / J2, -self.F12 / J2, -self.F21 / J2, self.F11 / J2

    def push(self, c11, c22, c12, c33):           # F C F^T
        A11, A12 = self.F11 * c11 + self.F12 * c12, self.F11 * c12 + self.F12 * c22
        A21, A22 = self.F21 * c11 + self.F22 * c12, self.F21 * c12 + self.F22 * c22
        return (A11 * self.F11 + A12 * self.F12, A21 * self.F21 + A22 * self.F22, A11 * self.F21 + A12 * self.F22,
                self.F33 * self.F33 * c33)

    def pull(self, b11, b22, b12, b33):           # F^-1 b F^-T, scaled to determinant one: flow keeps the volume
        A11, A12 = self.I11 * b11 + self.I12 * b12, self.I11 * b12 + self.I12 * b22
        A21, A22 = self.I21 * b11 + self.I22 * b12, self.I21 * b12 + self.I22 * b22
        c = (A11 * self.I11 + A12 * self.I12, A21 * self.I21 + A22 * self.I22, A11 * self.I21 + A12 * self.I22,
             b33 / (self.F33 * self.F33))
        w = ((c[0] * c[1] - c[2] * c[2]) * c[3]) ** (-1 / 3)
        return [v * w for v in c]

    def gradient(self, v_r, v_z):                 # rr, zz, rz + zr, tt
        dr, dz = Grad(v_r), Grad(v_z)
        return (dr[0] * self.I11 + dr[1] * self.I21, dz[0] * self.I12 + dz[1] * self.I22,
                dr[0] * self.I12 + dr[1] * self.I22 + dz[0] * self.I11 + dz[1] * self.I21, v_r / r / self.F33)


def logarithm(b11, b22, b12, b33):
    """Deviator of (ln b)/2 and mean of ln b, by the Pade form ln b = 2 (b - 1)(b + 1)^-1 (error x^3/12)."""
    d = (b11 + 1) * (b22 + 1) - b12 * b12
    l11 = 2 * ((b11 - 1) * (b22 + 1) - b12 * b12) / d
    l22 = 2 * ((b22 - 1) * (b11 + 1) - b12 * b12) / d
    l12, l33 = 4 * b12 / d, 2 * (b33 - 1) / (b33 + 1)
    m = (l11 + l22 + l33) / 3
    return ((l11 - m) / 2, (l22 - m) / 2, l12 / 2, (l33 - m) / 2), m


def exponential(h11, h22, h12, h33):
    """The inverse: (1 + h)(1 - h)^-1 of h = (ln b)/2."""
    D = (1 - h11) * (1 - h22) - h12 * h12
    return (((1 + h11) * (1 - h22) + h12 * h12) / D, ((1 + h22) * (1 - h11) + h12 * h12) / D,
            (h12 * (1 - h11) + (1 + h11) * h12) / D, (1 + h33) / (1 - h33))


def equivalent(e):
    return sqrt(2 / 3 * (e[0] * e[0] + e[1] * e[1] + e[3] * e[3] + 2 * e[2] * e[2]) + 1e-20)


class Press:
    """X: a space whose first two parts are u_r and u_z; form(trial, test): integrand over the reference section, without r."""

    def __init__(self, a, mesh, X, pressure=lambda delta: 3):
        SetNumThreads(1)
        self.a, self.mesh, self.X, self.pressure = a, mesh, X, pressure
        self.rules = IntegrationRuleSpace(mesh, order=2 * a.order)
        self.gf = GridFunction(X)
        self.delta, self.k = Parameter(a.first), Parameter(1)
        self.A = BilinearForm(X)
        self.order_c = 4 * a.order
        self.res, self.du = self.gf.vec.CreateVector(), self.gf.vec.CreateVector()
        self.proj = Projector(X.FreeDofs(), True)
        samples = np.linspace(1e-4, math.pi / 2 - 1e-4, int(40 / a.h))
        self.arc = [(math.sin(t), math.cos(t)) for t in samples]
        print(f"{mesh.ne} triangles, {X.ndof} unknowns", flush=True)

    def state(self, initial):
        g = GridFunction(self.rules)
        g.vec[:] = initial
        return g

    def assemble(self, integrand, u_z, v_z):
        self.A += (integrand * r).Compile(self.a.compile, wait=True) * dx(intrules=self.rules.GetIntegrationRules())
        g = y + u_z - (1 - self.delta)
        self.A += (self.k * IfPos(g, g, 0) * v_z * r).Compile(self.a.compile, wait=True) * ds("arc", bonus_intorder=self.order_c)

    def force(self):
        """F/(pi R^2), and the mean penetration."""
        g = y + self.gf.components[1] - (1 - self.delta)
        on = ds("arc", bonus_intorder=self.order_c)
        F = 2 * Integrate(self.k * IfPos(g, g, 0) * r * on, self.mesh)
        return F, 2 * Integrate(self.k * IfPos(g, g, 0) * g * r * on, self.mesh) / max(F, 1e-30)

    def radius(self):
        """Outermost deformed radius of a touching point of the sphere, between samples linearly."""
        last, best = None, 0
        for X_, Y_ in self.arc:
            mip = self.mesh(X_ * (1 - 1e-5), Y_ * (1 - 1e-5))
            g = Y_ + self.gf.components[1](mip) - (1 - self.delta.Get())
            rr = X_ + self.gf.components[0](mip)
            if g > 0: best = max(best, rr)
            elif last and last[0] > 0: best = max(best, last[1] + (rr - last[1]) * last[0] / (last[0] - g))
            last = (g, rr)
        return best

    def residual(self):
        self.A.Apply(self.gf.vec, self.res)
        self.proj.Project(self.res)
        return self.res.Norm()

    def newton(self, limit=25):
        norm = self.residual()
        for it in range(limit):
            self.A.AssembleLinearization(self.gf.vec)
            self.du.data = self.A.mat.Inverse(self.X.FreeDofs(), inverse="umfpack") * self.res
            t = 1.0
            while True:
                self.gf.vec.data -= t * self.du
                new = self.residual()
                if new < 0.9999 * norm or (t < 0.1 and new < 3 * norm): break
                self.gf.vec.data += t * self.du
                t *= 0.5
                if t < 1e-3: return None
            norm = new
            if norm < 2e-6 * max(self.force()[0], 1e-6): return it + 1
        return None

    def run(self, commit, prepare=lambda ratio: None):
        """commit(): state at the end of a step; prepare(ratio): before a step, `ratio` times as long as the last."""
        a, gf = self.a, self.gf
        old, older = gf.vec.CreateVector(), gf.vec.CreateVector()
        old.data = gf.vec; older.data = gf.vec
        todo, rows = [float(v) for v in a.at.split(",")], []
        d, last, cut, its, steps, start = 0.0, None, 1.0, 0, 0, time.time()
        while todo:
            inc = min(max(a.step * d, a.first * a.step / 0.08), a.step * a.step_max) * cut
            if last: inc = min(inc, 1.5 * last)
            near = d + 1.01 * inc >= todo[0]
            if near: inc = todo[0] - d
            self.delta.Set(d + inc)
            self.k.Set(self.pressure(d + inc) / (a.penetration * (d + inc)))
            gf.vec.data = old
            if last: gf.vec.data += (inc / last) * (old - older)
            prepare(inc / last if last else 0)
            n = self.newton()
            if n is None:
                cut *= 0.5
                print(f"  cut at {d + inc:.5f}", flush=True)
                if cut < 0.01: break
                continue
            cut = min(1.0, cut * 1.3)
            commit()
            older.data = old; old.data = gf.vec
            d += inc; last = inc; its += n; steps += 1
            if near or steps % 10 == 0:
                F, pen = self.force()
                R = self.radius() if near else float("nan")
                if near:
                    todo.pop(0)
                    rows.append((d, d - pen, F, R))
                print(f"{d:.5f} {d - pen:.6f} F {F:.5f} a {R:.5f}  {steps} steps {its} its {time.time() - start:.0f} s", flush=True)
                if a.out and near:
                    with open(a.out, "w") as out:
                        out.write("# " + " ".join(sys.argv[1:]) + f"; {self.mesh.ne} triangles\n"
                                  "delta_bar,delta_bar_less_penetration,F_bar,a_bar\n")
                        for row in rows: out.write(",".join(f"{v:.7g}" for v in row) + "\n")

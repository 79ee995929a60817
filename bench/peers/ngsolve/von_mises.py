#!/usr/bin/env python3
"""The simple press in NGSolve: triangles of second order with a pressure of first (Taylor-Hood), contact by
penalty on the true sphere, backward Euler. A peer of `platen press`: elements, linearisation, contact
integration and solver are NGSolve's; only the return mapping is written here.

    python3 -m venv v && v/bin/pip install ngsolve numpy scipy
    OMP_NUM_THREADS=1 v/bin/python von_mises.py --E 100 --step 0.04 --h 0.01 --out c4.csv

The flow is of first order in the step: run with --step c and c/2, and extrapolate (extrapolate.py).
F = F_e F_p; logarithmic elastic strain; q <= sigma(eps_p) in Cauchy stress (--kirchhoff: in Kirchhoff stress).
Radius and yield stress are one (for Hollomon: kappa is one).
"""
from quarter import *

p = arguments(__doc__)
p.add_argument("--n", type=float, default=0, help="Hollomon exponent 1/m; 0: perfectly plastic")
p.add_argument("--kirchhoff", action="store_true", help="yield in Kirchhoff stress")
a = p.parse_args()
mesh = mesh_of(a.h, a.grading)
X = H1(mesh, order=a.order, dirichlet="axis") * H1(mesh, order=a.order, dirichlet="equator") * H1(mesh, order=a.order - 1)
press = Press(a, mesh, X, (lambda d: 3 * max(0.05, d ** a.n)) if a.n else (lambda d: 3))
G, K = a.E / (2 * (1 + a.nu)), a.E / (3 * (1 - 2 * a.nu))
state = [press.state(v) for v in (1, 1, 0, 1, 0)]   # Cp^-1: rr, zz, rz, tt; plastic strain
ep = state[4]
sigma = lambda e: e ** a.n                         # Hollomon, over the total strain


def returned(k):
    """Deviator of the logarithmic elastic strain (trial), mean, q (trial), share of it that stays."""
    e, m = logarithm(*k.push(*state[:4]))
    q = 3 * G * equivalent(e)
    Jy = 1 if a.kirchhoff else k.J
    if not a.n: return e, m, q, IfPos(q - Jy, Jy / q, 1)
    # q - 3 G (s - sigma(s)/E - ep) = Jy sigma(s) for the total strain s, by Newton
    sy = (1 / a.E) ** (1 / (1 - a.n))
    c, t = 3 * G / a.E - Jy, ep + q / (3 * G)
    s = IfPos(t - sy, t, sy)
    for _ in range(4):
        s = s - (3 * G * (t - s) + c * sigma(s)) / (-3 * G + c * a.n * sigma(s) / s)
        s = IfPos(s - sy, s, sy)
    s0 = IfPos(t - sy, ep + sy, sy)                # at the old plastic strain: s0 - sigma(s0)/E = ep
    for _ in range(6):
        s0 = s0 - (s0 - sigma(s0) / a.E - ep) / (1 - a.n * sigma(s0) / s0 / a.E)
        s0 = IfPos(s0 - sy, s0, sy)
    return e, m, q, IfPos(q - Jy * sigma(s0), Jy * sigma(s) / q, 1)


(ur, uz, pr), (vr, vz, qr) = X.TnT()
k = Kinematics(ur, uz)
e, m, q, f = returned(k)
l = k.gradient(vr, vz)
press.assemble(2 * G * f * (e[0] * l[0] + e[1] * l[1] + e[2] * l[2] + e[3] * l[3]) + pr * (l[0] + l[1] + l[3])
               + qr * (log(k.J) - pr / K), uz, vz)
k = Kinematics(*press.gf.components[:2])
e, m, q, f = returned(k)
new = k.pull(*exponential(f * e[0] + m / 2, f * e[1] + m / 2, f * e[2], f * e[3] + m / 2)) + [ep + (1 - f) * q / (3 * G)]
new = [c.Compile(a.compile, wait=True) for c in new]
after = [press.state(0) for _ in new]


def commit():
    for part, cf in zip(after, new): part.Interpolate(cf)
    for part, value in zip(state, after): part.vec.data = value.vec


press.run(commit)

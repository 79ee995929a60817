#!/usr/bin/env python3
"""The simple press of a von Mises Double Cap granule in NGSolve: displacements of second order, dilatation and pressure
of first. Moduli and surface are those of the density continued from the last steps, so the flow is of first order in the
step: run with --step c and c/2, and extrapolate.

    OMP_NUM_THREADS=1 v/bin/python vmdc.py --compile --E 100 --Gamma 1 --Lambda 1 --step 0.02 --out v2.csv

Radius and sigma_y are one; the rest is the base case of Edmans & Sinka (catalogue/materials/base-case.toml).
"""
from quarter import *

p = arguments(__doc__)
p.add_argument("--Gamma", type=float, default=1)
p.add_argument("--Lambda", type=float, default=1)
a = p.parse_args()
rho0, epsilon, eta, xi, zeta, omega, xi_1, xi_2 = 0.7, 0.7, 10, 7.5, 10, 10, 0.4, 1.5
mesh = mesh_of(a.h, a.grading)
P1 = H1(mesh, order=a.order - 1)
X = H1(mesh, order=a.order, dirichlet="axis") * H1(mesh, order=a.order, dirichlet="equator") * P1 * P1
press = Press(a, mesh, X, lambda d: 3 + 60 * d * d)
press.gf.components[2].Set(1)                      # theta, v/V
state = [press.state(v) for v in (1, 1, 0, 1, 0)]   # isochoric part of Cp^-1; phi = ln(rho/rho0) of the unloaded material
phi, phi_old, phi_end = state[4], press.state(0), press.state(0)


def least(f, low): return IfPos(f - low, f, low)
def most(f, high): return IfPos(high - f, f, high)


rho = rho0 * exp(phi_end)
D = most(rho, 1) - rho0
E, nu = a.E * exp(xi * D), least(most(a.nu + xi_1 * D, 0.49), 0)
G, K = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))
sy, Gamma, Lambda = exp(eta * D), a.Gamma * exp(zeta * D), a.Lambda * exp(omega * D)
pi_3 = least(sy - least(epsilon + xi_2 * D, 0.05) * Gamma, 0)
b_cap = sy - pi_3


def returned(k, theta):
    """Trial deviator, share of it that stays, elastic volumetric strain: trial, returned."""
    scale = theta / theta * k.J ** (-2 / 3)
    e, _ = logarithm(*[c * scale for c in k.push(*state[:4])])
    w, v = equivalent(e), log(theta) + phi
    p, q = K * v * exp(-v), 3 * G * w * exp(-v)
    s = IfPos(p, 1, -1)
    P, c = IfPos(p, 0, pi_3), IfPos(p, Lambda, b_cap)
    over = least(s * p - P, 0) / c                 # on the plateau: none
    flows = over * over + q * q / (Gamma * Gamma) - 1
    # plateau: pure shear
    w_plateau = Gamma * exp(v) / (3 * G)
    # caps: s p = P + c sin t, q = Gamma cos t; what is left of the strain is along the normal
    t = atan2(over, q / Gamma)
    for _ in range(5):
        sn, cs = sin(t), cos(t)
        x_ = (P + c * sn) / K
        xs = s * x_
        vs = xs * (1 + xs * (1 + xs * (1.5 + xs * 8 / 3)))
        vs_t = c * cs / K * (1 + xs * (2 + xs * (4.5 + xs * 32 / 3)))      # of s vs
        ws = Gamma * cs * exp(vs) / (3 * G)
        ws_t = -Gamma * sn * exp(vs) / (3 * G) + ws * s * vs_t
        g = sn / c * (w - ws) - cs / Gamma * s * (v - vs)
        g_t = cs / c * (w - ws) + sn / Gamma * s * (v - vs) - sn / c * ws_t + cs / Gamma * vs_t
        t = t - g / g_t
        t = least(most(t, math.pi / 2), 0)
    xs = s * (P + c * sin(t)) / K
    v_cap = xs * (1 + xs * (1 + xs * (1.5 + xs * 8 / 3)))
    w_cap = Gamma * cos(t) * exp(v_cap) / (3 * G)
    cap = s * p - P
    v_new = IfPos(flows, IfPos(cap, v_cap, v), v)
    w_new = IfPos(flows, IfPos(cap, w_cap, w_plateau), w)
    return e, w_new / w, v, v_new


(ur, uz, th, pr), (vr, vz, ht, qr) = X.TnT()
k = Kinematics(ur, uz)
e, f, v, vn = returned(k, th)
l = k.gradient(vr, vz)
dev = 2 * G * f * exp(-vn)
press.assemble(th * dev * (e[0] * l[0] + e[1] * l[1] + e[2] * l[2] + e[3] * l[3]) + pr * k.J * (l[0] + l[1] + l[3])
               + ht * (K * vn * exp(-vn) - pr) + qr * (k.J - th), uz, vz)
k = Kinematics(*press.gf.components[:2])
e, f, v, vn = returned(k, press.gf.components[2])
new = k.pull(*exponential(*[f * c for c in e])) + [phi - (v - vn)]
new = [c.Compile(a.compile, wait=True) for c in new]
after = [press.state(0) for _ in new]


def prepare(ratio):
    phi_end.vec.data = phi.vec + min(ratio, 1.5) * (phi.vec - phi_old.vec)


def commit():
    for part, cf in zip(after, new): part.Interpolate(cf)
    phi_old.vec.data = phi.vec
    for part, value in zip(state, after): part.vec.data = value.vec


press.run(commit, prepare)

"""Cases for tests, small and coarse."""

# A column that collapses within a second or stands: 32 points.
COLUMN = """\
[time]
end = 0.4
courant = 0.5
[mesh]
size = [10.0, 3.0]
cell = 1.0
[[body]]
material = "clay"
box = [[0.0, 0.0], [4.0, 2.0]]
points_per_cell = [2, 2]
[material.clay]
model = "tresca_softening"
density = 1900.0
shear_modulus = 1.0e6
poisson_ratio = 0.45
su_peak = 6.0e3
sensitivity = 2.0
eta = 5.0
[forces]
gravity = [0.0, -9.81]
[boundary]
left = "roller"
bottom = "fixed"
"""

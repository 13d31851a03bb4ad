"""Cases for tests, small and coarse."""

# A fill that the second stage digs away while a berm comes, and a stone that leaves through the top at once. Their
# rows are in the order of the bodies; those of a body that is placed later come last.
DUG = """\
[mesh]
size = [4.0, 4.0]
cell = 0.5
[[body]]
material = "soil"
box = [[0.0, 0.0], [4.0, 2.0]]
points_per_cell = 2
[[body]]
name = "fill"
material = "soil"
box = [[1.0, 2.0], [3.0, 3.0]]
points_per_cell = 2
[[body]]
name = "berm"
material = "rock"
box = [[3.0, 2.0], [4.0, 2.5]]
points_per_cell = 2
[[body]]
material = "rock"
box = [[0.0, 3.5], [0.5, 4.0]]
velocity = [0.0, 10.0]
points_per_cell = 2
[material.soil]
model = "linear_elastic"
density = 1800.0
shear_modulus = 5.0e6
poisson_ratio = 0.3
[material.rock]
model = "linear_elastic"
density = 1800.0
shear_modulus = 5.0e6
poisson_ratio = 0.3
[forces]
gravity = [0.0, -9.81]
[boundary]
left = "roller"
right = "roller"
bottom = "fixed"
top = "open"
[[stage]]
name = "before"
duration = 0.1
[[stage]]
name = "dig"
remove = ["fill"]
place = ["berm"]
duration = 0.02
[output]
fields = { every = 0.02 }
"""
GROUND, FILL, STONE, BERM = slice(0, 128), slice(128, 160), slice(160, 164), slice(164, 172)

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

"""One section, and the ways to draw it: the table that dialects.py walks."""
from math import pi

OUTLINES = {
    "sand": [(0, 0), (20, 0), (20, 5), (0, 5)],
    "clay": [(0, 5), (20, 5), (20, 9), (0, 9)],
    "dike": [(3, 9), (17, 9), (11, 13.5), (7, 13.5)],
}
AREAS = {"sand": 100.0, "clay": 80.0, "dike": 40.5}
RELEASES = ("R12", "R2000", "R2010", "R2018")
WAYS = {}


def way(first="R12", insunits=6, options=(), areas=None, refused=None, warned=""):
    """A way to draw, from which release on; its `areas`, or a word of its refusal; a word of its warning."""
    def keep(draw):
        releases = RELEASES[RELEASES.index(first):]
        WAYS[draw.__name__] = (draw, releases, insunits, options, areas or AREAS, refused, warned)
        return draw
    return keep


def outlines(space, scale=1.0):
    for layer, places in OUTLINES.items():
        closed_line(space, [(scale * x, scale * y) for x, y in places], layer)


def closed_line(space, places, layer, bulges=None):
    """A polyline of the release; `bulges`: of the side that begins at each place."""
    add = space.add_polyline2d if space.doc.dxfversion == "AC1009" else space.add_lwpolyline
    places = [(*place, bulge) for place, bulge in zip(places, bulges or [0.0] * len(places))]
    return add(places, format="xyb", close=True, dxfattribs={"layer": layer})


@way()
def closed_outlines(space):
    outlines(space)


@way(insunits=4)
def millimetres(space):
    outlines(space, 1e3)


@way(insunits=2)
def feet(space):
    outlines(space, 1 / 0.3048)


@way(insunits=0, options=("--unit", "ft"))
def feet_by_option(space):
    outlines(space, 1 / 0.3048)


@way()
def old_polylines(space):
    for layer, places in OUTLINES.items():
        space.add_polyline2d(places, close=True, dxfattribs={"layer": layer})


@way()
def polylines_in_space(space):
    for layer, places in OUTLINES.items():
        space.add_polyline3d([(x, y, 0.0) for x, y in places], close=True, dxfattribs={"layer": layer})


@way()
def last_place_is_first(space):
    for layer, places in OUTLINES.items():
        space.add_polyline2d(places + places[:1], dxfattribs={"layer": layer})


@way()
def single_lines(space):
    for layer, places in OUTLINES.items():
        for a, b in zip(places, places[1:] + places[:1]):
            space.add_line(a, b, dxfattribs={"layer": layer})


@way("R2000")
def seen_from_behind(space):
    """The normal 0, 0, -1 of a mirrored outline: x of its own system is -x."""
    for layer, places in OUTLINES.items():
        space.add_lwpolyline([(-x, y) for x, y in places], close=True,
                             dxfattribs={"layer": layer, "extrusion": (0, 0, -1)})


@way()
def lines_seen_from_behind(space):
    """Places of a LINE are those of the world, whatever its normal."""
    for layer, places in OUTLINES.items():
        for a, b in zip(places, places[1:] + places[:1]):
            space.add_line(a, b, dxfattribs={"layer": layer, "extrusion": (0, 0, -1)})


@way("R2000")
def all_at_an_elevation(space):
    for layer, places in OUTLINES.items():
        space.add_lwpolyline(places, close=True, dxfattribs={"layer": layer, "elevation": 7.0})


@way(refused="plane")
def turned_upright(space):
    """The section stands in the plane of x and z."""
    for layer, places in OUTLINES.items():
        space.add_polyline3d([(x, 0.0, y) for x, y in places], close=True, dxfattribs={"layer": layer})


def block_of(space, name="section", scale=1.0, base=(0.0, 0.0)):
    block = space.doc.blocks.new(name, base_point=base)
    outlines(block, scale)
    return block


@way()
def inserted(space):
    block_of(space)
    space.add_blockref("section", (100, 50))


@way()
def inserted_mirrored(space):
    block_of(space, base=(4, 1))
    space.add_blockref("section", (100, 50), dxfattribs={"xscale": -1.0})


@way()
def inserted_from_behind(space):
    block_of(space)
    space.add_blockref("section", (-100, 50), dxfattribs={"extrusion": (0, 0, -1)})


@way(insunits=4)
def inserted_scaled_in_millimetres(space):
    block_of(space)
    space.add_blockref("section", (0, 0), dxfattribs={"xscale": 1e3, "yscale": 1e3, "zscale": 1e3})


@way()
def inserted_in_blocks(space):
    """A block in a block in a block, turned there and back, with mirrors between."""
    block_of(space)
    middle = space.doc.blocks.new("middle")
    middle.add_blockref("section", (1, 2), dxfattribs={"rotation": 90.0, "xscale": 0.5, "yscale": 0.5})
    outer = space.doc.blocks.new("outer")
    outer.add_blockref("middle", (3, 0), dxfattribs={"yscale": -1.0})
    space.add_blockref("outer", (10, 10), dxfattribs={"rotation": 90.0, "xscale": -2.0, "yscale": 2.0})


@way()
def layer_zero_in_a_block(space):
    """Soil on layer 0 of a block takes the layer of its INSERT."""
    for layer, places in OUTLINES.items():
        closed_line(space.doc.blocks.new("b_" + layer), places, "0")
        space.add_blockref("b_" + layer, (0, 0), dxfattribs={"layer": layer})


@way(options=("--layers", "sand,clay,dike"))
def chosen_layers_in_a_block(space):
    """The INSERT itself lies on another layer than those that are chosen."""
    block_of(space)
    closed_line(space, [(-5, -5), (30, -5), (30, 20)], "frame")
    space.add_blockref("section", (0, 0), dxfattribs={"layer": "blocks"})


@way()
def block_on_a_layer_that_is_off(space):
    """What is off is the INSERT's own layer: entities of its block on other layers are drawn."""
    block_of(space)
    space.doc.layers.add("blocks").off()
    space.add_blockref("section", (0, 0), dxfattribs={"layer": "blocks"})


@way()
def layers_hidden(space):
    outlines(space)
    for name, hide in (("rough", "off"), ("old", "freeze")):
        getattr(space.doc.layers.add(name), hide)()
        closed_line(space, [(-3, -3), (25, -3), (25, 15)], name)


@way("R2000")
def layer_not_plotted(space):
    outlines(space)
    space.doc.layers.add("help").dxf.plot = 0
    closed_line(space, [(-3, -3), (25, -3), (25, 15)], "help")


@way()
def points_that_dimensions_leave(space):
    """Layer Defpoints is never plotted."""
    outlines(space)
    space.add_line((-3, 2), (30, 7), dxfattribs={"layer": "Defpoints"})


@way()
def texts_and_marks(space):
    outlines(space)
    space.add_text("clay", dxfattribs={"layer": "notes"})
    space.add_point((3, 3), dxfattribs={"layer": "notes"})
    space.add_circle((5, 5), 1.0, dxfattribs={"layer": "borings"})
    space.add_solid([(0, 0), (1, 0), (0, 1), (1, 1)], dxfattribs={"layer": "marks"})


@way("R2000")
def texts_and_marks_of_later_releases(space):
    outlines(space)
    space.add_mtext("Klei, siltig\\PNAP -1,2 m", dxfattribs={"layer": "notes"})
    space.add_hatch(dxfattribs={"layer": "fill"}).paths.add_polyline_path(OUTLINES["clay"], is_closed=True)
    space.add_linear_dim((0, -2), (0, 0), (20, 0)).render()
    space.add_leader([(3, 3), (6, 6), (9, 6)], dxfattribs={"layer": "notes"})
    space.add_ray((0, 0), (1, 0), dxfattribs={"layer": "help lines"})
    space.add_xline((0, 0), (0, 1), dxfattribs={"layer": "help lines"})
    space.add_wipeout([(0, 0), (1, 1)])


@way("R2000", warned="Hatches were read as outlines")
def hatches_alone(space):
    for layer, places in OUTLINES.items():
        space.add_hatch(dxfattribs={"layer": layer}).paths.add_polyline_path(places, is_closed=True)


@way("R2000", warned="Hatches were read as outlines")
def a_hatch_of_edges_seen_from_behind(space):
    for layer, places in OUTLINES.items():
        path = space.add_hatch(dxfattribs={"layer": layer, "extrusion": (0, 0, -1)}).paths.add_edge_path()
        for a, b in zip(places, places[1:] + places[:1]):
            path.add_line((-a[0], a[1]), (-b[0], b[1]))


@way("R2000", warned="Hatches were read as outlines, where no line bounds soil: sand.")
def a_hatch_of_one_soil(space):
    space.add_hatch(dxfattribs={"layer": "sand"}).paths.add_polyline_path(OUTLINES["sand"], is_closed=True)
    for layer in ("clay", "dike"):
        closed_line(space, OUTLINES[layer], layer)


@way("R2000", areas={"soil " + layer: area for layer, area in AREAS.items()})
def hatches_in_a_block_name_what_lines_enclose(space):
    boundaries(space)
    block = space.doc.blocks.new("fills")
    for layer, places in OUTLINES.items():
        block.add_hatch(dxfattribs={"layer": "soil " + layer}).paths.add_polyline_path(
            [(x + 0.1 * (10 - x), y) for x, y in places], is_closed=True)
    space.add_blockref("fills", (0, 0))


ROUND = {"sand": 100.0, "clay": 80.0, "dike": pi * 16 / 2}


def ground(space):
    for layer in ("sand", "clay"):
        closed_line(space, OUTLINES[layer], layer)


@way(areas=ROUND)
def bent_outline(space):
    ground(space)
    closed_line(space, [(6, 9), (14, 9)], "dike", [0.0, 1.0])


@way("R2000", areas=ROUND)
def bent_outline_from_behind(space):
    ground(space)
    closed_line(space, [(-6, 9), (-14, 9)], "dike", [0.0, -1.0]).dxf.extrusion = (0, 0, -1)


@way("R2000", areas=ROUND, warned="Hatches were read as outlines")
def hatch_with_an_arc(space):
    ground(space)
    path = space.add_hatch(dxfattribs={"layer": "dike"}).paths.add_edge_path()
    path.add_arc((10, 9), 4, 0, 180, ccw=True)
    path.add_line((6, 9), (14, 9))


@way("R2000", areas=ROUND, warned="Hatches were read as outlines")
def hatch_with_an_arc_clockwise(space):
    ground(space)
    path = space.add_hatch(dxfattribs={"layer": "dike"}).paths.add_edge_path()
    path.add_arc((10, 9), 4, 0, 180, ccw=False)
    path.add_line((14, 9), (6, 9))


@way("R2000", areas=ROUND, warned="Hatches were read as outlines")
def hatch_with_a_bulge(space):
    ground(space)
    space.add_hatch(dxfattribs={"layer": "dike"}).paths.add_polyline_path([(6, 9), (14, 9, 1)], is_closed=True)


@way("R2000", areas={"sand": 100.0, "clay": 80.0, "dike": pi * 6 * 2 / 2}, warned="Hatches were read as outlines")
def hatch_with_an_ellipse(space):
    ground(space)
    path = space.add_hatch(dxfattribs={"layer": "dike"}).paths.add_edge_path()
    path.add_ellipse((10, 9), (6, 0), 1 / 3, 0, 180, ccw=True)
    path.add_line((4, 9), (16, 9))


@way("R2000", areas={"sand": 100.0, "clay": 80.0, "dike": 8 * 4.5 * 2 / 3}, warned="Hatches were read as outlines")
def hatch_with_a_spline(space):
    ground(space)
    path = space.add_hatch(dxfattribs={"layer": "dike"}).paths.add_edge_path()
    path.add_spline(control_points=[(6, 9), (10, 18), (14, 9)], degree=2, knot_values=[0, 0, 0, 1, 1, 1])
    path.add_line((14, 9), (6, 9))


@way(areas=ROUND)
def arc_over_lines(space):
    ground(space)
    space.add_line((6, 9), (14, 9), dxfattribs={"layer": "dike"})
    space.add_arc((10, 9), 4, 0, 180, dxfattribs={"layer": "dike"})


@way(areas=ROUND)
def arc_from_behind(space):
    ground(space)
    space.add_line((6, 9), (14, 9), dxfattribs={"layer": "dike"})
    space.add_arc((-10, 9), 4, 0, 180, dxfattribs={"layer": "dike", "extrusion": (0, 0, -1)})


@way("R2000", areas={"sand": 100.0, "clay": 80.0, "dike": pi * 6 * 2 / 2})
def half_ellipse(space):
    ground(space)
    space.add_line((4, 9), (16, 9), dxfattribs={"layer": "dike"})
    space.add_ellipse((10, 9), (6, 0), 1 / 3, 0, pi, dxfattribs={"layer": "dike"})


@way("R2000", areas={"sand": 100.0, "clay": 80.0, "dike": pi * 6 * 2 / 2})
def half_ellipse_from_behind(space):
    """With the normal 0, 0, -1 its angles run the other way."""
    ground(space)
    space.add_line((4, 9), (16, 9), dxfattribs={"layer": "dike"})
    space.add_ellipse((10, 9), (6, 0), 1 / 3, pi, 2 * pi, dxfattribs={"layer": "dike", "extrusion": (0, 0, -1)})


@way("R2000", areas={"sand": 100.0 - 2 * pi, "clay": 80.0, "dike": 40.5, "lens": 2 * pi})
def lens_as_an_ellipse(space):
    outlines(space)
    space.add_ellipse((10, 2.5), (2, 0), 0.5, dxfattribs={"layer": "lens"})


@way("R2000", areas={"sand": 100.0, "clay": 80.0, "dike": 8 * 4.5 * 2 / 3})
def ground_as_a_spline(space):
    """A parabola over 8 m, 4.5 m high: two thirds of its box."""
    ground(space)
    space.add_line((6, 9), (14, 9), dxfattribs={"layer": "dike"})
    space.add_open_spline([(6, 9), (10, 18), (14, 9)], degree=2, dxfattribs={"layer": "dike"})


@way("R2000", areas=ROUND)
def rational_spline(space):
    ground(space)
    space.add_line((6, 9), (14, 9), dxfattribs={"layer": "dike"})
    half = 0.5 ** 0.5
    space.add_rational_spline([(14, 9), (14, 13), (10, 13), (6, 13), (6, 9)], [1, half, 1, half, 1], degree=2,
                              knots=[0, 0, 0, 1, 1, 2, 2, 2], dxfattribs={"layer": "dike"})


@way()
def on_paper_as_well(space):
    outlines(space)
    closed_line(space.doc.layout("Layout1"), [(0, 0), (420, 0), (420, 297), (0, 297)], "frame")


@way()
def drawn_twice(space):
    outlines(space)
    outlines(space)


@way()
def frame_around_all(space):
    outlines(space)
    closed_line(space, [(-10, -10), (40, -10), (40, 30), (-10, 30)], "kader")


@way()
def water_line(space):
    outlines(space)
    space.add_polyline2d([(0, 8), (10, 7.5), (20, 7)], dxfattribs={"layer": "freatische lijn"})


@way()
def open_by_millimetres(space):
    for layer, places in OUTLINES.items():
        (x, y) = places[0]
        space.add_polyline2d(places + [(x + 0.003, y + 0.002)], dxfattribs={"layer": layer})


LAYERED = {"region 1": 40.5, "region 2": 80.0, "region 3": 100.0}
GROUND = [(0, 9), (3, 9), (7, 13.5), (11, 13.5), (17, 9), (20, 9)]


def boundaries(space, sand=((0, 5), (20, 5)), base=((0, 0), (20, 0)), ground=GROUND):
    """Tops of layers from end to end, without lines at the ends."""
    for layer, line in (("ground", ground), ("clay", [(0, 9), (20, 9)]), ("sand", sand), ("base", base)):
        space.add_polyline2d(line, dxfattribs={"layer": layer})


@way(areas=LAYERED)
def boundaries_without_ends(space):
    boundaries(space)


@way(areas=LAYERED)
def a_boundary_beyond_the_ends(space):
    boundaries(space, sand=[(-1, 5), (21, 5)])


@way(areas={"region 1": 40.5, "region 2": 80.0})
def a_base_drawn_twice(space):
    boundaries(space, base=[(0, 5), (20, 5)])


@way(areas={"dike": 40.5, "region 2": 80.0, "region 3": 100.0})
def boundaries_below_an_outline(space):
    boundaries(space, ground=[(0, 9), (20, 9)])
    closed_line(space, OUTLINES["dike"], "dike")


@way(areas=LAYERED)
def a_level_beside_boundaries(space):
    boundaries(space)
    for level, layer in ((11, "MHW"), (10, "laagwater"), (12, "waterlaag")):
        space.add_line((-5, level), (5, level), dxfattribs={"layer": layer})


@way(areas={"region 1": 40.5, "region 2": 80.0, "region 3": 99.0, "lens": 1.0})
def a_lens_in_boundaries(space):
    boundaries(space)
    closed_line(space, [(5, 2), (7, 2), (7, 2.5), (5, 2.5)], "lens")


@way(areas=LAYERED, warned="frame bound no soil: kader")
def a_frame_around_boundaries(space):
    boundaries(space)
    closed_line(space, [(-10, -10), (40, -10), (40, 30), (-10, 30)], "kader")


@way(areas=LAYERED)
def a_border_named_by_the_water_above(space):
    boundaries(space)
    for line in space.query('*[layer=="sand"]'):
        line.dxf.layer = "klei onder water"


@way(areas={"sand": 180.0, "dike": 40.5}, warned="no soil: border. Those within")
def a_border_short_at_both_ends(space):
    closed_line(space, [(0, 0), (20, 0), (20, 9), (0, 9)], "sand")
    closed_line(space, OUTLINES["dike"], "dike")
    space.add_line((0.5, 5), (19.5, 5), dxfattribs={"layer": "border"})


@way(warned="not in the drawing were left out: lost on 0")
def a_block_that_is_not_there(space):
    outlines(space)
    space.add_blockref("lost", (0, 0))


@way("R2000", warned="splines have fit points alone", areas={"sand": 100.0, "clay": 80.0, "dike": 0.5 * 8 * 4})
def a_spline_of_fit_points(space):
    ground(space)
    space.add_line((6, 9), (14, 9), dxfattribs={"layer": "dike"})
    space.add_spline([(6, 9), (10, 13), (14, 9)], dxfattribs={"layer": "dike"})


@way(areas={"region 1": 40.5, "region 2": 180.0}, warned="19.60 m on sand")
def a_boundary_that_ends_too_early(space):
    boundaries(space, sand=[(0.2, 5), (19.8, 5)])


@way("R2000")
def letters_of_a_code_page(space):
    outlines(space)
    space.add_text("hoogte \N{DEGREE SIGN} \N{LATIN SMALL LETTER E WITH DIAERESIS}", dxfattribs={"layer": "België"})


@way(refused="3DFACE")
def faces(space):
    """Soil as 3DFACE, as programs of finite elements write their elements."""
    for layer, places in OUTLINES.items():
        space.add_3dface(places, dxfattribs={"layer": layer})

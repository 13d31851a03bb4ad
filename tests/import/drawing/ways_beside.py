"""Ways to draw the section of ways.py beside others, in a frame, or with lines that miss each other."""
from ways import LAYERED, OUTLINES, boundaries, closed_line, outlines, way


def moved(space, draw, dx, dy):
    """What `draw` draws, at another place of the drawing."""
    block = space.doc.blocks.new(f"{draw.__name__} {dx} {dy}")
    draw(block)
    space.add_blockref(block.name, (dx, dy))


@way(refused="--window 39.9,-0.1,60.1,13.6")
def two_sections_beside_each_other(space):
    moved(space, boundaries, 0, 0)
    moved(space, boundaries, 40, 0)


@way(refused="--window -0.1,29.9,20.1,43.6")
def two_sections_above_each_other(space):
    moved(space, boundaries, 0, 0)
    moved(space, boundaries, 0, 30)


@way(refused="holds 3 sections")
def three_sections_of_outlines(space):
    for place in ((0, 0), (40, 0), (0, 40)):
        moved(space, outlines, *place)


@way(areas=LAYERED, options=("--window", "35,-5,65,20"),
     warned="Lines that reach out of the window were left out: on axis")
def one_of_two_sections(space):
    moved(space, boundaries, 0, 0)
    moved(space, boundaries, 40, 0)
    space.add_line((-5, 4), (70, 4), dxfattribs={"layer": "axis"})


@way(warned="frame bound no soil: kader, title block")
def a_frame_on_the_edge_of_the_section(space):
    outlines(space)
    closed_line(space, [(0, 0), (30, 0), (30, 20), (0, 20)], "kader")
    closed_line(space, [(20, 0), (30, 0), (30, 4), (20, 4)], "title block")


@way(refused="A frame: --layers 'clay,dike,sand'. Soil: --layers '0,clay,dike,sand'.")
def a_frame_without_a_name_on_the_edge(space):
    outlines(space)
    closed_line(space, [(0, 0), (30, 0), (30, 20), (0, 20)], "0")


@way(options=("--layers", "clay, dike,  sand"))
def layers_with_blanks_between(space):
    outlines(space)
    closed_line(space, [(0, 0), (30, 0), (30, 20), (0, 20)], "0")


@way(options=("--layers", "clay,veen"), refused="Layers of it: clay, dike, sand.")
def a_layer_that_is_not_there(space):
    outlines(space)


@way(areas={"sand": 100.0, "peat": 80.0, "dike": 40.5}, warned="clay and peat at 0.00, 5.00 m: peat counts")
def two_soils_in_one_place(space):
    outlines(space)
    closed_line(space, OUTLINES["clay"], "peat")


@way(areas={"sand": 100.0, "clay": 80.0}, warned="3 ends of lines miss others: by 0.050 m at 0.000, 0.050 m (sand), by")
def open_by_centimetres(space):
    for layer, places in OUTLINES.items():
        (x, y) = places[0]
        space.add_polyline2d(places + [(x, y + 0.05)], dxfattribs={"layer": layer})


@way()
def borders_that_miss_by_millimetres(space):
    for layer, places, up in (("sand", OUTLINES["sand"], 0), ("clay", OUTLINES["clay"], 0.009),
                              ("dike", OUTLINES["dike"], 0.018)):
        closed_line(space, [(x, y + up) for x, y in places], layer)


@way()
def borders_that_overlap_by_millimetres(space):
    for layer, places, up in (("sand", OUTLINES["sand"], 0), ("clay", OUTLINES["clay"], -0.008),
                              ("dike", OUTLINES["dike"], -0.017)):
        closed_line(space, [(x, y + up) for x, y in places], layer)

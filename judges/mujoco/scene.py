"""The scene that MuJoCo simulates: a free platform, and cables as spatial tendons over points or over swivelling pulleys."""

import numpy

# Length of straight cable before D (m): the tendon starts on the swivel axis in front of the pulley, not on its rim.
LEAD_IN = 1.0


def cross_section(cable):
    """The pulley's axes at swivel angle 0: x is the reference across the swivel axis, y completes it."""
    axis = numpy.array(cable["swivel_axis"])
    reference = numpy.array(cable["reference"])
    side = numpy.cross(axis, reference)
    side /= numpy.linalg.norm(side)
    return numpy.cross(side, axis), side


def numbers(values):
    return " ".join(repr(float(value)) for value in values)


def pulley_body(index, cable):
    """A body on a hinge about the swivel axis: its cylinder touches the axis at D, the side site lies beyond its top.

    MuJoCo wraps a tendon by half a turn at most. Longer arcs are judged by a second tendon, which comes to the rim a quarter
    of a turn later, at the top.
    """
    x, y = cross_section(cable)
    radius = cable["radius"]
    return f"""
    <body name="pulley{index}" pos="{numbers(cable['frame_anchor'])}" xyaxes="{numbers([*x, *y])}">
      <joint name="swivel{index}" type="hinge" axis="0 0 1" damping="20"/>
      <inertial pos="{radius!r} 0 0" mass="0.5" diaginertia="0.01 0.01 0.01"/>
      <geom name="rim{index}" type="cylinder" size="{radius!r} 0.01" pos="{radius!r} 0 0" euler="90 0 0" mass="0" contype="0" conaffinity="0"/>
      <site name="start{index}" pos="0 0 {-LEAD_IN!r}"/>
      <site name="side{index}" pos="{radius!r} 0 {4 * radius!r}"/>
      <site name="late_start{index}" pos="{radius - LEAD_IN!r} 0 {radius!r}"/>
      <site name="late_side{index}" pos="{5 * radius!r} 0 0"/>
    </body>"""


def tendon(index, cable, rest_length=None, damping=0.0, late=""):
    lead_in, wrap = 0.0, ""
    if cable["radius"] is not None:
        lead_in, wrap = LEAD_IN, f'<geom geom="rim{index}" sidesite="{late}side{index}"/>'
    spring = ""
    if rest_length is not None:
        stiffness = cable["stiffness"] / rest_length
        spring = f'springlength="0 {rest_length + lead_in!r}" stiffness="{stiffness!r}" damping="{damping!r}"'
    sites = f'<site site="{late}start{index}"/>{wrap}<site site="anchor{index}"/>'
    return f'<spatial name="{late}cable{index}" {spring}>{sites}</spatial>'


def scene(cables, rest_lengths=None, mass=1.0, center_of_mass=(0, 0, 0), gravity=(0, 0, 0), damping=0.0):
    """MJCF text; without rest lengths the tendons have no force."""
    rest_lengths = rest_lengths or [None] * len(cables)
    starts = "".join(
        f'<site name="start{index}" pos="{numbers(cable["frame_anchor"])}"/>'
        if cable["radius"] is None
        else pulley_body(index, cable)
        for index, cable in enumerate(cables)
    )
    anchors = "".join(
        f'<site name="anchor{index}" pos="{numbers(cable["platform_anchor"])}"/>' for index, cable in enumerate(cables)
    )
    tendons = "".join(
        tendon(index, cable, rest, damping) for index, (cable, rest) in enumerate(zip(cables, rest_lengths))
    )
    # without a force, after those that have one
    tendons += "".join(
        tendon(index, cable, late="late_") for index, cable in enumerate(cables) if cable["radius"] is not None
    )
    inertia = 0.4 * mass
    return f"""
<mujoco>
  <option gravity="{numbers(gravity)}" timestep="0.001" integrator="implicit"/>
  <worldbody>{starts}
    <body name="platform"><freejoint name="platform"/>
      <inertial pos="{numbers(center_of_mass)}" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
      {anchors}
    </body>
  </worldbody>
  <tendon>{tendons}</tendon>
</mujoco>"""

# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The keys of a scene with their types, by tables. `./dev docs` writes this file from what the program knows."""

from __future__ import annotations

from repose.keys import Keys


class ContactNormalKeys(Keys):
    """Keys under contact.normal."""

    law: str  # normal force; default "continuous"
    exponent: float  # n of F = m g (s/r)^(n+1); default 36
    cutoff: float  # [diameters] r0: the force acts below this distance; at 1, grains touch; default 1.2
    damping: float  # fraction of the critical damping of a grain against a fixed one; default 0.5
    restitution: float  # speed after a head-on impact over speed before, for all sizes and partners
    viscosity: float  # [1/T] dashpot coefficient over reduced mass
    attraction: bool  # whether the dashpot may make the force attractive; default false
    stiffness: float  # [M/T^2] spring constant k; default 500 m g/d
    impact_speed: float  # [L/T] speed of the impact that has this restitution; default sqrt(2 g d)


class ContactTangentialKeys(Keys):
    """Keys under contact.tangential."""

    law: str  # tangential force; default "cumulative"
    alpha: float  # largest slip displacement over friction times normal engagement; default 1.214
    stiffness: float  # [M/T^2] spring constant k_t
    damping: float  # fraction of critical damping; default 0
    ratio: float  # tangential over normal stiffness: 2 (1 - nu) / (2 - nu), nu Poisson's ratio; follows from poisson...
    rate: float  # [1/T] tangential force over reduced mass and slip velocity
    dynamic_friction: float  # friction of contacts that slide at weakening_velocity or faster
    weakening_velocity: float  # [L/T] slip at which friction has fallen to dynamic_friction, linearly


class ContactRollingKeys(Keys):
    """Keys under contact.rolling."""

    law: str  # resistance to rolling; default "none"
    friction: float  # mu_r: the torque is at most mu_r R N
    stiffness: float  # [M/T^2] torque over R per rolled length; default 100 m g/d
    damping: float  # fraction of critical damping; default 0.3
    rate: float  # [1/T] torque over R, reduced mass and rolling velocity
    full_at: float  # [L/T] rolling velocity above which the torque is complete; it grows linearly up to there; defau...


class ContactCohesionKeys(Keys):
    """Keys under contact.cohesion."""

    law: str  # attraction; default "none"
    force: float  # [M L/T^2] attraction between touching grains
    surface_energy: float  # [M/T^2] work of adhesion w of both surfaces: the pull-off force is 3/2 pi w R*


class ContactTwistingKeys(Keys):
    """Keys under contact.twisting."""

    law: str  # resistance to twisting, the relative spin about the normal; default "none"
    friction: float  # mu_t: the torque about the normal is at most mu_t R N
    stiffness: float  # [M/T^2] torque over R per twisted length, R times the angle; default 100 m g/d
    damping: float  # fraction of critical damping; default 0.3
    rate: float  # [1/T] torque over R, reduced mass and twisting velocity
    full_at: float  # [L/T] twisting velocity above which the torque is complete; it grows linearly up to there; defa...


class GrainsKeys(Keys):
    """Keys under grains."""

    diameter: float  # [L] d: of the largest grains and of base grains; default 1; must be given in SI
    mass: float  # [M] m: of a grain of that diameter; default 1
    polydispersity: float  # p: diameters uniform in [(1 - p) d, d]; default 0
    shares: str  # whether species.share is a fraction of the number or of the mass of the grains; default "number"


class MethodKeys(Keys):
    """Keys under method."""

    kind: str  # how the grains are moved; default "soft"
    time_step: float | str  # [T] "auto": half a radian of the stiffest contact, and with which a dense bed comes to ...
    velocities: str  # velocities in forces: of the half step, or predicted for the full one (auto: for size ratios a...
    skin: float  # [L] extra reach of the pair list; changes speed, never results beyond rounding; default 0.3 d
    local_damping: float  # Cundall's: a net force is weaker by this fraction where it speeds a grain up, stronger wh...
    viscous_damping: float  # [1/T] a force of minus this times mass and velocity on every grain, and a torque alike;...
    critical_angle: float  # [deg] theta_c as a law of contacts: rolling friction tan(theta_c), infinite at 90, and n...
    speed_limit: float | str  # [L/T] no grain is faster before it meets others; "auto": g dt for a sequential source...
    solver: str  # conjugate residuals over symmetric sweeps of nonlinear Gauss-Seidel, or the sweeps alone; default ...
    tolerance: float  # [g dt] largest residual velocity of a contact; the true residual, computed apart from the sol...
    most_sweeps: int  # sweeps forward and backward before a step is given up; default 2000
    unconverged: str  # steps that are given up are counted and reported, or stop the run; default "warn"
    warm_start: str  # contacts that start from their impulses of the step before: all; those of grains slower than 0...
    overlap_recovery: float  # fraction of an overlap that a step takes back; default 0.05
    arithmetic: str  # snapped: places are multiples of 2^-40 radii, so that rounding cannot grow from layer to layer...
    stiffness: float | str  # [M/T^2] of soft contacts between grains, and with walls; default "auto"
    damping: float | str  # [M/T] of soft contacts, along the normal; default "auto"
    slip_drag: float | str  # [M/T] sliding friction of soft contacts: force over slip speed, at most contact.rolling...
    static_friction: float  # of soft contacts with walls: largest horizontal force of the well over the normal force...
    well_width: float  # [L] displacement at which the well of static friction at a wall breaks; default 0.001 d
    gravity_ramp: float  # [T] gravity rises from 0 over this time, so that a pile built in place does not fall into ...
    pin_base: bool  # grains that stand on a wall at the start keep their x while soft; default false
    relax: bool  # grains that touch at the start are brought to equilibrium before time begins; default false
    relaxation: float  # fraction of Newton's step that a sweep takes; default 0.8


class ContactKeys(Keys):
    """Keys under contact."""

    friction: float  # Coulomb coefficient mu; default 0.5
    normal: ContactNormalKeys
    tangential: ContactTangentialKeys
    rolling: ContactRollingKeys
    cohesion: ContactCohesionKeys
    twisting: ContactTwistingKeys
    restitution: float  # normal velocity after an impact over that before; default 0
    tangential_restitution: float  # the same for the tangential velocity, as far as friction allows; default 0
    rolling_friction: float  # tan(theta_r): torque over normal force and roll radius 2 r_i r_j/(r_i + r_j) at most; ...
    weakening_velocity: float  # [L/T] slip at which friction has fallen to dynamic_friction, linearly; 0: it does no...
    twisting_friction: float  # torque about the normal over normal force and roll radius at most; inf: no twisting; ...
    dynamic_friction: float  # friction of contacts that slide at weakening_velocity or faster


class BaseKeys(Keys):
    """Keys under base."""

    kind: str  # what the grains rest on, at height 0; default "none"
    spacing: float  # [L] distance between the centres, one of them at x = y = 0; default d
    radius: float  # [L] centres lie within this of the middle
    disorder: float  # [L] each is displaced along x and along y by up to this, at random; default 0
    roughness: float  # [L] centres lie at random between this below height 0 and 0; default 0
    half_width: float  # [L] the row covers +- this
    material: str  # its material, for the laws of the pair; default the first material
    count: int  # width of base and box in diameters; default 32
    smooth: bool  # no friction, and the height of the centre as distance (Baxter et al. 1997); default false


class BoxKeys(Keys):
    """Keys under box."""

    x: str  # its sides; grains that leave an open box are lost and counted; default "open"; "periodic" over a contig...
    half_width: float  # [L] x from -half_width to half_width; default base.half_width or base.radius, or 200 d witho...
    floor: float | str  # [L] grains that fall below are lost and counted; "auto": 5 diameters below base grains, els...
    y: str  # its sides along y; default as box.x
    half_depth: float  # [L] y from -half_depth to half_depth; default box.half_width


class StartKeys(Keys):
    """Keys under start."""

    from_: str  # grains at the start: a run folder whose end it is, or a file of grains; relative to this file; defa...
    flip: str  # axis whose sign changes, after the scaling; default "none"
    shift: list[float]  # [L] is added to places, after scaling and flip; default [0, 0, 0]
    step: int  # of the snapshot of a file with several to start from; -1: the last; default -1
    at_rest: bool  # they start without motion; default false
    plane: str  # of a file in three dimensions: its first axis points to the right, its second up; default "xy"
    tolerance: float  # [L] grains may lie so far apart across the plane; default 1e-6 d
    scale: float  # lengths and velocities of the file are multiplied by this; default 1
    fixed_types: list[float]  # grains of these types (or materials, as the file numbers them) are fixed; default []


class SourceKeys(Keys):
    """Keys under source."""

    kind: str  # where grains come from; default "none"
    opening: str  # level area of the releases; default "disc"
    radius: float  # [L] of the disc; default 3 d
    y: float  # [L] centre of the opening; default 0
    velocity: list[float]  # [L/T] velocity at release; default [0, 0, 0]
    half_depth: float  # [L] grains are released at y +- this; default source.half_width
    structure: str  # face-centred cubic on square layers, hexagonal close-packed, or simple cubic; default "fcc"
    shape: str  # of the crystal; a pyramid is of structure fcc; default "block"
    columns: int  # spheres along x in the lowest layer
    rows: int  # spheres along y in the lowest layer
    layers: int  # layers one above the other
    gap: float  # [L] gap between spheres of the largest size; default 0
    jitter: float  # each sphere is displaced by up to this times half the gap, so that none touch; default 0
    x: float  # [L] middle of the crystal; default 0
    count: int  # grains released in all
    rate: float  # [1/T] grains per time; the first at time 0
    height: float  # [L] height of the centres at release; default 100 d
    height_above: str  # the height is above height 0, or at each release above the highest of the discs that touch s...
    half_width: float  # [L] grains are released at x +- this; default 3 d
    base_count: int  # grains in the lowest row of a pile of any slope, instead of source.rows; default 0
    slope: float  # [deg] slope of the flanks of the pile, of a tent from the foot to the break; default 60
    upper_slope: float  # [deg] slope of a tent from the break to the apex; default source.slope
    break_at: float  # distance of the break from the nearer foot, over the length of the base between its corner cen...
    fixed_base: bool  # the fixed grains of the base are the lowest row of the pile; else that row lies in their holl...
    rest: float  # [g dt] all are at rest when no velocity and no rim velocity is above this; default 0.005


class StopKeys(Keys):
    """Keys under stop."""

    at_rest: float  # ends the run after the last grain, load and wall have come, opened or begun to move, once kinet...
    time: float  # [T] ends the run at this time; default none


class OutputKeys(Keys):
    """Keys under output."""

    series: float  # [T] interval between rows of the time series; default sqrt(d/g); 1 without gravity
    frames: float  # [T] interval between saved frames; 0: none; default 100 sqrt(d/g); 100 without gravity
    window: float  # [T] interval at the end over which base forces are averaged; default 10 sqrt(d/g); 10 without gr...
    slices: int  # slices of equal disc area in which the time series follows a column between two upright walls; def...
    track: float  # [T] interval between moments at which the place of every grain is kept, for avalanches; 0: none; ...
    checkpoint: float  # [s of wall time] interval between checkpoints, from which a run resumes after a crash; 0: on...
    energy: bool  # keep the energy budget in a series of its own; a slower kernel, which gives the same bits; defaul...


class AnalysisKeys(Keys):
    """Keys under analysis."""

    bin_width: float  # [L] bin width of the surface profile; default 2 d
    force_scale: str  # force unit of `analysis.force_threshold` and `analysis.burst`; default "weight"; "mean" witho...
    force_threshold: float  # [force units] contacts with a smaller force do not count; default 0.2
    base_bin: float  # [L] bin width of the base profile; default 5 d
    field_width: float  # [L] standard deviation of the Gaussian that smooths stress and density; default 1.5 d
    core_depth: float  # [L] depth below the surface at which the core of a heap begins; default 4 d
    moved: float  # [L] a grain that is displaced farther between two moments of the track has moved; default 0.5 d
    avalanche: int  # grains that move at once in an avalanche; default 10
    slips: bool  # find the slips of a driven wall whenever the run is analysed, as `repose analyse --slips` does onc...
    burst: float  # [force units times diameters] kinetic energy of the heap above which a burst is counted; default 5
    packing: bool  # measure the packing in a slab: solid fraction, contacts, fabric; default true in a periodic box
    base_cell: float  # [L] side of the square cells, the sensors, in which the forces on the base are measured; defa...
    correlations: bool  # pair correlation g(r); default false
    force: float  # [M L/T^2] the force unit
    slab: list[float]  # edges of the slab above the base centres, or above height 0 without base grains, in mean hei...
    contact_gap: float  # [diameters] grains closer than this touch; default 1e-09
    direction_bins: int  # bins of contact directions, over 180 degrees; default 36
    structure_factor: bool  # structure factor S(q); default false
    local_density: bool  # local density by Voronoi cells; default false


class SceneKeys(Keys):
    """Keys of a scene."""

    title: str  # title of the scene; default ""
    units: str  # reduced: grain diameter, grain mass, gravity = 1; SI: m, kg, s; default "reduced"
    dimension: int  # 2: discs in a plane, y upwards; 3: spheres, z upwards; default 2
    seed: int  # seed of everything random; default 1
    gravity: float  # [L/T^2] gravity; default 1; 9.81 in SI
    gravity_direction: list[float]  # of gravity, of any length; heights are measured along the last axis all the sam...
    grains: GrainsKeys
    method: MethodKeys
    contact: ContactKeys
    base: BaseKeys
    box: BoxKeys
    start: StartKeys
    source: SourceKeys
    stop: StopKeys
    output: OutputKeys
    analysis: AnalysisKeys
    material: list[dict[str, object]]  # [[material]]; Scene.add appends
    pair: list[dict[str, object]]  # [[pair]]; Scene.add appends
    species: list[dict[str, object]]  # [[species]]; Scene.add appends
    plane: list[dict[str, object]]  # [[plane]]; Scene.add appends
    wall: list[dict[str, object]]  # [[wall]]; Scene.add appends
    drum: list[dict[str, object]]  # [[drum]]; Scene.add appends
    load: list[dict[str, object]]  # [[load]]; Scene.add appends
    grain: list[dict[str, object]]  # [[grain]]; Scene.add appends

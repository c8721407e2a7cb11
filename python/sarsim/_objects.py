"""The objects of scenes. Written by tools/python-sources from the table of fields of the library."""

# flake8: noqa: E501

from __future__ import annotations

from ._fields import CheckField, ChoiceField, ChoiceOrNumberField, NumberField, Part, PartField, PointsField, TextField, VectorField, WholeField
from .scene import LoneObject, SceneObject


class Platform(SceneObject):
    """A frame that carries targets and radars."""

    __slots__ = ()
    _kind = "platform"

    name = TextField("name", "", "Targets, surfaces and radars refer to the platform by this name.")
    parent = TextField(
        "parent",
        "",
        "The platform on which this one is mounted: path, rotation and errors are then in its frame, as of a rotor on a fuselage.",
    )
    path = ChoiceField(
        "path",
        {"stationary": "Stationary", "points": "Trajectory", "ephemeris": "Orbit file", "orbit": "Orbit", "state": "Orbit by state", "legs": "Legs", "waypoints": "Waypoints", "relative": "Relative"},
        "Whether the platform stays where it is or follows a path. One of \"stationary\" (the platform stays where it is), \"points\" (the platform follows a path), \"ephemeris\" (states from a file), \"orbit\" (an ellipse round the Earth, turned by J2), \"state\" (from a position and a velocity, under gravity with J2), \"legs\" (straight pieces, turns and climbs), \"waypoints\" (a route through points), \"relative\" (beside another platform).",
    )
    position = VectorField(
        "position",
        "m",
        "Position of the platform's origin in world coordinates. Only where path is stationary.",
    )
    trajectory = PointsField(
        "trajectory",
        "",
        "World x, y and z against time. Speeds are its derivative. Only where path is points.",
    )
    ephemeris_file = TextField(
        "ephemeris_file",
        "",
        "Sentinel-1 EOF, CCSDS OEM, SP3, a table t, x, y, z, or mean elements as TLE or OMM. Only the table works over a flat world. Only where path is ephemeris.",
    )
    satellite = TextField(
        "satellite",
        "",
        "Which satellite of the file: its name, catalogue number or mark. Only where path is ephemeris.",
    )
    interpolation = ChoiceField(
        "interpolation",
        {"automatic": "Automatic", "hermite": "Hermite", "lagrange": "Lagrange", "cubic": "Cubic"},
        "Polynomial through neighbouring states; with states every 10 s of a low orbit the error is below 1e-8 m but for cubic, which is off by 0.3 mm. One of \"automatic\" (degree 7 where there are velocities), \"hermite\" (4 positions and velocities, degree 7), \"lagrange\" (8 positions, degree 7), \"cubic\" (2 positions and velocities, degree 3). Only where path is ephemeris.",
    )
    semi_major_axis = NumberField(
        "semi_major_axis",
        "m",
        "Mean element at time 0; its secular changes are those of J2. Takes 6400000 to 500000 km. Only where path is orbit.",
    )
    eccentricity = NumberField("eccentricity", "", "Mean element at time 0. Takes 0 to 0.99. Only where path is orbit.")
    inclination = NumberField(
        "inclination",
        "deg",
        "Angle between orbit and equator; above 90 degrees it is retrograde. Takes 0 to 180 deg. Only where path is orbit.",
    )
    node_longitude = NumberField(
        "node_longitude",
        "deg",
        "Longitude under the ascending node at time 0. Takes -360 to 360 deg. Only where path is orbit.",
    )
    perigee = NumberField(
        "perigee",
        "deg",
        "Angle from the ascending node to the perigee. Takes -360 to 360 deg. Only where path is orbit.",
    )
    anomaly = NumberField(
        "anomaly",
        "deg",
        "At time 0; on a circular orbit the angle from the perigee. Takes -360 to 360 deg. Only where path is orbit.",
    )
    state_position = VectorField(
        "state_position",
        "m",
        "At time 0 from the centre of the Earth, z to the north pole, x to longitude 0 (ECEF, ITRF). Takes -1000000000 to 1000000 km. Only where path is state.",
    )
    state_velocity = VectorField(
        "state_velocity",
        "m/s",
        "At time 0 over the turning Earth, in the axes of the position; it goes on under gravity with J2. Takes -100000 to 100000 m/s. Only where path is state.",
    )
    start = VectorField("start", "m", "Where the first leg begins. Only where path is legs.")
    course = NumberField(
        "course",
        "deg",
        "Azimuth of the first leg: clockwise from the y axis. Only where path is legs.",
    )
    legs = TextField(
        "legs",
        "",
        "Straight legs, turns and climbs in sequence; straight on before and after them. Only where path is legs.",
    )
    waypoints = TextField(
        "waypoints",
        "",
        "Points of a route, joined by straight lines that arcs round off. Only where path is waypoints.",
    )
    bank = NumberField(
        "bank",
        "deg",
        "Bank angle of the turns at waypoints, of radius v^2/(g tan bank). Takes 0 to 89 deg. Only where path is waypoints.",
    )
    acceleration_mps2 = NumberField(
        "acceleration_mps2",
        "m/s2",
        "Between the speeds of successive waypoints; 0: the speed steps. Takes 0 or more. Only where path is waypoints.",
    )
    speed = NumberField(
        "speed",
        "m/s",
        "Level speed at the start. Takes 0 or more. Only where path is legs or waypoints.",
    )
    start_s = NumberField("start", "s", "When the platform is at the start. Only where path is legs or waypoints.")
    leader = TextField(
        "leader",
        "",
        "The platform with which this one flies in formation. Only where path is relative.",
    )
    offset = VectorField(
        "offset",
        "m",
        "Along the leader's level heading, to the left of it, and up. Only where path is relative.",
    )
    delay = NumberField("delay", "s", "Time by which the platform trails the leader. Only where path is relative.")
    rotation_kind = ChoiceField(
        "rotation_kind",
        {"fixed": "Fixed", "points": "User-defined", "coordinated": "Coordinated", "zero-doppler": "Zero Doppler", "nadir": "Nadir", "look-at": "Look at", "quaternions": "Quaternions"},
        "Whether the rotation is given by angles or by functions of time. A rate is added to either. One of \"fixed\" (rotation given by angles and rates), \"points\" (rotation given by functions of time), \"coordinated\" (along the path, banked in turns), \"zero-doppler\" (x axis along the velocity over the turning Earth, z up as far as that allows), \"nadir\" (z axis away from the Earth's centre), \"look-at\" (z axis away from a point), \"quaternions\" (attitude from a file).",
    )
    rotation = VectorField(
        "rotation",
        "deg",
        "Rotation about each axis, clockwise seen against it, from its tip: positive z turns +x towards -y; roll about x first, then y, then z. Added to the roll, pitch and yaw of coordinated flight; with the other kinds it is added to their rotation. Only where rotation_kind is fixed or coordinated or zero-doppler or nadir or look-at or quaternions.",
    )
    rotation_deg = PointsField(
        "rotation",
        "",
        "Rotation about x, y and z in degrees against time. Only where rotation_kind is points.",
    )
    attack = NumberField(
        "attack",
        "deg",
        "Angle of the x axis above the path. Takes -90 to 90 deg. Only where rotation_kind is coordinated.",
    )
    look_at = VectorField(
        "look_at",
        "m",
        "The z axis points away from it, the x axis as far ahead as that allows. Only where rotation_kind is look-at.",
    )
    flight = ChoiceField(
        "flight",
        {"ground": "Ground track", "inertial": "Inertial"},
        "Which velocity the x axis follows. One of \"ground\" (the velocity over the turning Earth), \"inertial\" (the velocity that stars see). Only where rotation_kind is nadir.",
    )
    attitude_file = TextField(
        "attitude_file",
        "",
        "CCSDS AEM with quaternions. Only where rotation_kind is quaternions.",
    )
    aligned = CheckField(
        "aligned",
        "",
        "Turns the platform so that its x axis points along the velocity; the y axis stays parallel to the world's x-y plane. Only where path is points or ephemeris or orbit or state or legs or waypoints or relative.",
    )
    rotation_rate = VectorField("rotation_rate", "deg/s", "Added to the rotation as rate times time.")
    position_error = ChoiceField(
        "position_error",
        {"gaussian": "Standard deviation", "envelope": "User-defined", "gusts": "Gusts"},
        "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope. One of \"gaussian\" (position errors drawn anew for each pulse), \"envelope\" (position errors of a given correlation), \"gusts\" (an aircraft in turbulence).",
    )
    position_stddev = VectorField(
        "position_stddev",
        "m",
        "Standard deviation of the Gaussian error of each pulse's position; 0 for none. Takes 0 or more. Only where position_error is gaussian.",
    )
    position_envelope = PointsField(
        "position_envelope",
        "",
        "White noise is integrated with this weight against the time before now. No points: no error. Only where position_error is envelope.",
    )
    turbulence = ChoiceField(
        "turbulence",
        {"light": "Light", "moderate": "Moderate", "severe": "Severe"},
        "Dryden turbulence of MIL-F-8785C. One of \"light\" (15 kn of wind at 20 ft), \"moderate\" (30 kn), \"severe\" (45 kn). Only where position_error is gusts.",
    )
    gust_height = NumberField(
        "gust_height",
        "m",
        "Scale lengths and strength of the gusts depend on it. Takes 0 to 20 km. Only where position_error is gusts.",
    )
    airspeed = NumberField(
        "airspeed",
        "m/s",
        "Airspeed through the gusts. Takes 1 to 1000 m/s. Only where position_error is gusts.",
    )
    response = NumberField(
        "response",
        "s",
        "Time constant with which the aircraft follows a gust: 2 (W/S)/(rho g V C_La). Takes 0.001 to 1000 s. Only where position_error is gusts.",
    )
    hold = NumberField(
        "hold",
        "s",
        "Period of the control loop that returns the aircraft to its path. Takes 0.1 to 10000 s. Only where position_error is gusts.",
    )
    hold_damping = NumberField(
        "hold_damping",
        "",
        "Fraction of critical damping. Takes 0.05 to 10. Only where position_error is gusts.",
    )
    rotation_error = ChoiceField(
        "rotation_error",
        {"gaussian": "Standard deviation", "envelope": "User-defined"},
        "Gaussian errors drawn anew for each pulse, or noise smoothed by an envelope. One of \"gaussian\" (rotation errors drawn anew for each pulse), \"envelope\" (rotation errors of a given correlation).",
    )
    rotation_stddev = VectorField(
        "rotation_stddev",
        "deg",
        "Standard deviation of the Gaussian error of each pulse's rotation; 0 for none. Takes 0 or more. Only where rotation_error is gaussian.",
    )
    rotation_envelope = PointsField(
        "rotation_envelope",
        "",
        "White noise is integrated with this weight against the time before now. No points: no error. Only where rotation_error is envelope.",
    )
    oscillations = TextField("oscillations", "", "Sinusoids added to a coordinate or an angle.")
    waves = ChoiceField(
        "waves",
        {"none": "None", "ship": "Ship"},
        "Heave, roll and pitch of a ship in a sea with Bretschneider's spectrum. One of \"none\" (still water), \"ship\" (heave, roll and pitch of a ship).",
    )
    wave_height = NumberField(
        "wave_height",
        "m",
        "Significant height: 0.3 m in sea state 2, 0.88 in 3, 1.88 in 4, 3.25 in 5, 5 in 6, 7.5 in 7, 11.5 in 8. Takes 0 to 30 m. Only where waves is ship.",
    )
    wave_period = NumberField(
        "wave_period",
        "s",
        "Period of the most energetic waves: about 7.5 s in sea states 2 and 3, 8.8 in 4, 9.7 in 5, 12.4 in 6, 15 in 7, 16.4 in 8. Takes 0.5 to 30 s. Only where waves is ship.",
    )
    wave_heading = NumberField("wave_heading", "deg", "Azimuth to which the waves go. Only where waves is ship.")
    ship_length = NumberField("ship_length", "m", "At the waterline. Takes 1 to 1 km. Only where waves is ship.")
    ship_beam = NumberField("ship_beam", "m", "At the waterline. Takes 0.3 to 200 m. Only where waves is ship.")
    ship_draught = NumberField(
        "ship_draught",
        "m",
        "Depth of the keel below the water. Takes 0.1 to 50 m. Only where waves is ship.",
    )
    metacentric_height = NumberField(
        "metacentric_height",
        "m",
        "How stiff the ship is against roll; its roll period is 2 C B/sqrt(GM). Takes 0.01 to 50 m. Only where waves is ship.",
    )
    roll_damping = NumberField(
        "roll_damping",
        "",
        "Fraction of critical damping: 0.05 bare, 0.1 with bilge keels. Takes 0.005 to 2. Only where waves is ship.",
    )
    wave_count = NumberField(
        "wave_count",
        "",
        "Number of sinusoids that model the sea; 20 to 40 are enough. Takes 1 to 1000. Only where waves is ship.",
    )
    navigation = ChoiceField(
        "navigation",
        {"exact": "Exact", "ins": "Inertial"},
        "Measured (navigation) motion, which motion files and focusing can use instead of the true motion. One of \"exact\" (the motion is known as it is), \"ins\" (known with the errors of an inertial system).",
    )
    accelerometer_mps2 = VectorField(
        "accelerometer_mps2",
        "m/s2",
        "Along world x, y and z; the position error grows as b t^2/2: 0.88 m in a minute for 50 ug. Only where navigation is ins.",
    )
    gyro = VectorField(
        "gyro",
        "deg/s",
        "Tilt of the vertical that moves x and y, and drift of the heading; the position error grows as g eps t^3/6. Only where navigation is ins.",
    )
    fix_m = NumberField("fix_m", "m", "Standard deviation on each axis. Takes 0 or more. Only where navigation is ins.")
    fix_s = NumberField(
        "fix_s",
        "s",
        "Integral of the correlation (1 + 2 t/T) exp(-2 t/T). Takes 0.001 to 1000000 s. Only where navigation is ins.",
    )
    attitude_error = NumberField(
        "attitude_error",
        "deg",
        "Standard deviation of each angle. Takes 0 to 90 deg. Only where navigation is ins.",
    )
    attitude = NumberField(
        "attitude",
        "s",
        "Integral of the correlation (1 + 2 t/T) exp(-2 t/T). Takes 0.001 to 1000000 s. Only where navigation is ins.",
    )
    aligned_s = NumberField("aligned_s", "s", "Time from which biases and drifts act. Only where navigation is ins.")


class Target(SceneObject):
    """A point that reflects."""

    __slots__ = ()
    _kind = "target"

    platform = TextField("platform", "", "The platform that carries the target; coordinates are in its frame.")
    position = VectorField("position", "m", "Position of the target in the platform's frame.")
    position_stddev = VectorField(
        "position_stddev",
        "m",
        "Gaussian jitter of the coordinate from pulse to pulse; 0 for none. Takes 0 or more.",
    )
    rcs = NumberField("rcs", "m2", "Received power is Pt Gt Gr lambda^2 RCS/((4 pi)^3 R^4 L).")
    rcs_stddev = NumberField(
        "rcs_stddev",
        "m2",
        "Gaussian scintillation of the cross section from pulse to pulse; 0 for none. Takes 0 or more.",
    )
    reflectivity = ChoiceField(
        "reflectivity",
        {"isotropic": "Isotropic", "directional": "Directional"},
        "The same from all directions, or as a surface whose cross section depends on the incidence angle. One of \"isotropic\", \"directional\".",
    )
    azimuth = NumberField(
        "azimuth",
        "deg",
        "Direction in which the surface faces, in the platform's frame: from +y clockwise towards +x. Only where reflectivity is directional.",
    )
    elevation = NumberField(
        "elevation",
        "deg",
        "Direction in which the surface faces, in the platform's frame: above the x-y plane. Only where reflectivity is directional.",
    )
    azimuth_stddev = NumberField(
        "azimuth_stddev",
        "deg",
        "Gaussian jitter of the azimuth from pulse to pulse; 0 for none. Takes 0 or more. Only where reflectivity is directional.",
    )
    elevation_stddev = NumberField(
        "elevation_stddev",
        "deg",
        "Gaussian jitter of the elevation from pulse to pulse; 0 for none. Takes 0 or more. Only where reflectivity is directional.",
    )
    gain = ChoiceField(
        "gain",
        {"cosine": "Cos", "points": "User-defined"},
        "RCS times the cosine of the incidence angle, nothing from behind; or times a given function of that angle. One of \"cosine\" (cosine of the incidence angle), \"points\" (function of the incidence angle). Only where reflectivity is directional.",
    )
    gain_db = PointsField(
        "gain_db",
        "",
        "Reflectivity in dB against the incidence angle, 0 to 180 degrees. Only where gain is points.",
    )


class Cloud(SceneObject):
    """Points that reflect, from a table in a file."""

    __slots__ = ()
    _kind = "cloud"

    platform = TextField("platform", "", "The platform that carries the points; coordinates are in its frame.")
    file = TextField(
        "file",
        "",
        "NPY, CSV or HDF5 table with a point in each row: x, y, z in metres and, where it has a fourth column, the cross-section in square metres.",
    )
    position_stddev = VectorField(
        "position_stddev",
        "m",
        "Gaussian jitter of the coordinate from pulse to pulse; 0 for none. Takes 0 or more.",
    )
    rcs = NumberField("rcs", "m2", "Received power is Pt Gt Gr lambda^2 RCS/((4 pi)^3 R^4 L).")
    rcs_stddev = NumberField(
        "rcs_stddev",
        "m2",
        "Gaussian scintillation of the cross section from pulse to pulse; 0 for none. Takes 0 or more.",
    )
    reflectivity = ChoiceField(
        "reflectivity",
        {"isotropic": "Isotropic", "directional": "Directional"},
        "The same from all directions, or as a surface whose cross section depends on the incidence angle. One of \"isotropic\", \"directional\".",
    )
    azimuth = NumberField(
        "azimuth",
        "deg",
        "Direction in which the surface faces, in the platform's frame: from +y clockwise towards +x. Only where reflectivity is directional.",
    )
    elevation = NumberField(
        "elevation",
        "deg",
        "Direction in which the surface faces, in the platform's frame: above the x-y plane. Only where reflectivity is directional.",
    )
    azimuth_stddev = NumberField(
        "azimuth_stddev",
        "deg",
        "Gaussian jitter of the azimuth from pulse to pulse; 0 for none. Takes 0 or more. Only where reflectivity is directional.",
    )
    elevation_stddev = NumberField(
        "elevation_stddev",
        "deg",
        "Gaussian jitter of the elevation from pulse to pulse; 0 for none. Takes 0 or more. Only where reflectivity is directional.",
    )
    gain = ChoiceField(
        "gain",
        {"cosine": "Cos", "points": "User-defined"},
        "RCS times the cosine of the incidence angle, nothing from behind; or times a given function of that angle. One of \"cosine\" (cosine of the incidence angle), \"points\" (function of the incidence angle). Only where reflectivity is directional.",
    )
    gain_db = PointsField(
        "gain_db",
        "",
        "Reflectivity in dB against the incidence angle, 0 to 180 degrees. Only where gain is points.",
    )


class Surface(SceneObject):
    """A triangle that reflects."""

    __slots__ = ()
    _kind = "surface"

    platform = TextField("platform", "", "The platform that carries the triangle; coordinates are in its frame.")
    corner1 = VectorField(
        "corner1",
        "m",
        "Corner of the triangle. Its front, which reflects, is where (point 2 - point 1) x (point 3 - point 1) points.",
    )
    corner2 = VectorField(
        "corner2",
        "m",
        "Corner of the triangle. Its front, which reflects, is where (point 2 - point 1) x (point 3 - point 1) points.",
    )
    corner3 = VectorField(
        "corner3",
        "m",
        "Corner of the triangle. Its front, which reflects, is where (point 2 - point 1) x (point 3 - point 1) points.",
    )


class RadarTransmitAntenna(Part):
    """Fields of a radar: transmit antenna."""

    __slots__ = ()

    pattern = ChoiceField(
        "pattern",
        {"isotropic": "Isotropic", "sinx": "Simple sin(x)/x", "simple": "Simple sin(x)/x", "points": "User-defined"},
        "The same in all directions, sin(x)/x in either plane, or given cuts through the pattern. One of \"isotropic\" (transmit antenna: the same in all directions), \"sinx\" (transmit antenna: sin(x)/x), \"simple\" (transmit antenna: sin(x)/x), \"points\" (transmit antenna: gain given by points).",
    )
    elevation_beamwidth = NumberField(
        "elevation_beamwidth",
        "deg",
        "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg. Only where transmit_antenna.pattern is sinx or simple.",
    )
    azimuth_beamwidth = NumberField(
        "azimuth_beamwidth",
        "deg",
        "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg. Only where transmit_antenna.pattern is sinx or simple.",
    )
    gain_db = PointsField(
        "gain_db",
        "",
        "Azimuth and elevation cut: one-way power gain in dB against the angle off the beam; the two are added. Azimuth is positive to the right of the beam, clockwise seen from above, elevation above it. A table without negative angles that ends at 180 deg or before is the same to either side. Only where transmit_antenna.pattern is points.",
    )


class RadarReceiveAntenna(Part):
    """Fields of a radar: receive antenna."""

    __slots__ = ()

    pattern = ChoiceField(
        "pattern",
        {"isotropic": "Isotropic", "sinx": "Simple sin(x)/x", "simple": "Simple sin(x)/x", "points": "User-defined"},
        "The same in all directions, sin(x)/x in either plane, or given cuts through the pattern. One of \"isotropic\" (receive antenna: the same in all directions), \"sinx\" (receive antenna: sin(x)/x), \"simple\" (receive antenna: sin(x)/x), \"points\" (receive antenna: gain given by points). Only where same_antenna is .",
    )
    elevation_beamwidth = NumberField(
        "elevation_beamwidth",
        "deg",
        "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg. Only where receive_antenna.pattern is sinx or simple.",
    )
    azimuth_beamwidth = NumberField(
        "azimuth_beamwidth",
        "deg",
        "Between the half-power points; sin(x)/x with x = 0.88 pi sin(offset)/width. Above 0 and up to 360 deg. Only where receive_antenna.pattern is sinx or simple.",
    )
    gain_db = PointsField(
        "gain_db",
        "",
        "Azimuth and elevation cut: one-way power gain in dB against the angle off the beam; the two are added. Azimuth is positive to the right of the beam, clockwise seen from above, elevation above it. A table without negative angles that ends at 180 deg or before is the same to either side. Only where receive_antenna.pattern is points.",
    )


class Radar(SceneObject):
    """A transmitter and receiver."""

    __slots__ = ()
    _kind = "radar"

    name = TextField("name", "", "Recordings and geometry tables refer to the radar by this name.")
    platform = TextField("platform", "", "The radar is at the origin of this platform.")
    pulse = ChoiceField(
        "pulse",
        {"mono": "Monochrome", "chirp": "Chirp", "points": "User-defined", "barker": "Barker"},
        "Modulation within the pulse: none, a linear sweep, given I and Q, or a Barker phase code. One of \"mono\" (pulse of a single frequency), \"chirp\" (pulse of linearly swept frequency), \"points\" (pulse given by its I and Q), \"barker\" (pulse with a Barker phase code).",
    )
    bandwidth = NumberField(
        "bandwidth",
        "Hz",
        "Swept over the pulse width; negative sweeps down. Range resolution is c/(2 B). Only where pulse is chirp.",
    )
    pulse_iq = PointsField(
        "pulse_iq",
        "",
        "I and Q against the fraction of the pulse width, 0 to 1. Only where pulse is points.",
    )
    barker_code = ChoiceField(
        "barker_code",
        {"2": "2", "3": "3", "4": "4", "5": "5", "7": "7", "11": "11", "13": "13"},
        "Chips of the phase code; the range resolution is that of one chip. One of \"2\", \"3\", \"4\", \"5\", \"7\", \"11\", \"13\". Only where pulse is barker.",
    )
    pulse_width = NumberField(
        "pulse_width",
        "s",
        "From edge to edge, Tp. It is c Tp/2 long on the range axis. Takes 0 or more.",
    )
    envelope = ChoiceField(
        "envelope",
        {"rectangular": "Rectangular", "linear": "Linear", "points": "User-defined"},
        "Amplitude over the pulse: constant, with straight rise and fall, or given. One of \"rectangular\" (constant amplitude within the pulse), \"linear\" (straight rise and fall), \"points\" (envelope given by points).",
    )
    rise = NumberField("rise", "s", "From zero to full amplitude. Takes 0 or more. Only where envelope is linear.")
    fall = NumberField("fall", "s", "From full amplitude to zero. Takes 0 or more. Only where envelope is linear.")
    envelope_gain = PointsField(
        "envelope_gain",
        "",
        "Amplitude against the fraction of the pulse width, 0 to 1. Only where envelope is points.",
    )
    repetition = ChoiceField(
        "repetition",
        {"constant": "Constant", "list": "User-defined"},
        "Evenly spaced pulses, or a list of intervals that begins again at its end. Pulse 0 leaves at time 0. One of \"constant\" (evenly spaced pulses), \"list\" (list of intervals between pulses).",
    )
    prf = NumberField(
        "prf",
        "Hz",
        "Unambiguous range is c/(2 PRF), unambiguous speed lambda PRF/4 either way. Takes 0.00001 Hz or more. Only where repetition is constant.",
    )
    pri = PointsField("pri", "", "Time from each pulse to the next, in turn. Only where repetition is list.")
    carrier = ChoiceOrNumberField(
        "carrier",
        {"single": "Single", "stepped": "Stepped", "list": "User-defined"},
        "Hz",
        "One carrier, steps from pulse to pulse, or a list that begins again at its end. One of \"single\" (one carrier), \"stepped\" (carrier stepped from pulse to pulse), \"list\" (list of carriers).",
    )
    carrier_hz = NumberField(
        "carrier_hz",
        "Hz",
        "Carrier; the first one of stepped carriers. Wavelength is c/f. Takes 0 or more. Only where carrier is single or stepped.",
    )
    carrier_step = NumberField(
        "carrier_step",
        "Hz",
        "From one frequency to the next. N steps resolve c/(2 N step) in range. Takes 0 or more. Only where carrier is stepped.",
    )
    carrier_steps = NumberField(
        "carrier_steps",
        "",
        "Frequencies of a burst. Takes 1 to 1000. Only where carrier is stepped.",
    )
    pulses_per_step = NumberField(
        "pulses_per_step",
        "",
        "Pulses sent at each frequency before the next step. Takes 1 to 100. Only where carrier is stepped.",
    )
    carrier_list = PointsField("carrier_list", "", "Carrier of each pulse, in turn. Only where carrier is list.")
    power = NumberField("power", "W", "Transmitted peak power. Takes 0 or more.")
    losses = NumberField("losses", "dB", "Total of the losses; received power is divided by it. Takes 0 or more.")
    noise_temperature = NumberField(
        "noise_temperature",
        "K",
        "Receiver noise temperature: noise power is k T B. 0 for no noise. Takes 0 or more.",
    )
    transmit_gain = NumberField(
        "transmit_gain",
        "dB",
        "Gain at the middle of the transmitted beam, on top of the antenna's pattern. Takes 0 to 300 dB.",
    )
    receive_gain = NumberField(
        "receive_gain",
        "dB",
        "Gain at the middle of the received beam, on top of the antenna's pattern. Takes 0 to 300 dB.",
    )
    transmit_antenna = PartField("transmit_antenna", RadarTransmitAntenna)
    same_antenna = CheckField("same_antenna", "", "Receive with the transmit antenna.")
    receive_antenna = PartField("receive_antenna", RadarReceiveAntenna)
    beam = ChoiceField(
        "beam",
        {"fixed": "Fixed", "rotating": "Constant rotation", "spot": "Spot mode", "points": "User-defined"},
        "Fixed to the platform, turning about its vertical, held on a point of the world, or on a moving one. One of \"fixed\" (beam fixed to the platform), \"rotating\" (beam turning about the vertical), \"spot\" (beam held on a point of the world), \"points\" (beam held on a moving point of the world).",
    )
    beam_elevation = NumberField(
        "beam_elevation",
        "deg",
        "Above the platform's x-y plane. Only where beam is fixed or rotating.",
    )
    beam_azimuth = NumberField(
        "beam_azimuth",
        "deg",
        "From the platform's +y axis clockwise towards +x. Only where beam is fixed.",
    )
    beam_rate = NumberField(
        "beam_rate",
        "deg/s",
        "The azimuth is speed times time. Takes 0 or more. Only where beam is rotating.",
    )
    spot = VectorField("spot", "m", "World point at which the beam is held. Only where beam is spot.")
    beam_target = PointsField(
        "beam_target",
        "",
        "World x, y and z of the beam's look-at point against time. Only where beam is points.",
    )
    window = ChoiceField(
        "window",
        {"rectangular": "Rectangular", "hann": "Hann", "bartlett": "Bartlett", "hamming": "Hamming", "blackman": "Blackman", "kaiser": "Kaiser", "taylor": "Taylor", "points": "User-defined"},
        "Weights the matched filter: lower range side lobes for a wider main lobe. One of \"rectangular\" (matched filter without weighting), \"hann\" (matched filter with a Hann window), \"bartlett\" (matched filter with a triangular window), \"hamming\" (matched filter with a Hamming window), \"blackman\" (matched filter with a Blackman window), \"kaiser\" (matched filter with a Kaiser window), \"taylor\" (matched filter with a Taylor window), \"points\" (matched filter with a window given by points).",
    )
    hanning_pedestal = NumberField(
        "hanning_pedestal",
        "",
        "Window k + (1 - k) sin^2(pi x) for x from 0 to 1: 1 is no weighting, 0 falls to zero at the ends. Takes 0 to 1. Only where window is hann.",
    )
    kaiser_beta = NumberField(
        "kaiser_beta",
        "",
        "I0(beta sqrt(1 - (2x - 1)^2))/I0(beta) for x from 0 to 1; 0 is no weighting. Takes 0 to 20. Only where window is kaiser.",
    )
    taylor_sidelobes_db = NumberField(
        "taylor_sidelobes_db",
        "dB",
        "Level of the first sidelobes below the peak. Takes 10 to 100 dB. Only where window is taylor.",
    )
    taylor_equal_sidelobes = NumberField(
        "taylor_equal_sidelobes",
        "",
        "Number of sidelobes of nearly equal height on either side. Takes 1 to 30. Only where window is taylor.",
    )
    window_gain = PointsField(
        "window_gain",
        "",
        "Weight against the fraction of the pulse width, 0 to 1. Only where window is points.",
    )
    stc = ChoiceField(
        "stc",
        {"none": "None", "range-law": "1/R^4", "points": "User-defined"},
        "Gain against range before the A/D converter: none, compensating the range loss, or given. One of \"none\" (no sensitivity-time control), \"range-law\" (takes the loss with range out of the echoes), \"points\" (gain given by points).",
    )
    stc_gain = PointsField("stc_gain", "", "Voltage gain against range. Only where stc is points.")


class Recording(SceneObject):
    """A recording to be made."""

    __slots__ = ()
    _kind = "simulation"

    radar = TextField("radar", "", "The radar whose echoes are recorded.")
    range_start = NumberField(
        "range_start",
        "m",
        "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.",
    )
    range_end = NumberField(
        "range_end",
        "m",
        "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.",
    )
    time_start = NumberField(
        "time_start",
        "s",
        "Azimuth (slow time): pulses sent from the start to the end are taken, both included.",
    )
    time_end = NumberField(
        "time_end",
        "s",
        "Azimuth (slow time): pulses sent from the start to the end are taken, both included.",
    )
    sample_rate = NumberField(
        "sample_rate",
        "Hz",
        "Complex samples per second; at least the bandwidth of the pulse. Columns lie c/(2 fs) apart. Takes above 0.",
    )
    bits = NumberField(
        "bits",
        "",
        "Bits per I and Q channel; counts range from -(2^(bits-1) - 1) to 2^(bits-1). Takes 1 to 64.",
    )
    lsb = NumberField("lsb", "V", "Volts of one count. 0: estimated as the largest magnitude/(2^(bits-1) - 1).")
    processing = ChoiceField(
        "processing",
        {"raw": "Raw return", "matched-filter": "Range compressed", "srp": "Synthetic range profile"},
        "Samples as received, through the matched filter, or range profiles from the steps of the carrier. One of \"raw\" (samples as received), \"matched-filter\" (compressed in range), \"srp\" (synthetic range profiles of stepped carriers).",
    )
    file = TextField("file", "", "Name of the file of samples, beside the script or in the folder of the run.")
    format = ChoiceField(
        "format",
        {"ascii": "ASCII, I Q", "binary": "Binary", "bracket": "ASCII, (I,Q)", "hdf5": "HDF5", "csv": "CSV", "npy": "NumPy", "zarr": "Zarr", "sigmf": "SigMF"},
        "How the file of samples is laid out; HDF5, Zarr and SigMF carry their axes and the script. One of \"ascii\" (text, a line for each sample: I Q), \"binary\" (unsigned little-endian integers), \"bracket\" (text, a line for each pulse: (I,Q)), \"hdf5\" (HDF5 file), \"csv\" (text, a line for each pulse: I,Q), \"npy\" (NumPy array), \"zarr\" (Zarr store: a folder of files), \"sigmf\" (SigMF recording: samples, and JSON about them).",
    )
    pulse_position = ChoiceField(
        "pulse_position",
        {"begin": "Start", "centre": "Centre"},
        "Which part of the echo is placed at the target's range: its leading edge or its centre. One of \"begin\" (a target's range is where its pulse begins), \"centre\" (a target's range is the centre of its pulse).",
    )
    oversampling = NumberField(
        "oversampling",
        "",
        "Above 1 a band-limited pulse keeps only its nominal bandwidth. Takes 1 to 100.",
    )
    width_factor = NumberField(
        "width_factor",
        "",
        "Length of the band-limited pulse that is kept, in pulse widths, 1 or more; 0 keeps all of it (in the classic profile: 1). Takes 0 to 100.",
    )


class GeometryColumns(Part):
    """Fields of a geometry: columns."""

    __slots__ = ()

    time = CheckField(
        "time",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    frequency = CheckField(
        "frequency",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    position = CheckField(
        "position",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    velocity = CheckField(
        "velocity",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    rotation = CheckField(
        "rotation",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    delay = CheckField(
        "delay",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    amplitude = CheckField(
        "amplitude",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )
    radial_speed = CheckField(
        "radial_speed",
        "",
        "A column of the table; platform columns repeat for every platform, the last three for every target.",
    )


class Geometry(SceneObject):
    """A table of delays, amplitudes and speeds to be made."""

    __slots__ = ()
    _kind = "geometry"

    radar = TextField("radar", "", "The radar whose pulses are listed.")
    range_start = NumberField(
        "range_start",
        "m",
        "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.",
    )
    range_end = NumberField(
        "range_end",
        "m",
        "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.",
    )
    time_start = NumberField(
        "time_start",
        "s",
        "Azimuth (slow time): pulses sent from the start to the end are taken, both included.",
    )
    time_end = NumberField(
        "time_end",
        "s",
        "Azimuth (slow time): pulses sent from the start to the end are taken, both included.",
    )
    file = TextField("file", "", "Name of the table, beside the script or in the folder of the run.")
    separator = ChoiceField(
        "separator",
        {"space": "Space", "comma": "Comma"},
        "Separator between columns. One of \"space\" (columns separated by blanks), \"comma\" (columns separated by commas).",
    )
    columns = PartField("columns", GeometryColumns)


class Atmosphere(LoneObject):
    """What lies between radars and targets: air, rain, the ionosphere."""

    __slots__ = ()
    _kind = "atmosphere"

    refraction = ChoiceField(
        "refraction",
        {"none": "None", "exponential": "Exponential", "linear": "Linear"},
        "Delay of echoes by the air: 2.3 m one way at the zenith. Rays stay straight. One of \"none\" (the air is as quick as vacuum), \"exponential\" (refractivity falls with exp(-h/H)), \"linear\" (refractivity falls evenly, by the factor k).",
    )
    refractivity = NumberField(
        "refractivity",
        "",
        "N = (n - 1) 1e6 at height 0; 315 is the global mean. Takes 1 to 1000. Only where refraction is exponential or linear.",
    )
    scale_height = NumberField(
        "scale_height",
        "m",
        "H in N = N0 exp(-h/H). Takes 100 to 50 km. Only where refraction is exponential.",
    )
    k_factor = NumberField(
        "k_factor",
        "",
        "4/3 is a gradient of -39.24 N per km. Takes 1.001 to 100. Only where refraction is linear.",
    )
    gases = CheckField(
        "gases",
        "",
        "Absorption by oxygen and water vapour, ITU-R P.676-13, in the reference atmosphere of P.835.",
    )
    vapour_g_per_m3 = NumberField("vapour_g_per_m3", "", "In g/m3; 7.5 is the global mean. Takes 0 to 50.")
    rain_mm_per_h = NumberField(
        "rain_mm_per_h",
        "",
        "In mm/h, the same everywhere below the rain height; loss by ITU-R P.838-3, 1 to 1000 GHz. Takes 0 to 500.",
    )
    rain_top = NumberField("rain_top", "m", "Height up to which it rains. Takes 0 to 20 km.")
    polarisation = NumberField(
        "polarisation",
        "deg",
        "From the horizontal: 0 for H, 90 deg for V, 45 deg for circular. Takes -90 to 90 deg.",
    )
    tec_units = NumberField(
        "tec_units",
        "",
        "In TEC units of 1e16 electrons per m2: 5 to 20 at night, up to 100 by day. Delays by 40.3 TEC/f^2, and advances the phase as much. Takes 0 to 1000.",
    )
    shell_height = NumberField(
        "shell_height",
        "m",
        "Height of the thin shell that contains all electrons; a radar below it sees none. Takes 100000 to 1000 km.",
    )
    field_ut = NumberField(
        "field_ut",
        "",
        "In uT; rotates a linear polarisation (Faraday), which costs amplitude. Takes -100 to 100.",
    )


class Options(LoneObject):
    """Settings for all outputs of the scene; the command line overrides them."""

    __slots__ = ()
    _kind = "options"

    profile = ChoiceField(
        "profile",
        {"classic": "Classic", "physical": "Physical"},
        "Conventions of radar engineering, or those of the programs of 1998 with their constants. One of \"classic\" (conventions of the 1998 programs), \"physical\" (conventions of radar engineering).",
    )
    seed = WholeField(
        "seed",
        "",
        "Seed of all random numbers: the same seed gives the same noise and jitter. Takes 0 to 18446744073709551615.",
    )
    pulse = ChoiceField(
        "pulse",
        {"ideal": "Ideal", "band-limited": "Band-limited"},
        "Hard edges sampled where they are, or confined to the sampled band. One of \"ideal\" (hard edges, sampled where they are), \"band-limited\" (confined to the sampled band).",
    )
    tolerance = NumberField(
        "tolerance",
        "",
        "Largest error of a fast method, relative to the echo; 1e-12 to 0.1. Takes above 0.",
    )
    cubic_ends = ChoiceField(
        "cubic_ends",
        {"chords": "Chords", "not-a-knot": "Not a knot"},
        "End condition of CUBIC functions: the slope of the end chord, or not-a-knot, as orbits and other curved paths need. One of \"chords\" (slopes of the first and last chord, as since 1998), \"not-a-knot\" (one cubic through the first three points and one through the last three).",
    )
    ambiguous_echoes = ChoiceField(
        "ambiguous_echoes",
        {"strong": "Strong", "all": "All", "none": "None"},
        "Range-ambiguous echoes: of pulses sent earlier or later, arriving within the range window. The classic profile never has them. One of \"strong\" (those above -60 dB of the strongest echo), \"all\" (all that reach the window), \"none\" (a row holds the echoes of its own pulse).",
    )
    eclipsing = ChoiceField(
        "eclipsing",
        {"none": "None", "blanked": "Blanked"},
        "Whether the receiver stays on or is blanked while the radar transmits. One of \"none\" (the receiver goes on while the radar sends), \"blanked\" (samples are 0 while the radar sends).",
    )

"""The shape of a variant file: its keys and the value of each.

Enters: nothing.  Leaves: plain records.  `well_formed.py` fills them; from them `models.py` makes pydantic's models for a file
with faults, and `variants/variant.schema.json`.  Used by `variant/` and `grading/`.

Beyond [given], [drive], [coordinates], [unknowns], [time] and one [[constraint]] for each velocity equation: a constraint may be
a position equation (closure = "B + r2 @ phi2 = D + r3 @ phi3"), and a chain of Assur groups may stand for all of them ([[group]],
kinds crank, RRR, RRP, RPR, RPP, PRP; see `variants/example-1.toml` to `example-6.toml`).  Keys, each with a file that uses it:

    teaches, remarks            what the variant shows; paragraphs for its page  variants/example-3.toml
    [text.ru], [text.uk] …      title, source, teaches, remarks, because, means in another language  variants/31.toml
    [[group]] guide, guides     guides (through, angle, offset), which may move  variants/prp.toml
    coordinates, unit           without start: a chain gives the start by itself  variants/homework.toml
    [time] scheme               "euler" … "rk4", or "exact": the motion without a scheme's error  variants/example-3.toml
    [[quote]]                   a number that the remarks quote; QUOTE holds the table to it  variants/example-3.toml
    [functions]                 a length as formula, pieces, or { table = …, of = "phi1" }  variants/variable-crank-table.toml
    [unknowns] of, along        which velocity of the geometry an unknown is, so that its equations are judged  variants/v102.toml
    [unknowns] relative         … against the material of another link  coursework/equations/reduction/bound.py
    [drive] table               { table = "v.csv", of = "t" }: measured over time  coursework/motion/geometry/drives/drive.py
    [drive] pieces              [["0 s", "0"], ["0.1 s", "V"]]: a drive that changes its formula  variants/engine-start.toml
    [links] slides              the link along which this one slides (a sleeve on a bar)  variants/v107.toml
    [frame] circles             a fixed cylinder that a wheel rolls on  variants/v108.toml
    [points], [links], [frame]  where points are, which links they belong to, what is fixed  variants/31.toml
    [masses], [forces]          what moves the links: masses, weight, loads, springs  variants/example-1-forces.toml
    [friction]                  friction of pins, guides and wheels  coursework/variant/record/forces.py
    [motor] flywheel            what a flywheel on a link has to bring about  variants/example-2-forces.toml
    [closure], [ask]            which point is driven, what is held; quantities beside the table  variants/31.toml
    no [closure]                what [frame] and [drive] hold instead  coursework/variant/reading/implied_closure.py
    [[constraint]] w1 = n       a rate that time alone gives is a drive  coursework/variant/reading/driven_rates.py

Units: m cm mm in ft, rad deg ° grad, s ms min, these per second or per minute (m/s, deg/s, rev/s, m/s^2 …), rpm, and the same
in Cyrillic (мм, град, об/мин …).  1/s is rad/s, 1/min is rev/min, and "grad" is read as degrees.  Hz is refused because it does
not tell whether rad/s or rev/s is meant.
"""

from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from coursework.variant.record.vocabulary import GROUP_KINDS, scheme_names


class Limits:
    """The limits of a value beside its type, and hints for editors, under the names that pydantic's `Field` uses."""

    def __init__(self, **limits: Any) -> None:
        self.limits = limits


Text = Annotated[str, Limits(max_length=2000)]
Short = Annotated[str, Limits(max_length=300)]
Name = Annotated[str, Limits(max_length=40, min_length=1)]
Value = Annotated[Text | int | float, Limits(description='"value unit", such as "0.953 m", or a bare number in SI')]
Piece = Annotated[list[Value], Limits(min_length=2, max_length=2, description="from this time on, this formula")]

if TYPE_CHECKING:
    KindName = str
else:
    KindName = Literal[tuple(GROUP_KINDS)]


class Section:
    """A table of the file; each annotation is a key, one without a default must be there."""

    @classmethod
    def keys(cls) -> dict[str, str]:
        """Return the name of the field for each key, in the order of the schema."""
        return {_alias(kind) or name: name for name, kind in cls.__annotations__.items()}


def _alias(kind: Any) -> str | None:
    return next((each.limits.get("alias") for each in get_args(kind)[1:] if isinstance(each, Limits)), None)


class Datum(Section):
    """A datum of the task sheet with what it means: { value = "0.953 m", means = "DA" }."""

    value: Value
    means: Short = ""


class Pieces(Section):
    """A drive or function given piece by piece; the integration is split at the times between them."""

    pieces: Annotated[list[Piece], Limits(min_length=1, max_length=200)]


class Table(Section):
    """A law given as a table of two columns, over a coordinate or over t, in a CSV file inside the variant's folder."""

    table: Short
    of: Name
    method: Literal["five-point", "spline"] = "five-point"


class Coordinate(Section):
    """What the scheme integrates: value at t = 0 and the name of its rate."""

    start: Value | None = None
    rate: Name
    unit: Literal["rad", "m"] | None = None


class Unknown(Section):
    """A velocity that the equations determine, and which of the geometry it is: { unit = "m/s", of = "B", along = "0 deg" }.

    `of` is a point of [points], its velocity then taken `along` a direction, or "link 4", whose rate it is; `relative` is the
    link against which it is measured.
    """

    unit: Annotated[Short, Limits(description='such as "m/s" or "1/s"')]
    of: Annotated[Name | None, Limits(description='a point, or "link 4"')] = None
    along: Annotated[Value | None, Limits(description='the direction of a point\'s velocity: "0 deg", "phi3 + pi/2"')] = None
    relative: Annotated[Name | int | None, Limits(description="the link against which it is measured")] = None


class Time(Section):
    """Step, end, period of the exact motion and the row of the graph-analytical check."""

    step: Value
    end: Value
    period: Value | None = None
    check_row: Annotated[int, Limits(ge=1)] | None = None
    scheme: Annotated[Name, Limits(json_schema_extra={"enum": list(scheme_names())})] | None = None


class Quote(Section):
    """A number that the remarks quote from the table: which row (from 1) of which column, with the digits as printed."""

    row: Annotated[int, Limits(ge=1)]
    column: Name
    value: Annotated[str, Limits(max_length=30, pattern=r"^[-−+]?\d+(\.\d+)?$")]
    scheme: Annotated[Name, Limits(json_schema_extra={"enum": list(scheme_names())})] | None = None


class Constraint(Section):
    """One constraint: a velocity `equation`, or a position `closure`, with the reason for it."""

    name: Annotated[Name | int, Limits(description="the number or name the equation is cited by")] = ""
    because: Short = ""
    equation: Text | None = None
    closure: Text | None = None


class Guide(Section):
    """A straight guide: a point of it, its angle, the offset of the pin from it."""

    through: Text
    angle: Value
    offset: Value = 0


class Group(Section):
    """One Assur group of a chain, or its crank."""

    kind: KindName
    start_points: Annotated[list[Text], Limits(alias="from", max_length=2)] = []
    meets: Name | None = None
    lengths: Annotated[list[Value], Limits(max_length=2)] = []
    coordinates: Annotated[list[Name], Limits(min_length=1, max_length=2)]
    mode: Literal["+1", "-1", "1", 1, -1] | None = None
    guide: Guide | None = None
    guides: Annotated[list[Guide], Limits(max_length=2)] = []
    offset: Value | None = None
    angle: Value | None = None


class Link(Section):
    """A rigid body, or a wheel with its contact; it may slide in another.  Links of one rate that share a point are one body."""

    points: list[Name] = []
    rate: Name | None = None
    wheel: Name | None = None
    contact: Name | None = None
    slides: Annotated[Name | int | None, Limits(description="the link along which this one slides")] = None


class Rail(Section):
    """A straight guide fixed to the frame."""

    through: Text
    angle: Value


class Circle(Section):
    """A fixed cylinder that a wheel rolls on."""

    center: Text
    radius: Value


class Frame(Section):
    """The fixed link."""

    hinges: list[Name] = []
    rails: list[Rail] = []
    circles: list[Circle] = []


class Closure(Section):
    """The position form of the same constraints: what the exact motion keeps."""

    driven: Name | None = None
    holds: Annotated[list[Text], Limits(max_length=200)] = []


class Mass(Section):
    """The mass of a link, its inertia about the centre of mass, and where that is: { mass = "10 kg", inertia = "rod" }."""

    mass: Value
    inertia: Annotated[Value | None, Limits(description='"rod" m l^2/12, "disc" m R^2/2, "point" 0, or a value')] = None
    centre: Annotated[Text | None, Limits(description='a point of the link: "B + 0.5 @ theta2"; where left out, its middle')] = (
        None
    )


class Load(Section):
    """A force on a point of a link, a couple on a link, or what acts between two points: a spring, a damper."""

    on: Annotated[Name | int | None, Limits(description="the link it acts on")] = None
    at: Annotated[Text | None, Limits(description="the point of the link at which a force acts")] = None
    force: Annotated[Value | None, Limits(description='"(Fx, Fy)" in N, of data, coordinates, rates and t')] = None
    torque: Annotated[Value | None, Limits(description="a couple in N*m, + counter-clockwise")] = None
    spring: Annotated[list[Name], Limits(min_length=2, max_length=2)] = []
    damper: Annotated[list[Name], Limits(min_length=2, max_length=2)] = []
    stiffness: Value | None = None
    free: Annotated[Value | None, Limits(description="the length at which the spring is slack")] = None
    damping: Value | None = None


class MotorEntry(Section):
    """What a motor does to a link: a torque from the frame or from another link."""

    torque: Value
    source: Annotated[Name | int | None, Limits(alias="from", description="the link that it stands on; left out: the frame")] = (
        None
    )


class Flywheel(Section):
    """A flywheel on a link: its inertia, or the unevenness that it has to bring about."""

    on: Name | int
    inertia: Value | None = None
    unevenness: Value | None = None


class FrictionEntry(Section):
    """Friction of a pin (radius, coefficient), a guide (coefficient, length) or a wheel (arm), by the name of its point."""

    coefficient: Value | None = None
    radius: Value | None = None
    length: Value | None = None
    arm: Annotated[Value | None, Limits(description="of rolling friction")] = None


class Ask(Section):
    """What this scene calls for; nothing else is computed."""

    quantities: Annotated[list[Name], Limits(max_length=50)] = []


class Texts(Section):
    """What the file says about the variant, in another language; what is left out is said as the author wrote it."""

    title: Short = ""
    source: Short = ""
    teaches: Short = ""
    remarks: Annotated[list[Text], Limits(max_length=20)] = []
    because: Annotated[dict[Name, Short], Limits(description="the reason of a constraint, by its name")] = {}
    means: Annotated[dict[Name, Short], Limits(description="the meaning of a datum, by its name")] = {}


class VariantFile(Section):
    """A variant of the coursework: what the mechanism is, in the words of the task sheet."""

    format: Literal[1] = 1
    title: Short = ""
    source: Short = ""
    teaches: Short = ""
    remarks: Annotated[list[Text], Limits(max_length=20, description="paragraphs printed on the page of this variant")] = []
    quote: Annotated[list[Quote], Limits(max_length=100)] = []
    given: dict[Name, Value | Datum] = {}
    drive: dict[Name, Value | Pieces | Table] = {}
    coordinates: Annotated[dict[Name, Coordinate], Limits(min_length=1, max_length=200)]
    unknowns: dict[Name, Short | Unknown] = {}
    functions: dict[Name, Text | Pieces | Table] = {}
    time: Time
    constraint: Annotated[list[Constraint], Limits(max_length=400)] = []
    group: Annotated[list[Group], Limits(max_length=50)] = []
    points: Annotated[dict[Name, Text], Limits(max_length=400)] = {}
    links: dict[Name, Link] = {}
    frame: Frame = Frame()
    closure: Closure = Closure()
    masses: Annotated[dict[Name, Value | Mass], Limits(max_length=200, description="by link, or by the point of a block")] = {}
    forces: Annotated[dict[Name, Value | Load], Limits(max_length=200, description="gravity, and loads by name")] = {}
    friction: Annotated[dict[Name, FrictionEntry], Limits(max_length=200)] = {}
    motor: dict[Name, list[Name] | Flywheel | MotorEntry | dict[Name, Value]] = {}
    ask: Ask = Ask()
    text: Annotated[
        dict[Name, Texts], Limits(max_length=20, description="texts in another language, by its code: [text.ru]")
    ] = {}

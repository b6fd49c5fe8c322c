"""The questions as tools: a client of the protocol asks over standard input and output, as an assistant does.

What is right does not come from slowflow: closed forms of linear motions and of the geometry, and the paper's Table 2.
"""

import json
import math
import sys
import tomllib

import anyio
import pytest

from slowflow.app import schema
from slowflow.app.scenes import QUESTIONS
from tests.files import MOUNT, ROOT, Lazily

mcp, stdio, jsonschema = map(Lazily, ("mcp", "mcp.client.stdio", "jsonschema"))

g = 9.80665
SCENES = sorted((ROOT / "scenes").glob("*.toml"))
#: all but linear: no friction, and little motion
LINEAR = {**MOUNT, "friction": 0}
K_0 = 2500 - 3 * 1700 * 0.009 / 0.08
X_CR = math.sqrt(0.08**2 - 0.071**2)
F_0 = math.sqrt(K_0 / 12) / math.tau
#: viscous damping c of zeta on k_v, as a ratio of the stiffness at the centre
RATIO = 0.02 * math.sqrt(2500 / K_0)
TABLE_1 = {"lam": 3, "r": 3747 / 1848, "delta_h": 1848 / (6 * 3747), "mu": 0.012, "zeta": 0.02}


def at_5_hz():
    """Transmissibility of the linear oscillator."""
    r = 5 / F_0
    return math.sqrt((1 + (2 * RATIO * r) ** 2) / ((1 - r**2) ** 2 + (2 * RATIO * r) ** 2))


#: tool, arguments, column, its row, what is right, relative tolerance
RIGHT = {
    "natural frequency on k_v": ("at_rest", {"mount": MOUNT}, "f_n", None, math.sqrt(2500 / 12) / math.tau, 1e-12),
    "natural frequency": ("at_rest", {"mount": MOUNT}, "f_0", None, F_0, 1e-12),
    "stiffness at the centre": ("at_rest", {"mount": MOUNT}, "k_0", None, K_0, 1e-12),
    "stroke": ("at_rest", {"mount": MOUNT}, "x_cr", None, X_CR, 1e-12),
    "preset of the spring": ("at_rest", {"mount": MOUNT}, "preset", None, 12 * g / 2500, 1e-12),
    "heaviest load": ("at_rest", {"mount": MOUNT}, "heaviest", None, 12 + 2500 * X_CR / g, 1e-12),
    "sticking": ("at_rest", {"mount": MOUNT}, "sticking", None, 4 * 0.4 / math.pi, 1e-12),
    "onset": ("saddle_node_onset", {"isolator": TABLE_1}, "F_SN", None, 0.0217, 3e-3),
    "jump-up at 0.025": ("saddle_nodes", {"isolator": TABLE_1, "ask": {"F_0": 0.025}}, "Omega", 0, 0.8023, 6e-5),
    "jump-down at 0.025": ("saddle_nodes", {"isolator": TABLE_1, "ask": {"F_0": 0.025}}, "Omega", 1, 0.8318, 6e-5),
    "jump-up at 0.040": ("saddle_nodes", {"isolator": TABLE_1, "ask": {"F_0": 0.04}}, "Omega", 0, 0.8672, 6e-5),
    "its amplitude": ("saddle_nodes", {"isolator": TABLE_1, "ask": {"F_0": 0.04}}, "A", 1, 0.5536, 1e-4),
    "jump-up at 0.050": ("saddle_nodes", {"isolator": TABLE_1, "ask": {"F_0": 0.05}}, "Omega", 0, 0.8976, 6e-5),
    "margin": ("margins", {"isolator": TABLE_1, "ask": {"F_0": 0.04}}, "of_SN", None, 0.0217 / 0.04, 3e-3),
    "resonance": (
        "peak",
        {"mount": LINEAR, "ask": {"F": 1e-3}},
        "A",
        None,
        1e-3 / (2 * RATIO * math.sqrt(1 - RATIO**2) * K_0),
        1e-5,
    ),
    "transmissibility": (
        "amplitudes",
        {"mount": LINEAR, "ask": {"F": 1e-3, "f": 5}},
        "transmissibility_dB",
        0,
        20 * math.log10(at_5_hz()),
        1e-5,
    ),
    "isolation": ("isolation", {"mount": LINEAR, "ask": {"F": 1e-3}}, "f", None, math.sqrt(2) * F_0, 1e-5),
    # Miles: a flat spectral density of the base's acceleration
    "random": (
        "random",
        {
            "mount": {**LINEAR, "excitation": "base"},
            "psd": {"f": [1e-3, 1e3], "G": [1e-10, 1e-10], "unit": "g^2/Hz"},
        },
        "a_rms",
        0,
        g * math.sqrt(1e-10 * math.pi / 2 * F_0 / (2 * RATIO) * (1 + 4 * RATIO**2)),
        1e-3,
    ),
    # a pulse that is over before the mass has moved: its speed over the angular frequency, less damping in a quarter
    "shock": (
        "transient",
        {"mount": LINEAR, "shock": {"acceleration": 1e-2, "duration": 1e-4}},
        "A",
        None,
        2 / math.pi * 1e-6 / (math.tau * F_0) * math.exp(-RATIO * math.acos(RATIO)),
        1e-3,
    ),
    "acceleration of the base": (
        "peak",
        {"mount": {**LINEAR, "excitation": "base"}, "ask": {"a": 1e-3 / 12}},
        "A",
        None,
        1e-3 / (2 * RATIO * math.sqrt(1 - RATIO**2) * K_0),
        1e-5,
    ),
}
REFUSED = {
    "an amplitude without a unit": ("saddle_nodes", {"mount": MOUNT, "ask": {"F_0": 5}}, "is F, in N"),
    "a mass below zero": ("at_rest", {"mount": {**MOUNT, "m": -12}}, "m = -12"),
    "a word": ("peak", {"mount": {**MOUNT, "force": "truncatd"}, "ask": {"F": 1}}, "'truncated'"),
    "no oscillator": ("cusps", {}, "needs one of [mount], [spring], [isolator], [duffing], has 0"),
    "no frequency": ("amplitudes", {"mount": MOUNT, "ask": {"F": 1}}, "f is missing"),
    "no table": ("peak", {"mount": MOUNT, "ask": None}, "[ask] a table is missing"),
    "no such tool": ("jumps", {"mount": MOUNT}, "must be one of detachment"),
}


@pytest.fixture(scope="module")
def answers():
    """Of every question above, and the tools, from one session."""
    found = {}

    async def session():
        command = mcp.StdioServerParameters(command=sys.executable, args=["-m", "slowflow", "mcp"])
        async with stdio.stdio_client(command) as pipes, mcp.ClientSession(*pipes) as client:
            await client.initialize()
            found["tools"] = (await client.list_tools()).tools
            for name, (tool, arguments, *_) in {**RIGHT, **REFUSED}.items():
                found[name] = await client.call_tool(tool, arguments)
            scene = tomllib.loads((ROOT / "scenes" / "specification.toml").read_text(encoding="utf-8"))
            found["file"] = await client.call_tool("scene", scene)
            scene["psd"] = {"f": [1, 100], "G": [1e-5, 1e-5], "unit": "g^2/Hz"}
            scene["spectrum"] = {"f": [2, 5], "a": [0.04, 0.12]}
            del scene["loop"]
            found["scene"] = await client.call_tool("scene", scene)

    anyio.run(session)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", RIGHT)
def test_a_client_gets_the_right_number(name, answers):
    _, _, column, row, expected, tolerance = RIGHT[name]
    assert not answers[name].is_error, answers[name].content
    (one,) = answers[name].structured_content["answers"]
    value = one[column] if row is None else one[column][row]
    in_si = 1e-3 if one.get("units", {}).get(column) == "mm" else 1.0
    assert value * in_si == pytest.approx(expected, rel=tolerance)


@pytest.mark.slow
@pytest.mark.parametrize("name", REFUSED)
def test_a_refusal_names_what_is_allowed(name, answers):
    assert answers[name].is_error
    assert REFUSED[name][-1] in answers[name].content[0].text


@pytest.mark.slow
def test_numbers_have_units_and_what_is_known_of_their_error(answers):
    (one,) = answers["transmissibility"].structured_content["answers"]
    assert one["units"].items() >= {"f": "Hz", "A": "mm", "phi": "rad", "F": "N"}.items()
    assert one["units_of_arguments"] == {"F": "N", "f": "Hz"}
    assert one["validity"]
    assert f"validity: {one['validity']}" in answers["transmissibility"].content[0].text


@pytest.mark.slow
def test_a_scene_has_a_verdict(answers):
    content = answers["scene"].structured_content
    assert len(content["verdict"]["met"]) == len(content["verdict"]["requirement"]) > 3
    assert answers["scene"].content[0].text.startswith("# ")


@pytest.mark.slow
def test_no_file_is_read_for_a_client(answers):
    assert answers["file"].is_error
    assert "file is not a key of [spectrum]" in answers["file"].content[0].text


@pytest.mark.slow
def test_each_question_is_a_tool_whose_schema_arguments_fit(answers):
    tools = {tool.name: tool for tool in answers["tools"]}
    assert set(tools) == {*QUESTIONS, "scene"}
    for tool in tools.values():
        jsonschema.Draft202012Validator.check_schema(tool.input_schema)
        assert tool.description and tool.annotations.read_only_hint
    for tool, arguments, *_ in RIGHT.values():
        jsonschema.validate(arguments, tools[tool].input_schema)


@pytest.fixture(scope="module")
def validate():
    """Validates a scene by the schema of its file."""
    validator = jsonschema.Draft202012Validator(schema.scene_file())
    validator.check_schema(validator.schema)
    return validator.validate


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scenes_fit_the_schema(path, validate):
    validate(tomllib.loads(path.read_text(encoding="utf-8")))


def test_words_with_units_and_files_of_columns_fit(validate):
    of_base = {**MOUNT, "m": "12 kg", "excitation": "acceleration", "mounts": 4}
    shock = {"acceleration": "15 g", "duration": ["11 ms"]}
    scene = {"mount": of_base, "ask": {"a": ["0.3 g", 2]}, "psd": {"file": "floor.csv"}, "shock": shock}
    validate(scene)


@pytest.mark.parametrize(
    "wrong",
    [
        {"ask": {}},
        {"mount": MOUNT, "isolator": TABLE_1, "ask": {}},
        {"mount": {**MOUNT, "mass": 12}, "ask": {}},
        {"mount": {**MOUNT, "m": "heavy"}, "ask": {}},
        {"mount": MOUNT, "ask": {"F": -1}},
        {"mount": MOUNT, "ask": {"level_dB": 3}},
        {"mount": MOUNT, "ask": {"questions": ["saddle_node"]}},
        {"mount": MOUNT, "ask": {}, "psd": {"f": [1], "unit": "g"}},
        {"mount": MOUNT, "ask": {}, "require": {"jumps": "few"}},
    ],
    ids=lambda wrong: json.dumps(wrong)[-40:],
)
def test_what_a_scene_refuses_does_not_fit(wrong, validate):
    with pytest.raises(jsonschema.ValidationError):
        validate(wrong)

"""The questions as tools of the Model Context Protocol: `slowflow mcp`, which pip install 'slowflow[mcp]' brings.

Takes requests on standard input; returns answers on standard output. A tool takes what a scene has for its question
(`slowflow.app.schema`), and is refused in the scene's words. Nothing is read from files or written to them.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import anyio
from mcp import types
from mcp.server.lowlevel import Server
from mcp.server.stdio import stdio_server

from slowflow.answers import files
from slowflow.answers.answer import in_text
from slowflow.app import scenes, schema, verdict
from slowflow.app.query import QUESTIONS
from slowflow.support.errors import SlowflowError
from slowflow.version import __version__

INSTRUCTIONS = (
    "Primary resonance of vibration isolators: jump frequencies, response, transmissibility, shocks, random vibration. "
    "A [mount] is a data sheet in SI units (kg, N, N/m, m, Hz); omitted keys are zero, or have defaults. Amplitudes "
    "are F in N, or with excitation = 'base' Y in m or a in m/s^2. Answers are first-order averages unless they say "
    "otherwise: tell the user the remarks and the known errors that come with them."
)
#: the tool that takes a whole scene
SCENE = "scene"


def answer(name: str, arguments: Mapping[str, Any]) -> tuple[str, dict[str, Any]]:
    """The answer of one tool, as text and as plain Python. Raises SlowflowError for what is not allowed."""
    content = dict(arguments)
    if name != SCENE:
        if isinstance(ask := content.get("ask", {}), Mapping):  # what is no table the scene refuses
            content["ask"] = {**ask, "questions": [name]}
    scene = scenes.from_tables(content)
    lines, found, failed = list(scene.warnings), [], []
    for query in scene.queries:
        try:
            one = scene.answer(query)
        except SlowflowError as error:
            failed.append(f"{query}: {error}")
            continue
        known = errors(one)
        lines += [f"# {query}", *in_text(one), *([f"validity: {known}"] if known else []), ""]
        found.append({**query.content(one), "validity": known})
    lines += failed
    content = {"oscillator": repr(scene.oscillator), "answers": found, "failed": failed, "warnings": [*scene.warnings]}
    if scene.requirements:
        outcome = verdict.verdict(scene)
        lines[:0] = [f"# {verdict.in_words(outcome)}", *in_text(outcome), ""]
        content["verdict"] = outcome.to_dict()
    if failed and not found:
        raise SlowflowError("\n".join(failed))
    return "\n".join(lines).rstrip(), json.loads(files.in_json(content))


def errors(found: Any) -> str:
    """What was measured of the error of averaging in such an answer; empty where there is no such measurement."""
    try:
        return str(getattr(found, "answer", found).validity)
    except AttributeError:
        return ""


def tools() -> list[types.Tool]:
    """One for each question, and one for a whole scene."""
    found = {name: (schema.description(name), schema.question(name)) for name in QUESTIONS}
    found[SCENE] = "Several questions at once, and a verdict on the requirements.", schema.scene()
    hints = types.ToolAnnotations(read_only_hint=True, open_world_hint=False)
    return [
        types.Tool(name=name, description=text, input_schema=of, annotations=hints)
        for name, (text, of) in found.items()
    ]


async def _list(context: Any, parameters: Any) -> types.ListToolsResult:
    return types.ListToolsResult(tools=tools())


async def _call(context: Any, parameters: types.CallToolRequestParams) -> types.CallToolResult:
    """In a thread: what takes seconds holds up nobody else."""
    try:
        if parameters.name not in (*QUESTIONS, SCENE):
            raise SlowflowError(
                f"{parameters.name!r} is not a tool: it must be one of {', '.join((*QUESTIONS, SCENE))}"
            )
        text, content = await anyio.to_thread.run_sync(answer, parameters.name, parameters.arguments or {})
    except SlowflowError as error:
        return types.CallToolResult(content=[types.TextContent(type="text", text=str(error))], is_error=True)
    return types.CallToolResult(content=[types.TextContent(type="text", text=text)], structured_content=content)


async def _serve() -> None:
    server = Server("slowflow", version=__version__, instructions=INSTRUCTIONS, on_list_tools=_list, on_call_tool=_call)
    async with stdio_server() as (read, write):
        await server.run(read, write, server.create_initialization_options())


def serve() -> None:
    """Answer a client on standard input and output until it leaves."""
    anyio.run(_serve)

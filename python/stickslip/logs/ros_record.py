"""A record out of the messages of a bag, whatever its container."""
from __future__ import annotations

from pathlib import Path
from typing import Iterable

from ..program import StickslipError
from . import ros_messages
from .common import frame_of, held, joint_index

Message = tuple[str, str, float, bytes]  # topic, type, time of receipt [s], data


def record(path: Path, messages: Iterable[Message], cdr: bool, joint: str | None, topic: str | None, command: str | None):
    """`topic` is the one of JointState messages, `command` one of numbers, of Float64MultiArray in the order of the joints
    or of JointState: its position is then the reference."""
    states: dict[str, list[tuple[float, ros_messages.JointState]]] = {}
    numbers: dict[str, list[tuple[float, list[float]]]] = {}
    seen: dict[str, str] = {}
    for name, kind, received, data in messages:
        plain = seen[name] = ros_messages.plain_type(kind)
        if plain == "sensor_msgs/JointState":
            states.setdefault(name, []).append((received, ros_messages.joint_state(data, cdr)))
        elif name == command and plain == "std_msgs/Float64MultiArray":
            numbers.setdefault(name, []).append((received, ros_messages.multi_array(data, cdr)))
        elif name == command and plain not in ros_messages.NUMBERS:
            raise StickslipError(f"{path}: command topic {name} has messages of {kind}, expected sensor_msgs/JointState, std_msgs/Float64MultiArray, "
                                 + ", ".join(ros_messages.NUMBERS))
        elif name == command:
            numbers.setdefault(name, []).append((received, [ros_messages.value(kind, data, cdr)]))
    listed = ", ".join(f"{n} ({t})" for n, t in sorted(seen.items())) or "none"
    if command is not None and command not in seen:
        raise StickslipError(f"{path}: has no messages on the command topic {command}; topics are {listed}")
    candidates = [name for name in states if name != command]
    chosen = None
    if topic is None:
        if len(candidates) > 1 and joint is not None:  # an arm and its gripper have a topic each
            having = [name for name in candidates if any(joint in state.names for _, state in states[name])]
            if len(having) == 1:
                candidates, chosen = having, having[0]
        if len(candidates) != 1:
            raise StickslipError(f"{path}: has {len(candidates)} topics of sensor_msgs/JointState, expected one; say which with topic=; topics are {listed}")
        topic = candidates[0]
    if topic not in states:
        raise StickslipError(f"{path}: has no JointState on topic {topic}; topics are {listed}")
    frame = _columns(path, states, numbers, topic, command, joint)
    if chosen:
        frame.attrs["guessed"].append(f"joint states are those of {chosen}, the only topic that has {joint}")
    return frame


def _sent(messages, name: str, of: str) -> list[tuple[float, float]]:
    """What was sent to the joint: time of receipt and value; messages may lack the joint or the quantity."""
    found = [(received, getattr(state, of), state.names.index(name)) for received, state in messages if name in state.names]
    return [(received, values[i]) for received, values, i in found if i < len(values)]


def _columns(path, states, numbers, topic, command, joint):
    # several drivers may share a topic, each with messages of its own joints
    lists = {tuple(state.names): None for _, state in states[topic]}
    names = list(next(iter(lists))) if len(lists) == 1 else list(dict.fromkeys(name for one in lists for name in one))
    name = names[joint_index(f"{path}: topic {topic}", names, joint)]
    driver = next(list(one) for one in lists if name in one)
    if driver.count(name) > 1:
        raise StickslipError(f"{path}: topic {topic}: has {driver.count(name)} joints called {name!r}, expected one")
    t: list[float] = []
    columns: dict[str, list[float]] = {"position": [], "velocity": [], "effort_measured": []}
    guessed = ["units are those of REP 103 (rad, m, N·m, N): the messages do not say"]
    received: list[float] = []
    stamped = all(s.stamp > 0 for _, s in states[topic])
    if not stamped:
        guessed.append("messages have no stamp: time is that of receipt")
    for when, state in states[topic]:
        if name not in state.names:
            continue
        i = state.names.index(name)
        received.append(when)
        t.append(state.stamp if stamped else when)
        for column, values in (("position", state.position), ("velocity", state.velocity), ("effort_measured", state.effort)):
            columns[column].append(values[i] if i < len(values) else float("nan"))
    columns = {key: values for key, values in columns.items() if any(v == v for v in values)}
    if "position" not in columns:
        raise StickslipError(f"{path}: topic {topic} has no position of {name}")
    if command in states:
        sent = _sent(states[command], name, "position")
    else:
        given = numbers.get(command, [])
        wrong = [len(v) for _, v in given if len(v) not in (1, len(driver))]
        if wrong:
            raise StickslipError(f"{path}: topic {command} has {wrong[0]} numbers a message, topic {topic} has {len(driver)} joints")
        sent = [(r, v[0] if len(v) == 1 else v[driver.index(name)]) for r, v in given]
    if sent:
        guessed.append(f"reference is the last message of {command} received before each row")
        columns["reference_position"] = held(received, [r for r, _ in sent], [v for _, v in sent])
        speeds = _sent(states[command], name, "velocity") if command in states else []
        if len(speeds) == len(sent):
            columns["reference_velocity"] = held(received, [r for r, _ in speeds], [v for _, v in speeds])
    else:
        guessed.append("no command topic was named: the record has no reference")
    return frame_of(path, {"time": t, **columns}, guessed)

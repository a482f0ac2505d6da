"""Trashbot: discrete and continuous actions (lesson 7)."""

from edugym.envs.trashbot.task import Trashbot

__all__ = ["Trashbot"]

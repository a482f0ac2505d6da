"""Trashbot: discrete and continuous states and actions."""

from edugym.envs.trashbot.task import Trashbot, TrashbotEnv

__all__ = ["Trashbot", "TrashbotEnv"]

"""The Gymnasium classes of the environments that have no file of their own for it."""

from typing import Any

from edugym.adapters.registration import find

BoulderEnv: Any = find("Boulder").load()
CatchEnv: Any = find("Catch").load()
GolfEnv: Any = find("Golf").load()
MemoryCorridorEnv: Any = find("MemoryCorridor").load()
RoadrunnerEnv: Any = find("Roadrunner").load()
StudyEnv: Any = find("Study").load()
TamagotchiEnv: Any = find("Tamagotchi").load()
TrashbotEnv: Any = find("Trashbot").load()

"""Two small convolutional networks for the boards of Catch, for Stable-Baselines3."""

from typing import Any

import torch
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from torch import Tensor, nn

HIDDEN = 64


class SmallCNN(BaseFeaturesExtractor):
    """Two convolutions with filters of 3 by 3 pixels, and then a layer with a weight for every place of the board."""

    def __init__(self, space: Any) -> None:
        """Make the layers for images of the shape (channels, rows, columns)."""
        super().__init__(space, HIDDEN)
        channels, rows, columns = space.shape
        self.layers = nn.Sequential(
            nn.Conv2d(channels, 16, 3, padding=1),
            nn.ReLU(),
            nn.Conv2d(16, 16, 3, padding=1),
            nn.ReLU(),
            nn.Flatten(),
            nn.Linear(16 * rows * columns, HIDDEN),
            nn.ReLU(),
        )

    def forward(self, images: Tensor) -> Tensor:
        """Return the features of some images."""
        features: Tensor = self.layers(images)
        return features


class ColumnCNN(BaseFeaturesExtractor):
    """Filters as high as the board that slide over its columns; of each filter the largest output counts."""

    def __init__(self, space: Any) -> None:
        """Make the filters for images of the shape (channels, rows, columns)."""
        super().__init__(space, HIDDEN)
        channels, rows, columns = space.shape
        self.filters = nn.Conv2d(channels, HIDDEN, (rows, 2 * columns - 1), padding=(0, columns - 1))

    def forward(self, images: Tensor) -> Tensor:
        """Return the features of some images."""
        return torch.relu(self.filters(images)).amax(dim=(2, 3))

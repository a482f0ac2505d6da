"""Games of two players. They are no environments of one agent, so Gymnasium does not know their names."""

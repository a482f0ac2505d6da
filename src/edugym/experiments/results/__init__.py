"""What experiments give: tidy tables, intervals, and claims that hold or do not."""

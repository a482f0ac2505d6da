# %% in one line
# says: Right: exact, and with b actions and k outcomes recursion takes work that grows as (bk)^d.
def look_ahead(model, state, depth):
    def action_value(outcomes):
        return sum(p * (r + (0 if end else 0.9 * look_ahead(model, after, depth - 1))) for p, after, r, end in outcomes)

    return max(action_value(outcomes) for outcomes in model[state]) if depth else 0


# %% backwards, with a table
def look_ahead(model, state, depth):
    V = {s: 0.0 for s in model}
    for _ in range(depth):
        V = {
            s: max(
                sum(p * (reward + 0.9 * V[after] * (not terminated)) for p, after, reward, terminated in outcomes)
                for outcomes in actions
            )
            for s, actions in model.items()
        }
    return V[state]

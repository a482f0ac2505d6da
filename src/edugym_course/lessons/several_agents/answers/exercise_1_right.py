# %% both best answers
# says: Right: player 1 gets the opposite, so what both get now drops out, and two best answers are enough.
def exploitability(payoffs, first, second):
    best_of_first = max(payoffs @ second)
    best_of_second = max(-first @ payoffs)
    return (best_of_first + best_of_second) / 2


# %% gain by gain, in loops
def exploitability(payoffs, first, second):
    n_rows, n_columns = payoffs.shape
    now = 0.0
    for a in range(n_rows):
        for b in range(n_columns):
            now += first[a] * second[b] * payoffs[a, b]
    answers = [sum(second[b] * payoffs[a, b] for b in range(n_columns)) for a in range(n_rows)]
    replies = [sum(first[a] * payoffs[a, b] for a in range(n_rows)) for b in range(n_columns)]
    gain_of_first = max(answers) - now
    gain_of_second = now - min(replies)
    return (gain_of_first + gain_of_second) / 2


# %% the package's own
def exploitability(payoffs, first, second):
    model = games.game_model(games.matrix_game(payoffs))
    return games.exploitability(model, ([first], [second]))

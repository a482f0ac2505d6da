# %% max
# says: Right: dual ascent. The price rises after dives that take too long, and falls after the others.
def new_price(price, steps, limit, rate):
    return max(0.0, price + rate * (steps - limit))


# %% an if
def new_price(price, steps, limit, rate):
    price = price + rate * (steps - limit)
    if price < 0:
        return 0
    return price


# %% the other sign, twice
def new_price(price, steps, limit, rate):
    missing = limit - steps
    return np.maximum(price - rate * missing, 0.0)

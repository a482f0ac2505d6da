# %% the sign
# says: the sign is wrong: a dive that takes too long makes time dearer
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (limit - steps))


# %% below 0
# says: the price may not fall below 0: then time would be worth something
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return price + rate * (steps - limit)


# %% no rate
# says: the rate is missing
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + (steps - limit))


# %% no old price
# says: the old price is missing: the step is added to it
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, rate * (steps - limit))


# %% no limit
# says: the limit is missing: what counts is how far the dive is above it
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * steps)


# %% only up
# says: the price only rises; after a short dive it should fall
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return price + rate * max(0.0, steps - limit)


# %% one step
# says: the price rises by the same step for each long dive, however long: multiply by the steps beyond the limit
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * np.sign(steps - limit))


# %% multiplied
# says: the price is multiplied; the step is added
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price * (1 + rate * (steps - limit)))


# %% a mean
# says: a weighted mean of the old price and the excess: the old price counts in full
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - limit - price))


# %% min
# says: that is the smaller one of 0 and the new price: write max
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return min(0.0, price + rate * (steps - limit))


# %% a share
# says: the excess is a share of the limit; it should be a number of steps
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - limit) / limit)


# %% the absolute value
# says: the absolute value of the difference is taken; below the limit the price falls
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return price + rate * abs(steps - limit)


# %% a list
# says: should be one number, but is a list
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return [max(0.0, price + rate * (steps - limit))]


# %% squared
# says: in this case it looks like this: the steps beyond the limit are squared; the rate times their number is added
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - limit) ** 2)


# %% nothing
# says: is a `return` missing?
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + max(0.0, price + rate * (steps - limit))


# %% a number
# says: price, steps, limit and rate
new_price = 3.0


# %% no parentheses
# says: the rate multiplies the steps alone: put steps − limit in parentheses
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * steps - limit)


# %% the rate before the price
# says: the rate stands before the old price; it belongs to the excess
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, rate * price + steps - limit)


# %% the rate of all
# says: the rate multiplies the old price, too, and that counts in full
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, rate * (price + steps - limit))


# %% divided
# says: the excess is divided by the rate; multiply it
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + (steps - limit) / rate)


# %% nothing below the limit
# says: after a dive below the limit the price is 0; it should fall by the rate times what was left
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return 0.0 if steps < limit else price + rate * (steps - limit)


# %% nothing within the limit
# says: after a dive within the limit the price is 0; it should fall by the rate times what was left
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return price + rate * (steps - limit) if steps > limit else 0.0


# %% the absolute value of the price
# says: the absolute value of the new price is taken; where it would fall below 0 it is 0
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return abs(price + rate * (steps - limit))


# %% a step more
# says: the excess is a step too large: a dive of exactly the limit is not too long
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - limit + 1))


# %% a step less
# says: the excess is a step too small: a dive is too long from limit + 1 on
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - limit - 1))


# %% plus the limit
# says: the limit is added; what counts is steps − limit
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps + limit))


# %% as it was
# says: the price stays as it was; the step is added
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return price


# %% price for rate
# says: the price and the rate have changed places
def new_price(price, steps, limit, rate):
    return max(0.0, rate + price * (steps - limit))


# %% only down
# says: the price only falls; after a long dive it should rise
def new_price(price, steps, limit, rate):
    return max(0.0, price - rate * max(0.0, limit - steps))


# %% rounded
# says: is it rounded? Give the number as it is, without round(), int() or //
def new_price(price, steps, limit, rate):
    return round(max(0.0, price + rate * (steps - limit)), 2)


# %% the limit of the text
# says: the limit is always 7, as in the text; use the `limit` that is given
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (steps - 7))


# %% the rate of the text
# says: the rate is always 0.01, as in the text; use the `rate` that is given
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + 0.01 * (steps - limit))


# %% steps taken off
# says: the steps lower the price, and they should raise it
# in: max
# - return max(0.0, price + rate * (steps - limit))
# + return max(0.0, price + rate * (-steps - limit))


# %% squared
# says: the steps beyond the limit are squared; the rate times their number is added
def new_price(price, steps, limit, rate):
    return max(0.0, price + rate * (steps - limit) * abs(steps - limit))


# %% not below the rate
# says: the price may fall to 0, and not only to the rate
def new_price(price, steps, limit, rate):
    return max(rate, price + rate * (steps - limit))


# %% not above 10
# says: new_price(40.0, 16, 8, 0.5) should be 44, but is 10: it is right in 5 of 6 cases
def new_price(price, steps, limit, rate):
    return min(max(0.0, price + rate * (steps - limit)), 10.0)

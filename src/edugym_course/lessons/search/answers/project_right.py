# %% a loop and a path
# slow
# says: Right: it solves all 14 riddles, and asks of the model what a search may ask.
def my_program(model, n_actions, state, n_simulations, seed):
    rng = np.random.default_rng(seed)
    N, Q = {}, {}
    for _ in range(n_simulations):
        node, here, path, rewards, ended = (), state, [], [], False
        while len(path) < 10 and not ended:
            if node not in N:
                N[node], Q[node] = np.zeros(n_actions), np.zeros(n_actions)
                if node != ():
                    break
            untried = np.flatnonzero(N[node] == 0)
            if len(untried):
                action = int(rng.choice(untried))
            else:
                bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
                action = int(np.argmax(Q[node] + bonus))
            reward, here, ended = model(here, action)
            path.append((node, action))
            rewards.append(reward)
            node = (*node, action, here)
        G, weight = 0.0, 1.0
        for _ in range(len(path), 10):
            if ended:
                break
            reward, here, ended = model(here, int(rng.integers(n_actions)))
            G += weight * reward
            weight *= 0.9
        for (visited, action), reward in zip(reversed(path), reversed(rewards)):
            G = reward + 0.9 * G
            N[visited][action] += 1
            Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
    return int(np.argmax(np.where(N[()] > 0, Q[()], -np.inf)))


# %% nodes are objects
# slow
class Node:
    def __init__(self, n_actions):
        self.returns = [[] for _ in range(n_actions)]
        self.children = {}

    def mean(self, action):
        return sum(self.returns[action]) / len(self.returns[action])


def my_program(model, n_actions, state, n_simulations, seed):
    rng = np.random.default_rng(seed)
    root = Node(n_actions)

    def visit(node, here, left):
        if left == 0:
            return 0.0
        if node is None:
            action = int(rng.integers(n_actions))
        else:
            total = 1 + sum(len(returns) for returns in node.returns)

            def bound(a):
                n = len(node.returns[a])
                return node.mean(a) + 5 * sqrt(log(total) / n) if n else inf

            order = rng.permutation(n_actions).tolist()
            action = max(order, key=bound)
        reward, after, ended = model(here, action)
        G = reward
        if not ended:
            child = None if node is None else node.children.get((action, after))
            if node is not None and child is None:
                node.children[action, after] = Node(n_actions)
            G += 0.9 * visit(child, after, left - 1)
        if node is not None:
            node.returns[action].append(G)
        return G

    for _ in range(n_simulations):
        visit(root, state, 10)
    tried = [a for a in range(n_actions) if root.returns[a]]
    return max(tried, key=root.mean)

"""Places for boxes and lanes for arrows of a graph without circles: rows by depth, few crossings, no arrow behind a box."""


def rows_of(uses):
    """Row of each node, 0 at the bottom: above all it uses, and as near to its users as makes no arrow longer in all."""
    row = {}

    def depth(node):
        if node not in row:
            row[node] = 1 + max((depth(other) for other in uses[node]), default=-1)
        return row[node]

    for node in sorted(uses):
        depth(node)
    users = {node: [user for user in uses if node in uses[user]] for node in uses}
    for node in sorted(uses, key=lambda one: (-row[one], one)):
        if users[node] and len(users[node]) >= len(uses[node]):
            row[node] = min(row[user] for user in users[node]) - 1
    return row


def with_lanes(uses, row):
    """Cuts arrows at every row they cross. Gives the rows as lists of nodes, links downwards, and the chain of each arrow."""
    rows = [[] for _ in range(max(row.values()) + 1)]
    down, chains = {node: [] for node in uses}, {}
    for node in sorted(uses):
        rows[row[node]].append(node)
    for user in sorted(uses):
        for used in sorted(uses[user]):
            chain = [user]
            for between in range(row[user] - 1, row[used], -1):
                lane = (user, used, between)
                rows[between].append(lane)
                down[lane] = []
                chain.append(lane)
            chain.append(used)
            for upper, lower in zip(chain, chain[1:]):
                down[upper].append(lower)
            chains[user, used] = chain
    return rows, down, chains


def crossings(rows, down):
    count = 0
    for upper, lower in zip(rows[1:], rows):
        place = {node: i for i, node in enumerate(lower)}
        ends = [place[other] for node in upper for other in sorted(down[node], key=place.get)]
        count += sum(a > b for i, a in enumerate(ends) for b in ends[i + 1:])
    return count


def untangled(rows, down):
    """Rows in an order with few crossings: each node to the mean of its neighbours, up and down, the best kept."""
    up = {node: [] for node in down}
    for node, others in down.items():
        for other in others:
            up[other].append(node)
    best, fewest = [list(row) for row in rows], crossings(rows, down)
    for sweep in range(60):
        order = range(1, len(rows)) if sweep % 2 else range(len(rows) - 2, -1, -1)
        near, step = (down, -1) if sweep % 2 else (up, 1)
        for i in order:
            place = {node: k for k, node in enumerate(rows[i + step])}
            own = {node: k for k, node in enumerate(rows[i])}
            rows[i].sort(key=lambda node: sum(place[other] for other in near[node]) / len(near[node])
                         if near[node] else own[node])
        exchange(rows, down)
        if crossings(rows, down) < fewest:
            best, fewest = [list(row) for row in rows], crossings(rows, down)
    return best, up


def exchange(rows, down):
    """Swaps neighbours wherever that removes crossings."""
    for row in rows:
        for i in range(len(row) - 1):
            before = crossings(rows, down)
            row[i], row[i + 1] = row[i + 1], row[i]
            if crossings(rows, down) >= before:
                row[i], row[i + 1] = row[i + 1], row[i]


def spread(rows, down, up, width, gap, lane):
    """Centres of nodes in x: near the mean of their neighbours, in order, without overlap."""
    def half(node):
        return lane / 2 if isinstance(node, tuple) else width / 2

    def room(a, b):
        return half(a) + half(b) + gap

    x = {}
    for row in rows:
        at = 0
        for i, node in enumerate(row):
            at += room(row[i - 1], node) if i else 0
            x[node] = at
    for _ in range(200):
        for row in rows:
            wish = [sum(x[o] for o in down[n] + up[n]) / len(down[n] + up[n]) if down[n] + up[n] else x[n] for n in row]
            left, right = list(wish), list(wish)
            for i in range(1, len(row)):
                left[i] = max(wish[i], left[i - 1] + room(row[i - 1], row[i]))
            for i in range(len(row) - 2, -1, -1):
                right[i] = min(wish[i], right[i + 1] - room(row[i], row[i + 1]))
            for node, a, b in zip(row, left, right):
                x[node] = (a + b) / 2  # both keep the distances, so does their mean
    least = min(x[node] - half(node) for node in x)
    return {node: round(x[node] - least) for node in x}


def arrange(uses, width, gap, lane):
    """Gives {node: (centre x, row)}, {(user, used): [(x, row), ...] from user to used}, the whole width, and the number of rows."""
    row = rows_of(uses)
    rows, down, chains = with_lanes(uses, row)
    rows, up = untangled(rows, down)
    x = spread(rows, down, up, width, gap, lane)
    row.update({node: i for i, line in enumerate(rows) for node in line})
    places = {node: (x[node], row[node]) for node in uses}
    ways = {ends: [(x[node], row[node]) for node in chain] for ends, chain in chains.items()}
    whole = max(x[node] + (lane if isinstance(node, tuple) else width) / 2 for node in x)
    return places, ways, round(whole), len(rows)

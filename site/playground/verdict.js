// What came of a race: how each agent ended, who did best, who has learned nothing, and who had bet right.

import { estimate, short, summary, within } from './chart.js'

const LATE = 10 // points of a curve: the last tenth of a race, so far
export const LUCK = 'Was it luck? “Other luck” repeats the race.'
const NOTHING = 0.1 // whoever has won less than this share of what the best one has, has learned nothing that shows

// The return in the last tenth of a race: `greedy` without exploring, and `exploring` in the games of training, over the
// `n` seeds in which such a game has ended; null where none has. Each is a mean and half an interval.
export function ending(curves, t) {
  const mean = values => values.reduce((sum, value) => sum + value, 0) / values.length
  const late = curves.map(curve => curve.slice(-LATE))
  const found = late.map(points => points.map(([, , exploring]) => exploring).filter(one => one !== null && one !== undefined))
  const ended = found.filter(({ length }) => length).map(mean)
  return { greedy: estimate(late.map(points => mean(points.map(([, value]) => value))), t), exploring: ended.length ? estimate(ended, t) : null, n: ended.length }
}

// Those that are as good as the best, as far as it can be told: with one seed, what differs by 3 % of it, or of the best
// possible, is as good.
function best(results, of, optimum) {
  const [top, spread] = results.map(of).reduce((a, b) => b[0] > a[0] ? b : a)
  return results.filter(result => {
    const [mean, half] = of(result)
    return top - mean <= (result.curves.length > 1 ? half + spread : 0.03 * Math.max(Math.abs(top), Math.abs(optimum ?? 0)))
  })
}

const listed = names => names.length > 1 ? `${names.slice(0, -1).join(', ')} and ${names.at(-1)}` : names[0]
const ORDER = ['the first', 'the second', 'the third'] // a race has three agents
// What an agent is called: where several have the same label, with its place among them.
const called = (agents, { label }, i) => {
  const same = agents.flatMap((other, k) => other.label === label ? [k] : [])
  return same.length > 1 ? `${ORDER[same.indexOf(i)]} ${label}` : label
}
const begun = text => text[0].toUpperCase() + text.slice(1)

// How a line goes: its end, its start, how far it stretches, and after how many steps it was nearly as high as at its end.
function course(curves, t) {
  const line = summary(curves, t), values = line.map(([, value]) => value), end = ending(curves, t)
  const highest = Math.max(...values), span = highest - Math.min(...values)
  return { ...end, span, highest, start: values[0], reached: line.find(([, value]) => value >= end.greedy[0] - 0.1 * span)[0] }
}

// `agents` have a label, and the curves of their seeds; `bet` is the number of one of them, or null, and `optimum` the best return, or null.
export function verdict(agents, t, steps, bet, optimum) {
  const results = agents.map(({ curves }, i) => {
    return { label: called(agents, agents[i], i), curves, ...course(curves, t) }
  })
  const good = best(results, ({ greedy }) => greedy, optimum), [top] = good.map(({ greedy }) => greedy).sort(([a], [b]) => b - a)
  const still = results.every(({ greedy, start, span }) => greedy[0] - start <= NOTHING * span)
  if (still && good.length === results.length) {
    const perfect = optimum !== null && results.every(({ greedy: [mean] }) => optimum - mean <= 0.03 * Math.abs(optimum))
    const dipped = results.some(({ span }) => span > 0.03 * Math.abs(optimum)) ? ', if not always between' : ''
    if (perfect) return `All play as well as can be, and did so before training too${dipped}: chance is enough for this task. Try a harder one.`
    return 'Nobody has learned anything that shows. Try more steps, or an easier task.'
  }
  const soonest = Math.min(...good.map(({ reached }) => reached))
  const winners = good.filter(({ reached }) => reached <= soonest + steps / 50)
  const named = (some, of = ({ greedy }) => greedy) => [...some].sort((a, b) => of(b)[0] - of(a)[0]).map(one => `${one.label} (${within(of(one))})`)
  const how = good.length === results.length ? 'did equally well' : 'did best'
  const said = (some, one, several) => some.length ? [`${begun(listed(named(some)))} ${some.length > 1 ? several : one}.`] : []
  const first = good.length > winners.length ? `, and ${listed(winners.map(({ label }) => label))} got there first` : ''
  const sentences = [`${begun(listed(named(good)))} ${how} in the last tenth of training${first}.`]
  const rest = results.filter(one => !good.includes(one))
  const fell = rest.filter(({ greedy: [mean, half], start, span }) => start - mean > Math.max(half, NOTHING * span))
  const failed = rest.filter(one => !fell.includes(one) && one.greedy[0] - one.start < NOTHING * (top[0] - one.start))
  const rose = failed.filter(({ start, highest }) => highest - start > 0.03 * (top[0] - start))
  sentences.push(...said(rest.filter(one => !failed.includes(one) && !fell.includes(one)), 'is behind', 'are behind'))
  sentences.push(...said(rose, 'rose, but ended where it began', 'rose, but ended where they began'))
  sentences.push(...said(failed.filter(one => !rose.includes(one)), 'has learned nothing that shows', 'have learned nothing that shows'))
  sentences.push(...said(fell, 'ended lower than it began', 'ended lower than they began'))
  if (results.every(({ exploring }) => exploring)) {
    const earning = best(results, ({ exploring }) => exploring, optimum)
    if (winners.some(one => !earning.includes(one))) sentences.push(`While still exploring, ${listed(named(earning, ({ exploring }) => exploring))} earned most.`)
  }
  if (bet !== null) {
    const { label } = results[bet], slower = good.includes(results[bet]) ? 'did as well, but was slower' : 'was wrong'
    sentences.unshift(winners.includes(results[bet]) ? 'Your bet was right.' : `Your bet on “${label}” ${slower}.`)
  }
  if (agents[0].curves.length === 1) sentences.push(LUCK)
  return sentences.join(' ')
}

// How a reader's own agent compares with its rival; one seed shows no winner, but who did better with it.
export function duel(own, rival, t, optimum) {
  const results = [own, rival].map(agent => ({ ...agent, ...course(agent.curves, t) }))
  const good = best(results, ({ greedy }) => greedy, optimum), wins = own.curves.length > 1 ? 'wins' : 'did better with this seed'
  const [first, last] = [...results].sort((a, b) => a.reached - b.reached), who = one => one === results[0] ? 'your agent' : rival.label
  const sooner = last.reached - first.reached > own.curves[0].at(-1)[0] / 50
    ? `, but ${who(first)} got there after ${short(first.reached)} steps, ${who(last)} after ${short(last.reached)}` : ''
  const still = results.every(({ greedy, start, span }) => greedy[0] - start <= NOTHING * span && (optimum === null || optimum - greedy[0] > 0.03 * Math.abs(optimum)))
  const alike = still ? 'neither has learned anything that shows. Try an easier task, or more steps' : `no difference that shows${sooner}`
  const said = good.length > 1 ? alike : `${who(good[0])} ${wins}`
  return `In the last tenth of training your agent has ${within(results[0].greedy)}, ${rival.label} ${within(results[1].greedy)}: ${said}.`
}

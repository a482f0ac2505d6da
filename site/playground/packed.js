// A reader's program as letters of a link, and back.

export const LONGEST = 8_000 // letters of a link, which most programs can still pass on
const MOST = 200_000 // signs of a program, so that a link cannot fill the memory

// The letters that stand for a text: compressed, in base64url.
export async function pack(text) {
  const bytes = await whole(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw')))
  const letters = btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''))
  return letters.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

// The text; undefined where letters stand for none.
export async function unpack(letters) {
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), sign => sign.charCodeAt(0))
    const text = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(await whole(text))
  } catch {
    return undefined
  }
}

async function whole(stream) {
  const parts = []
  let size = 0
  for (const reader = stream.getReader(); ;) {
    const { done, value } = await reader.read()
    if (done) break
    parts.push(value)
    size += value.length
    if (size > MOST) throw new Error('too long')
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer())
}

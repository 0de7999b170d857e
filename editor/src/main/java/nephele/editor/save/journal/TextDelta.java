package nephele.editor.save.journal;

import java.util.Arrays;

/**
 * The difference of a text from the one before: bytes kept at both ends, and the new ones between them. An edit in one
 * place of a level is a few lines.
 */
record TextDelta(int prefix, int suffix, byte[] middle) {
    static TextDelta between(byte[] old, byte[] now) {
        int shorter = Math.min(old.length, now.length);
        int mismatch = Arrays.mismatch(old, now);
        int prefix = mismatch < 0 ? shorter : mismatch;
        int suffix = 0;
        while (suffix < shorter - prefix && old[old.length - 1 - suffix] == now[now.length - 1 - suffix]) {
            suffix++;
        }
        return new TextDelta(prefix, suffix, Arrays.copyOfRange(now, prefix, now.length - suffix));
    }

    /** Returns true if the difference can be one from this text. */
    boolean fits(byte[] old) {
        return prefix >= 0 && suffix >= 0 && (long) prefix + suffix <= old.length;
    }

    /** Returns the new text. */
    byte[] applied(byte[] old) {
        byte[] now = new byte[prefix + middle.length + suffix];
        System.arraycopy(old, 0, now, 0, prefix);
        System.arraycopy(middle, 0, now, prefix, middle.length);
        System.arraycopy(old, old.length - suffix, now, prefix + middle.length, suffix);
        return now;
    }
}

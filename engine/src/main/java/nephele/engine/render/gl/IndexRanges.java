package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.IntBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.MemoryUtil;

/** Index ranges for one multi-draw, in native memory that is reused from frame to frame. */
public final class IndexRanges implements GlObject {
    private final IntBuffer counts;
    private final PointerBuffer offsets;
    private int size;
    private long indexCount;

    public IndexRanges(int capacity) {
        counts = MemoryUtil.memAllocInt(capacity);
        offsets = MemoryUtil.memAllocPointer(capacity);
    }

    /** Replaces the content by the first {@code n} of {@code firsts} and {@code lengths}, in indices. */
    public void set(int[] firsts, int[] lengths, int n) {
        size = n;
        indexCount = 0;
        for (int i = 0; i < n; i++) {
            counts.put(i, lengths[i]);
            offsets.put(i, 4L * firsts[i]);
            indexCount += lengths[i];
        }
    }

    public int size() {
        return size;
    }

    public long indexCount() {
        return indexCount;
    }

    int[] firsts() {
        int[] firsts = new int[size];
        for (int i = 0; i < size; i++) {
            firsts[i] = (int) (offsets.get(i) / 4);
        }
        return firsts;
    }

    int[] counts() {
        int[] copy = new int[size];
        counts.slice(0, size).get(copy);
        return copy;
    }

    void multiDraw() {
        long countAddress = MemoryUtil.memAddress(counts, 0);
        nglMultiDrawElements(GL_TRIANGLES, countAddress, GL_UNSIGNED_INT, MemoryUtil.memAddress(offsets, 0), size);
    }

    @Override
    public void close() {
        MemoryUtil.memFree(counts);
        MemoryUtil.memFree(offsets);
    }
}

package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import nephele.engine.math.Vec3;

/** Vertices in the layout of the GPU buffer, appended shape by shape, with the range and the slot of each shape. */
final class VertexBytes {
    private final ByteBuffer bytes;
    private final int vertexBytes;
    private final int[] firsts;
    private final int[] ends;
    private final int[] slots;

    VertexBytes(int shapes, int vertices, int vertexBytes) {
        this.vertexBytes = vertexBytes;
        firsts = new int[shapes];
        ends = new int[shapes];
        slots = new int[shapes];
        bytes = ByteBuffer.allocateDirect(vertices * vertexBytes).order(ByteOrder.nativeOrder());
    }

    /** Returns the number of vertices so far; valid only after a complete vertex. */
    int count() {
        return bytes.position() / vertexBytes;
    }

    /** Begins a shape, which has a slot in the spatial index. */
    void begin(int shape, int slot) {
        firsts[shape] = count();
        slots[shape] = slot;
    }

    void end(int shape) {
        ends[shape] = count();
    }

    /** Returns the slot of a shape. */
    int slot(int shape) {
        return slots[shape];
    }

    /** Returns the first vertex of a shape. */
    int first(int shape) {
        return firsts[shape];
    }

    /** Returns the number of vertices of a shape. */
    int count(int shape) {
        return ends[shape] - firsts[shape];
    }

    /** Appends the vertices of a shape of the same layout. */
    void copy(VertexBytes from, int shape) {
        int length = from.count(shape) * vertexBytes;
        bytes.put(bytes.position(), from.bytes, from.first(shape) * vertexBytes, length);
        bytes.position(bytes.position() + length);
    }

    void position(Vec3 p, Vec3 cell) {
        bytes.putFloat((float) (p.x() - cell.x()));
        bytes.putFloat((float) (p.y() - cell.y()));
        bytes.putFloat((float) (p.z() - cell.z()));
    }

    /** Appends a unit vector with 16 bits per component, and an integer as the fourth component. */
    void normal(Vec3 n, int fourth) {
        bytes.putShort(unit16(n.x()));
        bytes.putShort(unit16(n.y()));
        bytes.putShort(unit16(n.z()));
        bytes.putShort((short) fourth);
    }

    private static short unit16(double x) {
        return (short) Math.round(x * Short.MAX_VALUE);
    }

    void floats(double s, double t) {
        bytes.putFloat((float) s);
        bytes.putFloat((float) t);
    }

    void shorts(double a, double b) {
        bytes.putShort((short) Math.round(a));
        bytes.putShort((short) Math.round(b));
    }

    /** Returns the bytes, direct and in native byte order. */
    ByteBuffer finished() {
        return bytes.flip();
    }
}

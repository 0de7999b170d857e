package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import nephele.engine.math.Vec3;

/** Vertices in the layout of the GPU buffer, appended one by one. */
final class VertexBytes {
    private final ByteBuffer bytes;
    private final int vertexBytes;

    VertexBytes(int vertices, int vertexBytes) {
        this.vertexBytes = vertexBytes;
        bytes = ByteBuffer.allocateDirect(vertices * vertexBytes).order(ByteOrder.nativeOrder());
    }

    /** Returns the number of vertices so far; valid only after a complete vertex. */
    int count() {
        return bytes.position() / vertexBytes;
    }

    /** Appends vertices of the same layout. */
    void copy(ByteBuffer from, int first, int vertices) {
        bytes.put(bytes.position(), from, first * vertexBytes, vertices * vertexBytes);
        bytes.position(bytes.position() + vertices * vertexBytes);
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

package nephele.engine.render.pass.rim;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import nephele.engine.portal.Aperture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import org.lwjgl.system.MemoryUtil;

/**
 * The rim of one aperture on the GPU, in the portal's own axes: a band with a raised profile along its edge, a flat
 * band for the glow around it, and the aperture's own area.
 */
final class RimShape implements GlObject {
    /** Width of the glow outside the aperture. */
    static final double REACH_METRES = 0.23;

    /** Pairs: metres outside the aperture's edge, metres in front of the wall. */
    private static final double[] RING = {
        0, 0, 0.004, 0.026, 0.016, 0.040, 0.024, 0.043, 0.076, 0.043, 0.088, 0.036, 0.096, 0.020, 0.1, 0
    };

    private static final double[] GLOW = {0.1, 0.002, REACH_METRES, 0.002};
    private static final double MEMBRANE_METRES = 0.003;
    /** Greatest length of a mitre at a corner, in widths of the band. */
    private static final double LONGEST_MITRE_BANDS = 1.6;

    private static final double CELL_METRES = 0.21;
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT4);

    private final Aperture aperture;
    private final GpuMesh mesh;
    private final int cells;
    private final int ringIndices;
    private final int glowIndices;
    private final int areaIndices;

    RimShape(GlContext gl, Aperture aperture) {
        this.aperture = aperture;
        int corners = aperture.corners();
        int ringRows = RING.length / 2;
        int glowRows = GLOW.length / 2;
        double[] lengths = lengths(aperture);
        cells = Math.max(8, 2 * (int) Math.round(lengths[corners] / CELL_METRES / 2));
        int vertices = (corners + 1) * (ringRows + glowRows + 1);
        ringIndices = 6 * corners * (ringRows - 1);
        glowIndices = 6 * corners * (glowRows - 1);
        areaIndices = 3 * (corners - 2);
        ByteBuffer bytes = MemoryUtil.memAlloc(vertices * FORMAT.strideBytes()).order(ByteOrder.nativeOrder());
        IntBuffer indices = MemoryUtil.memAllocInt(ringIndices + glowIndices + areaIndices);
        try {
            band(aperture, lengths, RING, bytes, indices);
            band(aperture, lengths, GLOW, bytes, indices);
            area(aperture, bytes, indices);
            mesh = new GpuMesh(gl, "rim", FORMAT, bytes.flip(), indices.flip());
        } finally {
            MemoryUtil.memFree(bytes);
            MemoryUtil.memFree(indices);
        }
    }

    /** Returns the length along the edge up to each corner, and the whole length. */
    private static double[] lengths(Aperture aperture) {
        int corners = aperture.corners();
        double[] lengths = new double[corners + 1];
        for (int i = 0; i < corners; i++) {
            int next = (i + 1) % corners;
            double x = aperture.cornerX(next) - aperture.cornerX(i);
            double y = aperture.cornerY(next) - aperture.cornerY(i);
            lengths[i + 1] = lengths[i] + Math.hypot(x, y);
        }
        return lengths;
    }

    private static void band(
            Aperture aperture, double[] lengths, double[] profile, ByteBuffer bytes, IntBuffer indices) {
        int rows = profile.length / 2;
        int first = bytes.position() / FORMAT.strideBytes();
        int corners = aperture.corners();
        for (int i = 0; i <= corners; i++) {
            for (int row = 0; row < rows; row++) {
                edge(aperture, i % corners, bytes);
                put(bytes, profile[2 * row], profile[2 * row + 1], lengths[i] / lengths[corners], 0);
            }
        }
        for (int i = 0; i < corners; i++) {
            for (int row = 0; row + 1 < rows; row++) {
                int at = first + i * rows + row;
                indices.put(at).put(at + 1).put(at + rows + 1);
                indices.put(at + rows + 1).put(at + rows).put(at);
            }
        }
    }

    /** Writes a corner and its outward direction, scaled so that the bands of both edges keep their width. */
    private static void edge(Aperture aperture, int corner, ByteBuffer bytes) {
        int before = (corner + aperture.corners() - 1) % aperture.corners();
        double x = aperture.edgeNormalX(corner) + aperture.edgeNormalX(before);
        double y = aperture.edgeNormalY(corner) + aperture.edgeNormalY(before);
        double square = x * x + y * y;
        double longer = Math.min(2 / square, LONGEST_MITRE_BANDS / Math.sqrt(square));
        put(bytes, aperture.cornerX(corner), aperture.cornerY(corner), x * longer, y * longer);
    }

    private static void area(Aperture aperture, ByteBuffer bytes, IntBuffer indices) {
        int first = bytes.position() / FORMAT.strideBytes();
        for (int i = 0; i < aperture.corners(); i++) {
            put(bytes, aperture.cornerX(i), aperture.cornerY(i), 0, 0);
            put(bytes, 0, MEMBRANE_METRES, 0, 0);
            if (i > 1) {
                indices.put(first).put(first + i - 1).put(first + i);
            }
        }
    }

    private static void put(ByteBuffer bytes, double x, double y, double z, double w) {
        bytes.putFloat((float) x).putFloat((float) y).putFloat((float) z).putFloat((float) w);
    }

    /** Returns true if it fits another portal's aperture. */
    boolean isOf(Aperture other) {
        return aperture == other
                || aperture.shape() == other.shape()
                        && aperture.widthMetres() == other.widthMetres()
                        && aperture.heightMetres() == other.heightMetres();
    }

    /** Returns the number of repeats of a pattern around it, an even number. */
    int cells() {
        return cells;
    }

    void drawRing() {
        mesh.draw(0, ringIndices);
    }

    void drawGlow() {
        mesh.draw(ringIndices, glowIndices);
    }

    void drawArea() {
        mesh.draw(ringIndices + glowIndices, areaIndices);
    }

    @Override
    public void close() {
        mesh.close();
    }
}

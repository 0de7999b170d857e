package nephele.engine.render.pass.cloud;

import java.util.Arrays;
import java.util.List;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.QuadStream;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;

/** A cloud's puffs as quads, the farthest first; puffs at equal distances keep their order. */
public final class PuffQuads implements GlObject {
    /** Floats of a vertex: the puff's centre relative to the eye and its deviation; extinction in its centre, and the corner. */
    private static final int FLOATS = 8;

    private static final int CORNERS = 4;

    private final QuadStream quads;
    private CloudPuffs uploaded;
    private Vec3 uploadedEye;
    private double uploadedFactor;
    private float[] vertices = new float[0];
    private long[] order = new long[0];

    public PuffQuads(GlContext gl) {
        quads = new QuadStream(gl, "puffs", VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT4));
    }

    /**
     * Uploads puffs as quads for an eye.
     *
     * @param eye in the space of the puffs
     * @param factor on their extinction
     */
    public void upload(CloudPuffs puffs, Vec3 eye, double factor) {
        if (puffs == uploaded && eye.equals(uploadedEye) && factor == uploadedFactor) {
            return;
        }
        uploaded = puffs;
        uploadedEye = eye;
        uploadedFactor = factor;
        List<CloudPuffs.Puff> all = puffs.all();
        if (order.length != all.size()) {
            order = new long[all.size()];
        }
        for (int i = 0; i < order.length; i++) {
            float distance = (float) all.get(i).centre().minus(eye).length();
            order[i] = (long) (Integer.MAX_VALUE - Float.floatToIntBits(distance)) << 32 | i;
        }
        Arrays.sort(order);
        makeRoom(order.length);
        for (int place = 0; place < order.length; place++) {
            put(place, all.get((int) order[place]), eye, factor);
        }
        quads.upload(vertices, FLOATS * CORNERS * order.length, order.length);
    }

    /** Uploads puffs in the order of a list. */
    public void upload(List<CloudPuffs.Puff> inOrder, Vec3 eye, double factor) {
        uploaded = null;
        makeRoom(inOrder.size());
        for (int place = 0; place < inOrder.size(); place++) {
            put(place, inOrder.get(place), eye, factor);
        }
        quads.upload(vertices, FLOATS * CORNERS * inOrder.size(), inOrder.size());
    }

    private void makeRoom(int puffs) {
        if (vertices.length < FLOATS * CORNERS * puffs) {
            vertices = new float[FLOATS * CORNERS * puffs];
        }
    }

    private void put(int place, CloudPuffs.Puff puff, Vec3 eye, double factor) {
        Vec3 centre = puff.centre().minus(eye);
        for (int corner = 0; corner < CORNERS; corner++) {
            int at = FLOATS * (CORNERS * place + corner);
            vertices[at] = (float) centre.x();
            vertices[at + 1] = (float) centre.y();
            vertices[at + 2] = (float) centre.z();
            vertices[at + 3] = (float) puff.deviationMetres();
            vertices[at + 4] = (float) (factor * puff.perMetre());
            vertices[at + 5] = corner == 0 || corner == 3 ? -1 : 1;
            vertices[at + 6] = corner < 2 ? -1 : 1;
        }
    }

    public void draw() {
        quads.draw();
    }

    /** Draws some of the puffs. */
    void draw(int first, int count) {
        quads.draw(first, count);
    }

    @Override
    public void close() {
        quads.close();
    }
}

package nephele.engine.render.resource;

import java.util.Arrays;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PolygonStream;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.scene.Opening;
import nephele.engine.scene.PicturePolygon;
import nephele.engine.scene.Projection;
import nephele.engine.scene.Reprojection;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewHistory;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;

/**
 * The openings of all views of a frame on the GPU; shader locations 0 clip position, 1 homogeneous lookup position of
 * the opening's picture. The part nearer than the near plane is moved into that plane, as separate triangles:
 * interpolation of depth from before the near plane to the far end of an opening would be lost to rounding.
 */
public final class OpeningMesh implements GlObject {
    public static final SharedResource<OpeningMesh> RESOURCE =
            SharedResource.of("openings", context -> context.own(new OpeningMesh(context.gl())));

    private static final int FLOATS_PER_VERTEX = 7;

    private final PolygonStream stream;
    private final PicturePolygon part = new PicturePolygon();
    private final Reprojection reprojection = new Reprojection();
    private float[] values = new float[4096];
    private int[] firsts = new int[64];
    private int floats;

    public OpeningMesh(GlContext gl) {
        stream = new PolygonStream(gl, "openings", VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT3));
    }

    /** Replaces the content by the openings of {@code tree}; terminal ones look up the picture of {@code history}. */
    public void upload(ViewTree tree, ViewHistory history) {
        floats = 0;
        for (int i = 1; i < tree.views().size(); i++) {
            ViewNode node = tree.views().get(i);
            reprojection.between(node.parent().view(), node.parent().view());
            put(node);
        }
        for (int i = 0; i < tree.terminals().size(); i++) {
            ViewNode node = tree.terminals().get(i);
            ViewNode before = history.of(node);
            View pictured =
                    before == null ? node.parent().view() : before.parent().view();
            reprojection.between(node.parent().view(), pictured);
            put(node);
        }
        if (floats > 0) {
            stream.upload(values, floats);
        }
    }

    private void put(ViewNode node) {
        if (firsts.length < node.number() + 2) {
            firsts = Arrays.copyOf(firsts, 2 * node.number() + 2);
        }
        firsts[node.number()] = floats / FLOATS_PER_VERTEX;
        Projection projection = node.parent().view().projection();
        part.copy(node.outline());
        part.keepNearer(projection.nearMetres());
        fan(projection);
        part.copy(node.outline());
        part.keepFarther(projection.nearMetres());
        fan(projection);
        firsts[node.number() + 1] = floats / FLOATS_PER_VERTEX;
    }

    private void fan(Projection projection) {
        for (int i = 2; i < part.size(); i++) {
            vertex(projection, 0);
            vertex(projection, i - 1);
            vertex(projection, i);
        }
    }

    private void vertex(Projection projection, int corner) {
        if (floats + FLOATS_PER_VERTEX > values.length) {
            values = Arrays.copyOf(values, 2 * values.length);
        }
        double x = part.x(corner);
        double y = part.y(corner);
        double w = part.w(corner);
        double z = w <= projection.nearMetres() ? -w : projection.depthOffset() - w * projection.depthScale();
        values[floats++] = (float) x;
        values[floats++] = (float) y;
        values[floats++] = (float) z;
        values[floats++] = (float) w;
        values[floats++] = (float) reprojection.x(x, y, w);
        values[floats++] = (float) reprojection.y(x, y, w);
        values[floats++] = (float) reprojection.w(x, y, w);
    }

    /** Returns the source of depth: a mirror is a whole face, a portal is a part of one. */
    public static DepthOf depthOf(ViewNode node) {
        return node.opening().portal() == Opening.NO_PORTAL ? DepthOf.WHOLE_FACE : DepthOf.OPENING;
    }

    /** Draws one opening with the current program. */
    public void draw(ViewNode node) {
        int first = firsts[node.number()];
        int count = firsts[node.number() + 1] - first;
        if (count > 0) {
            stream.draw(first, count);
        }
    }

    @Override
    public void close() {
        stream.close();
    }
}

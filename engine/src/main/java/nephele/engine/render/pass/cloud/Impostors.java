package nephele.engine.render.pass.cloud;

import nephele.engine.render.resource.RendererClouds;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Frustum;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.QuadStream;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.scene.View;
import org.joml.Matrix4d;

/**
 * The impostors of all clouds of balls. They are made for the eye of the main view, the most wrong ones first and as many
 * texels a frame as {@link ImpostorLimits} allows. A cloud without one that is right is drawn ball by ball.
 */
public final class Impostors {
    /** Two corners of a quad, as {@code quad.glsl} reads them, for each vertex. */
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};

    private final LoadContext context;
    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final int divisor;
    private final int side;
    private final Aabb surfaces;
    private final List<Impostor> all = new ArrayList<>();
    private final CloudCanvas canvas = new CloudCanvas(null, null);
    private final Frustum sight = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final DrawState.Limits before = new DrawState.Limits();
    private PerPixels<ImpostorProgram> programs;
    private QuadStream quad;
    private FrameUniforms uniforms;
    private ImpostorLimits limits;
    private Vec3 eye;
    private int cuts = -1;

    /**
     * @param divisor pixels along each side of one of the layer of clouds
     * @param side of the square of rays of which a frame draws one
     */
    Impostors(LoadContext context, int divisor, int side) {
        this.context = context;
        gl = context.gl();
        levelClouds = context.get(RendererClouds.RESOURCE);
        this.divisor = divisor;
        this.side = side;
        surfaces = context.scene().statics().bounds();
    }

    /** Owns the impostor of a cloud and returns it. */
    Impostor add(CloudContext clouds, Impostor impostor) {
        if (all.isEmpty()) {
            programs = new PerPixels<>(pixels -> new ImpostorProgram(clouds, pixels));
            uniforms = context.own(new FrameUniforms(gl, context.scene().level().environment()));
            quad = context.own(new QuadStream(gl, "impostor", VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT4)));
            uploadQuad();
        }
        all.add(context.own(impostor));
        return impostor;
    }

    private void uploadQuad() {
        float[] vertices = new float[8 * 4];
        for (int corner = 0; corner < 4; corner++) {
            vertices[8 * corner + 5] = CORNERS[2 * corner];
            vertices[8 * corner + 6] = CORNERS[2 * corner + 1];
        }
        quad.upload(vertices, vertices.length, 1);
    }

    /** Makes pictures for the main view of a frame. In the first one after a cut it only forgets. */
    void follow(FrameContext frame) {
        if (all.isEmpty()) {
            return;
        }
        View view = frame.view();
        int height = frame.surface().height();
        if (limits == null || limits.pictureHeight() != height) {
            limits = new ImpostorLimits(context.quality().impostorErrorPixels(), height, divisor, side);
        }
        Vec3 moved = eye == null ? Vec3.ZERO : view.eye().minus(eye);
        eye = view.eye();
        if (cuts != levelClouds.cuts()) {
            cuts = levelClouds.cuts();
            all.forEach(Impostor::forget);
            return;
        }
        Frustum seen = frame.seen();
        for (int i = 0; i < all.size(); i++) {
            if (seen.mayIntersect(all.get(i).bounds())) {
                all.get(i).prepare(view, moved, limits);
            }
        }
        make(view);
    }

    private void make(View view) {
        long left = ImpostorLimits.MOST_TEXELS;
        Impostor next = neediest();
        if (next == null) {
            return;
        }
        gl.state().beginLayer(1, before);
        gl.state().noScissor();
        while (next != null && left > 0) {
            long drawn = draw(next, left);
            left = drawn == 0 ? 0 : left - drawn;
            next = neediest();
        }
        gl.state().endLayer(before);
        context.resources().resume(view);
    }

    private Impostor neediest() {
        Impostor most = null;
        for (int i = 0; i < all.size(); i++) {
            double need = all.get(i).need();
            most = need > 0 && (most == null || need > most.need()) ? all.get(i) : most;
        }
        return most;
    }

    /** Draws the next balls into a picture; returns the texels. */
    private long draw(Impostor impostor, long most) {
        ImpostorPicture picture = impostor.coming();
        int count = picture.fitting(most);
        if (count == 0) {
            return 0;
        }
        int slab = picture.nextSlab();
        View from = picture.view(impostor.placed());
        uniforms.upload(from, 1);
        picture.bindTarget();
        gl.state().set(DrawState.Depth.OFF, DrawState.Blend.PREMULTIPLIED_OVER_PASSING, DrawState.Cull.NONE);
        var grid = new ImpostorGrid(picture.slabs(), picture.slabs().slabs().get(slab));
        canvas.begin(CloudPixels.CAPTURED, from, levelClouds.current().focus(), grid);
        impostor.captureProgram().use(canvas, impostor.placed(), impostor.cells());
        long texels = picture.draw(count);
        if (picture.isComplete()) {
            impostor.change();
        }
        return texels;
    }

    /** Draws a cloud from its picture if it is in sight; returns false if its balls must be drawn. */
    boolean draw(Impostor impostor, CloudCanvas onto) {
        View view = onto.view();
        Aabb bounds = impostor.bounds();
        sight.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        sight.keepAll(view.clipFromRelative(clipFromRelative));
        if (!sight.mayIntersect(bounds)) {
            return true;
        }
        if (limits == null || !impostor.serves(view, limits)) {
            return false;
        }
        boolean holdsSurfaces = onto.pixels() != CloudPixels.WHOLE && surfaces.overlaps(bounds);
        if (holdsSurfaces || !isInFront(bounds, view.clip())) {
            return false;
        }
        programs.of(onto.pixels()).draw(onto, impostor, quad);
        return true;
    }

    private static boolean isInFront(Aabb box, Plane clip) {
        if (clip == null) {
            return true;
        }
        double x = clip.nx() > 0 ? box.minX() : box.maxX();
        double y = clip.ny() > 0 ? box.minY() : box.maxY();
        double z = clip.nz() > 0 ? box.minZ() : box.maxZ();
        return clip.signedDistance(x, y, z) > 0;
    }
}

package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.drawn.CloudPuffs.Puff;
import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Frustum;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.QuadStream;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.joml.Matrix4d;

/**
 * The impostors of all clouds of puffs. They are made for the eye of the main view, the most wrong ones first and as many
 * texels a frame as {@value #MOST_TEXELS}. A cloud without one that is right is drawn puff by puff.
 */
public final class Impostors {
    /** Texels that a frame draws at most for new pictures; puffs that cover each other count each. */
    static final long MOST_TEXELS = 1 << 19;

    private static final double FINEST_TEXEL = 0.5;

    /** Two corners of a quad, as {@code quad.glsl} reads them, for each vertex. */
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};

    private final LoadContext context;
    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final int divisor;
    private final int side;
    private final Aabb surfaces;
    private final List<Impostor> all = new ArrayList<>();
    private final CloudCanvas canvas = new CloudCanvas(null);
    private final Frustum sight = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final DrawState.Limits before = new DrawState.Limits();
    private CloudPrograms<QuadUniforms> programs;
    private QuadStream quad;
    private FrameUniforms uniforms;
    /** Pixels; 0 before the first frame. */
    private int pictureHeight;

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

    /**
     * The uniforms of {@code impostor.vert} and {@code impostor.frag}: the rectangle that is drawn, relative to the eye, and
     * the axes of a picture, the eye along them and its numbers.
     */
    private record QuadUniforms(
            CloudPrograms.Shared cloud,
            Vector3 quadCentre,
            Vector3 quadAcross,
            Vector3 quadUpwards,
            Vector3 slabRight,
            Vector3 slabUp,
            Vector3 slabForward,
            Vector3 eyeAtSlab,
            Vector4 slab) {}

    /** Makes and owns the impostor of a cloud. */
    Impostor add(CloudContext clouds, PuffCloud cloud) {
        if (all.isEmpty()) {
            programs = new CloudPrograms<>(
                    clouds, "impostor.vert", "impostor.frag", defines -> defines.with("QUADS"), QuadUniforms.class);
            uniforms = context.own(new FrameUniforms(gl, context.scene().level().environment()));
            quad = context.own(new QuadStream(gl, "impostor", VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT4)));
            uploadQuad();
        }
        Impostor impostor = context.own(new Impostor(gl, cloud));
        all.add(impostor);
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
        pictureHeight = frame.surface().height();
        Vec3 moved = eye == null ? Vec3.ZERO : view.eye().minus(eye);
        eye = view.eye();
        if (cuts != levelClouds.cuts()) {
            cuts = levelClouds.cuts();
            all.forEach(Impostor::forget);
            return;
        }
        Frustum visible = frame.frustum();
        for (int i = 0; i < all.size(); i++) {
            if (visible.mayIntersect(all.get(i).bounds())) {
                all.get(i).prepare(view, moved, this);
            }
        }
        make(view);
    }

    private void make(View view) {
        long left = MOST_TEXELS;
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

    /** Draws the next puffs into a picture; returns the texels. */
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
        double plane = picture.slabs().slabs().get(slab).middle();
        var grid = new CloudCanvas.Grid(
                1, 0, 0, 2.0 / picture.slabs().width(), 2.0 / picture.slabs().height(), plane, 0);
        canvas.begin(CloudPixels.CAPTURED, from, levelClouds.current().focus(), grid);
        impostor.cloud().use(canvas);
        long texels = picture.draw(count);
        if (picture.isComplete()) {
            impostor.change();
        }
        return texels;
    }

    /** Draws a cloud from its picture if it is in sight; returns false if its puffs must be drawn. */
    boolean draw(Impostor impostor, CloudCanvas onto) {
        View view = onto.view();
        Aabb bounds = impostor.bounds();
        sight.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        sight.keepAll(view.clipFromRelative(clipFromRelative));
        if (!sight.mayIntersect(bounds)) {
            return true;
        }
        if (pictureHeight == 0 || !impostor.serves(view, this)) {
            return false;
        }
        boolean holdsSurfaces = onto.pixels() != CloudPixels.WHOLE && surfaces.overlaps(bounds);
        if (holdsSurfaces || !isInFront(bounds, view.clip())) {
            return false;
        }
        drawSlabs(impostor, onto);
        return true;
    }

    private void drawSlabs(Impostor impostor, CloudCanvas onto) {
        QuadUniforms numbers = programs.use(onto.pixels());
        onto.put(numbers.cloud, impostor.placed());
        ImpostorPicture picture = impostor.drawn();
        PuffSlabs slabs = picture.slabs();
        Basis axes = slabs.axes();
        Vec3 moved = onto.view().eye().minus(impostor.placed().drift()).minus(slabs.eye());
        numbers.slabRight.set(axes.right());
        numbers.slabUp.set(axes.up());
        numbers.slabForward.setScaled(axes.back(), -1);
        numbers.eyeAtSlab.set(moved.dot(axes.right()), moved.dot(axes.up()), -moved.dot(axes.back()));
        for (int i = 0; i < slabs.slabs().size(); i++) {
            PuffSlabs.Slab slab = slabs.slabs().get(i);
            numbers.slab.set(
                    slab.middle(),
                    0.5 / slabs.tanHalfWidth(),
                    0.5 / slabs.tanHalfHeight(),
                    picture.presence(impostor.placed()));
            place(numbers, slabs, slab, moved, onto.margin());
            picture.bindTextures(i);
            quad.draw();
        }
    }

    private static void place(QuadUniforms numbers, PuffSlabs slabs, PuffSlabs.Slab slab, Vec3 moved, double margin) {
        PuffSlabs.Sides sides = slab.whole();
        Basis axes = slabs.axes();
        double metres = slab.middle();
        Vec3 centre = axes.right()
                .scaled(metres * (sides.left() + sides.right()) / 2)
                .addScaled(metres * (sides.low() + sides.high()) / 2, axes.up())
                .addScaled(-metres, axes.back())
                .minus(moved);
        double wider = margin * centre.length();
        numbers.quadCentre.set(centre);
        numbers.quadAcross.setScaled(axes.right(), metres * (sides.right() - sides.left()) / 2 + wider);
        numbers.quadUpwards.setScaled(axes.up(), metres * (sides.high() - sides.low()) / 2 + wider);
    }

    private static boolean isInFront(Aabb box, Plane clip) {
        return clip == null || clip.leastDistance(box) > 0;
    }

    /** Returns by how much a direction may be wrong: pixels are narrowest in the corners of a picture. */
    double toleranceRadians(View view) {
        Projection projection = view.projection();
        double corner = 1
                + projection.tanHalfWidth() * projection.tanHalfWidth()
                + projection.tanHalfHeight() * projection.tanHalfHeight();
        return context.quality().impostorErrorPixels() * pixel(view) / corner;
    }

    /** Returns the width at distance 1 of the finest texel of use: a picture between whose texels is interpolated is less sharp. */
    double texel(View view) {
        return FINEST_TEXEL * divisor * pixel(view);
    }

    /** Returns the pixels that the puffs are drawn into if a frame has no impostor of them. */
    double texelsDirectly(PuffSlabs slabs, View view) {
        double finest = side * divisor * pixel(view);
        double sum = 0;
        for (Puff puff : slabs.puffs()) {
            double width =
                    2 * puff.radiusMetres() / (puff.centre().minus(slabs.eye()).length() * finest);
            sum += width * width;
        }
        return sum;
    }

    private double pixel(View view) {
        return 2 * view.projection().tanHalfHeight() / pictureHeight;
    }
}

package nephele.engine.render.pass.billboard;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.particle.BackToFront;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Whole;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardQuads.Cluster;
import nephele.engine.render.resource.BillboardQuads.Kind;
import nephele.engine.render.resource.EyeUniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.View;

/**
 * Draws billboards in each view, turned to its eye or to the level's observer. Those with edges are drawn by clusters, in the order of
 * their places; blended ones each for itself, the farthest first, equal distances in the order of the level.
 */
public final class BillboardPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "billboard", Stage.IN_VIEWS, request -> requiredBy(request, Kind.WITH_EDGES))
            .using(SurfaceLight.RESOURCE, MeteredExposure.RESOURCE);

    public static final RenderFeature BLENDED = new RenderFeature(
                    "billboard.blended", Stage.IN_VIEWS_AFTER_OPAQUE, request -> requiredBy(request, Kind.BLENDED))
            .using(SurfaceLight.RESOURCE, MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/billboard/";

    /** The defines of what varies over a billboard and is interpolated between vertices. */
    private static final Set<String> VARYING = Set.of("SUN SKY_AMBIENT FLASH FOG AIR".split(" "));

    /** Cells along a side of a billboard over which light varies. */
    private static final int CELLS = 2;

    /** The same of large ones, over which the edges of shadows are visible. */
    private static final int LARGE_CELLS = 8;

    private static final double LARGE_PIXELS = 64;

    private final GlContext gl;
    private final Kind kind;
    private final Blend blend;
    private final TargetReads reads;
    private final SurfaceLight light;
    private final BillboardQuads quads;
    private final GlProgram<ImageUniforms> program;
    /** Whether the light at the vertices of a billboard, or the air before them, can differ. */
    private final boolean varies;

    private final BillboardList list;
    /** Billboards that are large in the picture. */
    private final BillboardList large;

    private final List<Cluster> visible = new ArrayList<>();
    private final BackToFront order = new BackToFront();
    private final float[] eye = new float[3];
    /** The tangent of half the angle of large billboards. */
    private double largeTangent;

    /** @param observer the place that billboards face; not read if they face the eye */
    private record ImageUniforms(EyeUniforms eye, @IfRead Vector3 observer, Whole perSheet, Whole verticesEach) {}

    private BillboardPass(LoadContext context, Kind kind, TargetReads reads) {
        this.kind = kind;
        this.reads = reads;
        gl = context.gl();
        light = context.get(SurfaceLight.RESOURCE);
        boolean isSampled = context.quality().samples() > 1;
        blend = kind == Kind.BLENDED ? Blend.COVER : isSampled ? Blend.REPLACE_COVERED_SAMPLES : Blend.REPLACE;
        quads = BillboardQuads.of(context, kind);
        MeteredExposure.readInViews(context);
        Map<String, String> defines = defines(context);
        varies = !Collections.disjoint(defines.keySet(), VARYING);
        program = GlProgram.of(gl, FOLDER + "billboard.vert", FOLDER + "billboard.frag", defines, ImageUniforms.class);
        list = context.own(new BillboardList(gl, varies ? CELLS : 1));
        large = context.own(new BillboardList(gl, LARGE_CELLS));
    }

    private Map<String, String> defines(LoadContext context) {
        Level level = context.scene().level();
        boolean isAnimated = level.billboards().stream()
                .anyMatch(group -> group.blended() && group.frames() > 1 && group.framesPerSecond() > 0);
        return light.addBounced(light.addForDynamicObjects(Defines.of(context)))
                .with("LAMBERT")
                .withIf(kind == Kind.BLENDED, "BLENDED")
                .withIf(isAnimated, "ANIMATED")
                .withIf(kind == Kind.BLENDED && context.request().fadesAtSurfaces(), "SURFACES")
                .withIf(level.observerStart() != null, "OBSERVER")
                .values();
    }

    private static List<Required> requiredBy(FrameRequest request, Kind kind) {
        List<Billboards> all = request.level().billboards();
        int[] found = IntStream.range(0, all.size())
                .filter(i -> all.get(i).blended() == (kind == Kind.BLENDED))
                .toArray();
        if (found.length == 0) {
            return List.of();
        }
        TargetReads light = request.lightMaps().dynamicObjects();
        TargetReads reads = kind == Kind.BLENDED && request.fadesAtSurfaces() ? light.and(Target.VIEW_DEPTH) : light;
        String because = "billboards[" + found[0] + "]: "
                + (kind == Kind.BLENDED ? "blended with what is behind them" : "pictures with edges");
        return List.of(new Required(because, context -> new BillboardPass(context, kind, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        quads.findVisible(frame.frustum(), visible);
        return kind == Kind.BLENDED && !visible.isEmpty();
    }

    @Override
    public void draw(FrameContext frame) {
        quads.findVisible(frame.frustum(), visible);
        if (visible.isEmpty()) {
            return;
        }
        quads.follow(frame.frameState().seconds());
        frame.surface().bind();
        Depth depth = kind == Kind.BLENDED ? Depth.LESS_OR_EQUAL : Depth.LESS_AND_WRITE;
        gl.state().set(depth, blend, Cull.NONE, frame.clipDistances());
        light.bind(reads);
        program.use();
        program.uniforms().eye().set(frame.view(), light.anchor());
        ObserverSphere observer = frame.frameState().observer();
        if (observer != null) {
            program.uniforms().observer().set(observer.centre().minus(light.anchor()));
        }
        quads.bind();
        setEye(frame.view(), frame.surface().height());
        if (kind == Kind.BLENDED) {
            drawSorted();
        } else {
            drawByClusters();
        }
    }

    private void drawByClusters() {
        for (int i = 0; i < visible.size(); i++) {
            Cluster cluster = visible.get(i);
            for (int image = cluster.first(); image < cluster.end(); image++) {
                listOf(image).add(image);
            }
            if (i + 1 == visible.size() || visible.get(i + 1).array() != cluster.array()) {
                draw(list, cluster.array());
                draw(large, cluster.array());
            }
        }
    }

    /** @param pictureHeight pixels */
    private void setEye(View view, int pictureHeight) {
        largeTangent =
                varies ? LARGE_PIXELS * view.projection().tanHalfHeight() / pictureHeight : Double.POSITIVE_INFINITY;
        eye[0] = (float) (view.eyeX() - light.anchor().x());
        eye[1] = (float) (view.eyeY() - light.anchor().y());
        eye[2] = (float) (view.eyeZ() - light.anchor().z());
    }

    private BillboardList listOf(int image) {
        double half = quads.half(image);
        return half * half > largeTangent * largeTangent * squareDistance(image) ? large : list;
    }

    private float squareDistance(int image) {
        float x = quads.middle(image, 0) - eye[0];
        float y = quads.middle(image, 1) - eye[1];
        float z = quads.middle(image, 2) - eye[2];
        return x * x + y * y + z * z;
    }

    private void drawSorted() {
        order.begin(quads.count());
        for (Cluster cluster : visible) {
            for (int image = cluster.first(); image < cluster.end(); image++) {
                order.add(image, squareDistance(image));
            }
        }
        order.sort();
        int array = quads.array(order.at(0));
        BillboardList run = listOf(order.at(0));
        for (int i = 0; i < order.count(); i++) {
            int image = order.at(i);
            if (quads.array(image) != array || listOf(image) != run) {
                draw(run, array);
                array = quads.array(image);
                run = listOf(image);
            }
            run.add(image);
        }
        draw(run, array);
    }

    /** Draws a list of images with pictures of one array, and empties it. */
    private void draw(BillboardList images, int array) {
        if (images.count() > 0) {
            quads.bindSprites(array);
            program.uniforms().perSheet().set(images.perSheet());
            program.uniforms().verticesEach().set(images.vertices());
            images.draw();
            images.begin();
        }
    }
}

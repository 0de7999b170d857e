package nephele.engine.render.pass.lightning;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.lightning.Bolt;
import nephele.engine.lightning.LevelLightning;
import nephele.engine.math.Vec3;
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
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.scene.View;

/**
 * Adds the bolt of a strike to each view: behind surfaces it is hidden, and clouds in front of a point take from it what
 * the pass of clouds has found. Between strikes it draws nothing.
 *
 * <p>Each segment of the bolt is a rectangle of pixels around it, in which it is spread by a disc. The channel is spread
 * over little more than a pixel, or over its width where that is more; small shares of its light are spread widely, as in
 * an eye or a lens.
 */
public final class LightningPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "lightning", Stage.IN_VIEWS_AFTER_OPAQUE, LightningPass::requiredBy)
            .using(FrameLightning.RESOURCE, MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/lightning/";

    /** Share of a bolt's light that comes from the channel itself; clouds around it scatter most of the rest. */
    private static final double CHANNEL_FRACTION = 0.1;

    /** Points of the main channel from one to the next where it is spread widely. */
    private static final int COARSE = 8;

    /**
     * A share of the light.
     *
     * @param radius over which it is spread, as a share of the picture's height; 0 for that of the channel
     */
    private record Spread(double weight, double radius) {}

    private static final Spread CHANNEL = new Spread(0.9, 0);
    private static final Spread[] GLARE = {new Spread(0.06, 0.011), new Spread(0.04, 0.05)};

    private record Places(
            Uniforms.Vector3 boltFromEye,
            Uniforms.Vector3 intensityPerMetre,
            Uniforms.Vector3 brightness,
            Uniforms.Vector3 spreading,
            Uniforms.Vector2 halfPicture) {}

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final FrameLightning lightning;
    private final TargetReads reads;
    private final GlProgram<Places> program;
    private final GpuMesh quads;

    private LightningPass(LoadContext context) {
        gl = context.gl();
        targets = context.targets();
        lightning = context.get(FrameLightning.RESOURCE);
        boolean hasClouds = hasClouds(context.request());
        reads = hasClouds ? TargetReads.of(Target.BOLT_TRANSMITTANCE) : TargetReads.of();
        MeteredExposure.readInViews(context);
        var defines = Defines.of(context).withIf(hasClouds, "CLOUDS").values();
        program = GlProgram.of(gl, FOLDER + "bolt.vert", FOLDER + "bolt.frag", defines, Places.class);
        quads = context.own(GpuMesh.squares(gl, "segments of a bolt", Bolt.MOST_POINTS));
    }

    private static boolean hasClouds(FrameRequest request) {
        return !WeatherClouds.all(request.level().environment()).isEmpty();
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.level().environment().hasLightning()
                ? List.of(new Required(
                        "environment.lightning: "
                                + request.level().environment().lightning().strikesPerMinute()
                                + " strikes a minute",
                        LightningPass::new))
                : List.of();
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        if (!lightning.isLit()) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.ADD, Cull.NONE, frame.clipDistances());
        reads.bind(targets);
        program.use();
        lightning.bindPoints(TextureUnit.BOLT_POINTS);
        put(frame, lightning.lightning());
        draw(frame, CHANNEL, 1, lightning.lightning().bolt().points() - 1);
        for (Spread glare : GLARE) {
            draw(frame, glare, COARSE, Bolt.MAIN_SEGMENTS / COARSE);
        }
    }

    private void put(FrameContext frame, LevelLightning lightning) {
        View view = frame.view();
        Bolt bolt = lightning.bolt();
        Places places = program.uniforms();
        Vec3 from = bolt.origin().minus(view.eye());
        places.boltFromEye.set((float) from.x(), (float) from.y(), (float) from.z());
        Vec3 perMetre =
                lightning.lightning().radiantIntensity().scaled(CHANNEL_FRACTION / Math.max(1, bolt.lengthMetres()));
        places.intensityPerMetre.set((float) perMetre.x(), (float) perMetre.y(), (float) perMetre.z());
        places.halfPicture.set(frame.surface().width() / 2f, frame.surface().height() / 2f);
        double pixel = 2 * view.projection().tanHalfHeight() / frame.surface().height();
        places.brightness.set((float) lightning.brightness(), (float) lightning.branchBrightness(), (float) pixel);
    }

    private void draw(FrameContext frame, Spread spread, int step, int segments) {
        int height = frame.surface().height();
        program.uniforms().spreading.set((float) spread.weight, (float) (spread.radius * height), step);
        quads.drawInstanced(0, GpuMesh.SQUARE_INDICES * segments, 1);
    }
}

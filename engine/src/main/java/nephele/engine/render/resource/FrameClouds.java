package nephele.engine.render.resource;

import java.util.List;
import java.util.function.Function;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.ShaftClouds;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;

/** The clouds of a level at the time of the frame. */
public final class FrameClouds implements GlObject {
    /** Bodies can leave the static shapes by this distance and still find the shade of their place. */
    private static final double SHADE_MARGIN_METRES = 10;

    /** {@code null} without clouds. */
    private final CloudTimeline timeline;

    private Environment followed;
    private CloudInterval now;
    private Vec3 focus = Vec3.ZERO;

    /** Shares the clouds of a level, each drawn by one of {@code techniques}. */
    static FrameClouds of(LoadContext context, List<CloudTechnique> techniques) {
        Quality quality = context.quality();
        Function<CloudOptics, CloudLight> physics =
                optics -> context.owner().lasting(CloudLight.class, optics, () -> new CloudLight(optics));
        return context.share(
                FrameClouds.class,
                madeFrom(context.scene(), quality, techniques),
                () -> new FrameClouds(context.scene(), context.drawn().clouds().drawnBy(techniques), quality, physics));
    }

    /** Returns what the clouds of a level follow from: edits of anything else leave them as they are. */
    private static List<?> madeFrom(Scene scene, Quality quality, List<CloudTechnique> techniques) {
        return List.of(
                new Identity(scene.assets()),
                CloudTimeline.causes(scene.level().environment()),
                shadeRegion(scene.statics()),
                quality.cloudLightCell(),
                quality.proceduralNoise(),
                techniques);
    }

    private FrameClouds(Scene scene, LoadedClouds loaded, Quality quality, Function<CloudOptics, CloudLight> physics) {
        timeline = loaded.clouds().isEmpty()
                ? null
                : new CloudTimeline(
                        scene.level().environment(),
                        loaded,
                        shadeRegion(scene.statics()),
                        quality.cloudLightCell(),
                        quality.proceduralNoise(),
                        physics);
    }

    /** Returns the region in which surfaces can be in the shade of clouds; beyond it, its border's shade holds. */
    public static Aabb shadeRegion(StaticShapes statics) {
        Aabb bounds = statics.bounds();
        return (bounds.isEmpty() ? new Aabb(0, 0, 0, 0, 0, 0) : bounds).grown(SHADE_MARGIN_METRES);
    }

    /** Returns true if the clouds and the light in them never change. */
    public boolean isSteady() {
        return timeline == null || timeline.isSteady();
    }

    /** Takes the clouds of a frame, sampled finely around its eye. */
    public void follow(FrameState frameState, Vec3 eye) {
        if (sources().isEmpty()) {
            return;
        }
        Environment environment = frameState.environment();
        boolean isSame =
                now != null && environment == followed && frameState.seconds() == now.seconds() && eye.equals(focus);
        if (!isSame) {
            followed = environment;
            focus = eye;
            now = timeline.at(environment, frameState.seconds(), eye);
        }
    }

    /** Returns the clouds that have any extinction. */
    public List<CloudSource> sources() {
        return timeline == null ? List.of() : timeline.sources();
    }

    /** Returns the clouds that cast shadows into the air; {@code null} if none does. */
    public ShaftClouds shafts() {
        return timeline == null ? null : timeline.shafts();
    }

    /** Returns the clouds of the frame; {@code null} before the first frame, and without clouds. */
    public CloudInterval now() {
        return now;
    }

    /** Returns the place around which layers are sampled finely. */
    public Vec3 focus() {
        return focus;
    }

    @Override
    public void close() {
        if (timeline != null) {
            timeline.close();
        }
    }
}

package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import nephele.engine.level.Environment;
import nephele.engine.level.Environment.Lightning;
import nephele.engine.lightning.Bolt;
import nephele.engine.lightning.LevelLightning;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.FrameState;
import org.lwjgl.system.MemoryUtil;

/** The lightning of a level at the time of the frame, with the points of its bolt on the GPU. */
public final class FrameLightning implements GlObject {
    public static final SharedResource<FrameLightning> RESOURCE = SharedResource.of("lightning", FrameLightning::of)
            .following((lightning, frame) -> lightning.follow(frame.frameState()));

    /** Place on the main channel from which surfaces are lit as if all light came from there. */
    private static final double MIDDLE = 0.4;

    /** Light that comes from lit clouds on all sides, as a share of that of the bolt. */
    private static final double GLOW_FRACTION = 0.45;

    private final LevelLightning lightning;
    private final BufferTexture points;
    private final FloatBuffer staging = MemoryUtil.memAllocFloat(Bolt.STRIDE * Bolt.MOST_POINTS);
    private long uploaded = Long.MIN_VALUE;

    private FrameLightning(GlContext gl, Lightning description) {
        lightning = new LevelLightning(description);
        points = BufferTexture.changing(gl, "points of a bolt");
    }

    private static FrameLightning of(LoadContext context) {
        Environment environment = context.scene().level().environment();
        return environment.hasLightning()
                ? context.own(new FrameLightning(context.gl(), environment.lightning()))
                : null;
    }

    /** Takes the time of a frame. */
    private void follow(FrameState frameState) {
        lightning.at(frameState.seconds(), frameState.flashStyle());
        if (lightning.isLit() && lightning.strike() != uploaded) {
            upload();
            uploaded = lightning.strike();
        }
    }

    /** The fourth number is the share of the current; negative where a polyline begins. */
    private void upload() {
        Bolt bolt = lightning.bolt();
        staging.clear();
        for (int i = 0; i < bolt.points(); i++) {
            float fraction = bolt.get(i, 3);
            staging.put(bolt.get(i, 0)).put(bolt.get(i, 1)).put(bolt.get(i, 2));
            staging.put(bolt.begins(i) ? -fraction : fraction);
        }
        points.upload(staging.flip());
    }

    /** Returns true if a strike is seen in the frame. */
    public boolean isLit() {
        return lightning.isLit();
    }

    public LevelLightning lightning() {
        return lightning;
    }

    /** Binds the points of the bolt: place from its origin, and the share of the current. */
    public void bindPoints(TextureUnit unit) {
        points.bind(unit);
    }

    /** Returns the radiant intensity of the bolt. */
    public Vec3 radiantIntensity() {
        return lightning.lightning().radiantIntensity().scaled(lightning.brightness());
    }

    /** Returns where the light on surfaces comes from. */
    public Vec3 middle() {
        return lightning.bolt().origin().plus(lightning.bolt().along(MIDDLE));
    }

    /** Returns the square of the distance that softens the light near a bolt, as its length does. */
    public double softeningSquare() {
        double soft = lightning.bolt().lengthMetres() / 4;
        return soft * soft + 1;
    }

    /** Returns the irradiance from lit clouds on a surface at a place that faces upwards. */
    public Vec3 glow(Vec3 place) {
        Vec3 away = place.minus(middle());
        double square = away.x() * away.x() + away.y() * away.y() + away.z() * away.z();
        return radiantIntensity().scaled(GLOW_FRACTION / (square + softeningSquare()));
    }

    @Override
    public void close() {
        points.close();
        MemoryUtil.memFree(staging);
    }
}

package nephele.engine.render.resource;

import java.util.Arrays;
import java.util.List;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SmoothSky;
import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.SkyThroughClouds;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.CelestialPositions;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.SkyIrradiance;
import nephele.engine.scene.probe.LitSurfaces;
import nephele.engine.scene.probe.SkyProbes;
import nephele.engine.scene.probe.SkyProbes.Sampling;
import org.joml.Vector3d;

/** The light of a level's sky on surfaces, and what of the sky they see where they have no place in the light map. */
public final class AmbientLight {
    public static final SharedResource<AmbientLight> RESOURCE = SharedResource.of("ambient light", AmbientLight::new);

    /** The light on what has no place in the light map; {@code null} if no sky shines and no light was baked. */
    public static final SharedResource<SkyProbes> PROBES = SharedResource.of("probes", AmbientLight::probes)
            .following((probes, frame) -> probes.begin(frame.frameState().layerGains()));

    /** Along a side of the cube over which an atmosphere's light, of degree 2, is integrated. */
    private static final int SMOOTH_CELLS = 16;

    private final LoadContext context;
    private final RendererClouds clouds;
    /** The atmosphere's tables; {@code null} for another sky. */
    private AirTables airTables;

    private AmbientLight(LoadContext context) {
        this.context = context;
        clouds = context.get(RendererClouds.RESOURCE);
    }

    private static SkyProbes probes(LoadContext context) {
        Scene scene = context.scene();
        if (LightRequirements.bounces(scene.light())) {
            Sampling sampling = Sampling.every(context.quality().probeMetres());
            return new SkyProbes(scene.statics(), () -> surfaces(context), sampling);
        }
        return LightRequirements.skyShines(scene.level()) ? new SkyProbes(scene.statics()) : null;
    }

    /** Returns a key for what follows from the light that surfaces reflect. */
    static Identity bouncedKey(Scene scene) {
        return new Identity(LightRequirements.bounces(scene.light()) ? scene.light() : null);
    }

    /** Returns the static geometry of a level whose light was baked, with the light that they send back. */
    static LitSurfaces surfaces(LoadContext context) {
        return context.shareValue(
                LitSurfaces.class, new Identity(context.scene()), () -> new LitSurfaces(context.scene()));
    }

    /** Returns what the light without clouds follows from: the sky, and the sun if the sky depends on it. */
    List<?> causes(Environment now) {
        Sun sun = now.sky() instanceof Sky.Atmosphere ? now.sun() : null;
        return Arrays.asList(context.openedLevel(), now.sky(), sun);
    }

    /** Returns the light in an environment, under the clouds of the frame. */
    public SkyIrradiance irradiance(Environment now) {
        CloudInterval interval = clouds.current().now();
        SkyIrradiance clear = clearIrradiance(now);
        return interval == null ? clear : under(interval, now, clear);
    }

    /** Returns the light without clouds. */
    public SkyIrradiance clearIrradiance(Environment now) {
        if (now.sky() instanceof Sky.Atmosphere sky) {
            return now.sun() == null ? SkyIrradiance.black() : irradiance(sky, now.sun());
        }
        return context.shareValue(SkyIrradiance.class, causes(now), () -> SkyRadiance.of(
                        now, context.get(PictureArrays.DECODED), ColourDecoding.SRGB)
                .map(SkyIrradiance::of)
                .orElseGet(SkyIrradiance::black));
    }

    private SkyIrradiance irradiance(Sky.Atmosphere sky, Sun sun) {
        if (airTables == null || !airTables.air().equals(Daylight.air(sky))) {
            airTables =
                    context.shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
        }
        Vec3 towardsSun = Directions.unit(sun.directionTowardsSun());
        SmoothSky smooth = new SmoothSky(airTables, towardsSun);
        Moonlight moon = Moonlight.of(sky, sun);
        SmoothSky moonlit = new SmoothSky(airTables, moon.towardsMoon());
        Vector3d moonlight = moon.irradiance().toVector();
        Vector3d outside = sun.irradiance().toVector();
        return SkyIrradiance.of(
                (height, x, y, z) -> smooth.radiance(x, y, z)
                        .add(CelestialPositions.nightGlow(sky, towardsSun.y(), y)
                                .toVector())
                        .add(moonlit.radiance(x, y, z).mul(moonlight))
                        .mul(outside),
                SMOOTH_CELLS);
    }

    /** Returns the light of the sky under clouds, as the middle of the level sees it. */
    private static SkyIrradiance under(CloudInterval clouds, Environment now, SkyIrradiance clear) {
        double ground = clouds.groundFraction();
        OutsideOfCloud around = around(now, clear, ground);
        SkyThroughClouds sky = clouds.from().sky();
        return SkyIrradiance.of(
                (height, x, y, z) -> sky.from(
                        clouds.to().sky(),
                        clouds.fraction(),
                        clear.radiance(x, y, z).mul(y < 0 ? ground : 1),
                        around,
                        new Vector3d(x, y, z)),
                SkyThroughClouds.SIDE);
    }

    /** Returns the light around clouds. @param ground share of its light that the plain keeps */
    private static OutsideOfCloud around(Environment now, SkyIrradiance clear, double ground) {
        Sun sun = Daylight.onGround(now);
        return new OutsideOfCloud(
                CloudTimeline.towardsSun(now),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                Vec3.of(clear.ambient(0, 1, 0)),
                Vec3.of(clear.ambient(0, -1, 0)).scaled(ground));
    }
}

package nephele.engine.render.pass.sky;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.resource.FrameUniforms;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws the light that the air scatters, the planet's ground, the sun's disc, moon and stars where no solid has been
 * drawn. Fog hides them. The twin of {@code atmosphere.frag} is {@link SkyTable#radiance}.
 */
public final class AtmospherePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("sky.atmosphere", Stage.IN_VIEWS, Role.SKY, AtmospherePass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/sky/";
    /** Below the largest half float. */
    private static final double MOST_RADIANCE = 60_000;

    private final FullScreenDrawing drawing;
    private final Texture texture;
    private Numbers numbers;
    private AirTables tables;
    private Sky.Atmosphere skyShown;
    private Sun sunShown;
    private Vec3 towardsSun;
    private double daysShown = Double.NaN;
    private Key shown;
    private CompletableFuture<Made> coming;

    private record Numbers(
            Vector3 towardsSun,
            Vector3 irradiance,
            Vector3 disc,
            Scalar horizon,
            Scalar mieG,
            Vector3 towardsMoon,
            Vector3[] celestial,
            Vector3 depth) {
        static Numbers of(Uniforms uniforms) {
            return new Numbers(
                    uniforms.vector3("towardsSun"),
                    uniforms.vector3("irradiance"),
                    uniforms.vector3("disc"),
                    uniforms.scalar("horizon"),
                    uniforms.scalar("mieG"),
                    uniforms.vector3("towardsMoon"),
                    new Vector3[] {
                        uniforms.vector3("equinox"), uniforms.vector3("eastOfEquinox"), uniforms.vector3("northPole")
                    },
                    uniforms.vector3("zenithDepth"));
        }
    }

    /** What a table depends on beside the air. */
    private record Key(double heightMetres, double sunSine) {}

    private record Made(Key key, SkyTable table) {}

    private AtmospherePass(LoadContext context, Sky.Atmosphere sky) {
        drawing = new FullScreenDrawing(
                context, FOLDER, new FullScreenDrawing.Stages("sky.vert", "atmosphere.frag"), uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    uniforms.sampler("skyTable", TextureUnit.COLOURS);
                    numbers = Numbers.of(uniforms);
                });
        tables = context.shared().shareValue(AirTables.class, Daylight.air(sky), () -> AirTables.of(Daylight.air(sky)));
        texture = context.own(new Texture(
                context.gl(),
                "sky table",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA32F,
                new Texture.Extent(SkyTable.AZIMUTHS, SkyTable.ROWS, SkyTable.PARTS),
                Sampling.LINEAR_CLAMP));
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Environment environment = request.level().environment();
        boolean isSeen = FogTransmittance.of(environment).isEmpty();
        return isSeen && environment.sky() instanceof Sky.Atmosphere sky && environment.sun() != null
                ? List.of(new Required("environment.sky: an atmosphere", context -> new AtmospherePass(context, sky)))
                : List.of();
    }

    @Override
    public void draw(FrameContext frame) {
        Environment now = frame.frameState().environment();
        double height = shelf(frame.view().eye().y());
        Sky.Atmosphere sky = (Sky.Atmosphere) now.sky();
        double days = Heavens.days(sky, frame.frameState().seconds());
        if (sky != skyShown || now.sun() != sunShown) {
            followSun(sky, now.sun());
        }
        if (days != daysShown || sky != skyShown) {
            followStars(sky, days);
        }
        if (coming != null || shown == null || shown.heightMetres != height || shown.sunSine != towardsSun.y()) {
            followTable(sky, new Key(height, towardsSun.y()));
        }
        skyShown = sky;
        texture.bind(TextureUnit.COLOURS);
        drawing.draw(frame.surface(), Depth.LESS_OR_EQUAL);
    }

    /** A table holds for heights that differ by less than can be seen. */
    private static double shelf(double heightMetres) {
        double near = Math.max(0, heightMetres);
        return near < 50 ? 2 : Math.exp(Math.round(Math.log(near) * 50) / 50.0);
    }

    private void followSun(Sky.Atmosphere sky, Sun sun) {
        if (!Daylight.air(sky).equals(tables.air())) {
            tables = AirTables.of(Daylight.air(sky));
            shown = null;
            coming = null;
        }
        sunShown = sun;
        towardsSun = Directions.unit(sun.directionTowardsSun());
        set(numbers.towardsSun, towardsSun);
        set(numbers.irradiance, sun.irradiance());
        numbers.mieG.set((float) tables.air().mieG());
        Vec3 zenith = tables.air().transmittance(0, 1);
        set(numbers.depth, new Vec3(-Math.log(zenith.x()), -Math.log(zenith.y()), -Math.log(zenith.z())));
    }

    private void followStars(Sky.Atmosphere sky, double days) {
        daysShown = days;
        set(numbers.towardsMoon, Heavens.towardsMoon(sky, days));
        Vec3[] axes = Heavens.celestialAxes(sky, days);
        for (int i = 0; i < axes.length; i++) {
            set(numbers.celestial[i], axes[i]);
        }
    }

    /** The first table is waited for; while the sun moves, the next one is computed beside the frames. */
    private void followTable(Sky.Atmosphere sky, Key wanted) {
        if (coming != null && coming.isDone()) {
            show(coming.join());
            coming = null;
        }
        if (wanted.equals(shown) || coming != null) {
            return;
        }
        if (shown == null || sky.dayLengthSeconds() == 0) {
            show(make(wanted));
        } else {
            coming = CompletableFuture.supplyAsync(() -> make(wanted));
        }
    }

    private Made make(Key key) {
        return new Made(key, new SkyTable(tables, key.heightMetres, key.sunSine));
    }

    private void show(Made made) {
        shown = made.key;
        numbers.horizon.set((float) made.table.horizonRadians());
        set(numbers.disc, disc(sunShown.irradiance(), made.key.heightMetres, made.key.sunSine));
        var texels = MemoryUtil.memAlloc(4 * Float.BYTES * SkyTable.AZIMUTHS * SkyTable.ROWS);
        for (int part = 0; part < SkyTable.PARTS; part++) {
            FloatBuffer numbersOfPart = texels.asFloatBuffer();
            made.table.putTexels(part, numbersOfPart);
            texture.upload(part, texels);
        }
        MemoryUtil.memFree(texels);
    }

    /** Returns the radiance of the disc's middle. */
    private Vec3 disc(Vec3 outside, double eyeHeight, double sunSine) {
        double horizon = Math.sin(SkyTable.horizonRadians(eyeHeight));
        Vec3 dimmed = tables.air().transmittance(Math.max(0, eyeHeight), Math.max(horizon + 1e-6, sunSine));
        double steradians = Math.PI * Daylight.SUN_RADIUS_RADIANS * Daylight.SUN_RADIUS_RADIANS;
        return new Vec3(
                Math.min(MOST_RADIANCE, outside.x() * dimmed.x() / steradians),
                Math.min(MOST_RADIANCE, outside.y() * dimmed.y() / steradians),
                Math.min(MOST_RADIANCE, outside.z() * dimmed.z() / steradians));
    }

    private static void set(Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}

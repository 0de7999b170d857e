package nephele.engine.render.pass.sky;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws the light that the air scatters, the planet's ground, the sun's disc, moon and stars where no solid has been
 * drawn. Fog hides them. The twin of {@code atmosphere.frag} is {@link SkyTable#radiance}.
 */
public final class AtmospherePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("sky.atmosphere", Stage.IN_VIEWS, Role.SKY, AtmospherePass::requiredBy);

    private final SkyProgram day;
    /** With moon and stars; {@code null} until the sun has set, since the software renderer executes every branch. */
    private SkyProgram night;

    private final LoadContext context;
    private final Texture texture;
    private AirTables tables;
    private Sky.Atmosphere skyShown;
    private Sun sunShown;
    private Vec3 towardsSun;
    private Key shown;
    private CompletableFuture<Made> coming;

    /** What a table depends on beside the air. */
    private record Key(double heightMetres, double sunSine) {}

    private record Made(Key key, SkyTable table) {}

    private AtmospherePass(LoadContext context, Sky.Atmosphere sky) {
        this.context = context;
        day = SkyProgram.of(context, false);
        tables = context.shared().shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
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
        if (sky != skyShown || now.sun() != sunShown) {
            followSun(sky, now.sun());
        }
        if (coming != null || shown == null || shown.heightMetres != height || shown.sunSine != towardsSun.y()) {
            followTable(sky, new Key(height, towardsSun.y()));
        }
        skyShown = sky;
        SkyProgram program = program();
        program.sun(sunShown, towardsSun, tables.air(), shown.heightMetres);
        if (program == night) {
            program.heavens(sky);
        }
        texture.bind(TextureUnit.COLOURS);
        program.draw(frame.surface());
    }

    private SkyProgram program() {
        if (towardsSun.y() >= 0) {
            return day;
        }
        if (night == null) {
            night = SkyProgram.of(context, true);
        }
        return night;
    }

    /** A table holds for heights that differ by less than can be seen. */
    private static double shelf(double heightMetres) {
        double near = Math.max(0, heightMetres);
        return near < 50 ? 2 : Math.exp(Math.round(Math.log(near) * 50) / 50.0);
    }

    private void followSun(Sky.Atmosphere sky, Sun sun) {
        if (!Daylight.air(sky).equals(tables.air())) {
            tables = AirCache.tables(Daylight.air(sky));
            shown = null;
            coming = null;
        }
        sunShown = sun;
        towardsSun = Directions.unit(sun.directionTowardsSun());
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
        var texels = MemoryUtil.memAlloc(4 * Float.BYTES * SkyTable.AZIMUTHS * SkyTable.ROWS);
        for (int part = 0; part < SkyTable.PARTS; part++) {
            FloatBuffer numbersOfPart = texels.asFloatBuffer();
            made.table.putTexels(part, numbersOfPart);
            texture.upload(part, texels);
        }
        MemoryUtil.memFree(texels);
    }
}

package nephele.engine.render.pass.sky;

import java.util.List;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.appearance.SunAndMoon;
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
import nephele.engine.render.resource.HeightCache;
import nephele.engine.render.resource.SunAndMoonTables;

/**
 * Draws the light that the air scatters, the planet's ground, the sun's disc, moon and stars where no solid has been
 * drawn. Fog hides them. The twins of {@code atmosphere.frag} are {@link SkyTable#radiance} and, for moon and
 * stars, {@link NightSky}.
 */
public final class AtmospherePass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "sky.atmosphere", Stage.IN_VIEWS, Role.SKY, AtmospherePass::requiredBy)
            .using(SunAndMoonTables.THREADS);

    private final SkyProgram day;
    /** With moon and stars; {@code null} until the sun has set, since the software renderer executes every branch. */
    private SkyProgram night;

    private final LoadContext context;
    private final HeightCache byHeight;
    private AirTables tables;
    private SunAndMoon lights;

    private AtmospherePass(LoadContext context, Sky.Atmosphere sky) {
        this.context = context;
        day = new SkyProgram(context, false);
        tables = context.shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
        byHeight = context.own(new HeightCache(this::tables));
    }

    private SunAndMoonTables tables(double heightMetres) {
        AirTables air = tables;
        var extent = new Texture.Extent(SkyTable.AZIMUTHS, SkyTable.ROWS, 2 * SkyTable.PARTS);
        return new SunAndMoonTables(
                new Texture(
                        context.gl(),
                        "sky table",
                        Texture.Shape.ARRAY,
                        PixelFormat.RGBA32F,
                        extent,
                        Sampling.LINEAR_CLAMP),
                context.get(SunAndMoonTables.THREADS),
                heightMetres,
                sine -> new SkyTable(air, heightMetres, sine).texels());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Environment environment = request.level().environment();
        boolean isVisible = !FogTransmittance.hidesSky(environment);
        return isVisible && environment.sky() instanceof Sky.Atmosphere sky && environment.sun() != null
                ? List.of(new Required("environment.sky: an atmosphere", context -> new AtmospherePass(context, sky)))
                : List.of();
    }

    @Override
    public void draw(FrameContext frame) {
        double height = frame.view().eye().y();
        follow(frame.frameState().environment());
        SunAndMoonTables near = byHeight.near(height, lights);
        near.show(lights);
        SkyProgram program = program();
        program.sun(lights, tables.air(), near.heightMetres(), height);
        if (program == night) {
            program.heavens(lights);
        }
        near.bind(TextureUnit.COLOURS);
        program.draw(frame.surface());
    }

    private SkyProgram program() {
        if (lights.towardsSun().y() >= 0) {
            return day;
        }
        if (night == null) {
            night = new SkyProgram(context, true);
        }
        return night;
    }

    private void follow(Environment now) {
        if (lights != null && lights.areOf(now)) {
            return;
        }
        lights = SunAndMoon.of(now);
        Air air = Daylight.air((Sky.Atmosphere) now.sky());
        if (!air.equals(tables.air())) {
            tables = AirCache.tables(air);
            byHeight.clear();
        }
    }
}

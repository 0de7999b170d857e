package nephele.engine.render.pass.sky;

import java.util.List;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.AerialPerspective;
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
    private final SkyTableLayers sunTable;
    private final SkyTableLayers moonTable;
    private AirTables tables;
    private Sky.Atmosphere skyShown;
    private Sun sunShown;
    private Vec3 towardsSun;
    private Moonlight moonlight;

    private AtmospherePass(LoadContext context, Sky.Atmosphere sky) {
        this.context = context;
        day = SkyProgram.of(context, false);
        tables = context.shared()
                .shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
        texture = context.own(new Texture(
                context.gl(),
                "sky table",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA32F,
                new Texture.Extent(SkyTable.AZIMUTHS, SkyTable.ROWS, 2 * SkyTable.PARTS),
                Sampling.LINEAR_CLAMP));
        sunTable = new SkyTableLayers(texture, 0);
        moonTable = new SkyTableLayers(texture, SkyTable.PARTS);
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
        double height = AerialPerspective.shelf(frame.view().eye().y());
        Sky.Atmosphere sky = (Sky.Atmosphere) now.sky();
        if (sky != skyShown || now.sun() != sunShown) {
            followSun(sky, now.sun());
        }
        sunTable.follow(tables, height, towardsSun.y(), sky.dayLengthSeconds());
        if (moonlight.shines()) {
            moonTable.follow(tables, height, moonlight.towardsMoon().y(), sky.dayLengthSeconds());
        }
        skyShown = sky;
        SkyProgram program = program();
        program.sun(sunShown, towardsSun, tables.air(), sunTable.heightMetres());
        if (program == night) {
            program.heavens(sky, moonlight);
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

    private void followSun(Sky.Atmosphere sky, Sun sun) {
        if (!Daylight.air(sky).equals(tables.air())) {
            tables = AirCache.tables(Daylight.air(sky));
        }
        sunShown = sun;
        towardsSun = Directions.unit(sun.directionTowardsSun());
        moonlight = Moonlight.of(sky, sun);
    }
}

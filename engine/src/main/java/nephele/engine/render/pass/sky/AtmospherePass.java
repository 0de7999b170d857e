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
import nephele.engine.level.appearance.NightSky;
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
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.ByHeight;

/**
 * Draws the light that the air scatters, the planet's ground, the sun's disc, moon and stars where no solid has been
 * drawn. Fog hides them. The twins of {@code atmosphere.frag} are {@link SkyTable#radiance} and, for moon and
 * stars, {@link NightSky}.
 */
public final class AtmospherePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("sky.atmosphere", Stage.IN_VIEWS, Role.SKY, AtmospherePass::requiredBy);

    private final SkyProgram day;
    /** With moon and stars; {@code null} until the sun has set, since the software renderer executes every branch. */
    private SkyProgram night;

    private final LoadContext context;
    private final ByHeight<SkyTextures> byHeight;
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
        byHeight = context.own(new ByHeight<>(
                height -> new SkyTextures(context.gl(), context.shared().background(), tables, height)));
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
        double height = frame.view().eye().y();
        Sky.Atmosphere sky = (Sky.Atmosphere) now.sky();
        if (sky != skyShown || now.sun() != sunShown) {
            followSun(sky, now.sun());
        }
        skyShown = sky;
        boolean isMoving = Daylight.moves(now);
        SkyTextures shown = byHeight.near(
                height,
                textures -> textures.isReady(towardsSun, moonlight, isMoving),
                textures -> textures.prepare(towardsSun, moonlight));
        if (isMoving) {
            follow(shown, now);
        } else {
            show(shown);
        }
        SkyProgram program = program();
        program.sun(sunShown, towardsSun, tables.air(), new SkyProgram.Heights(shown.heightMetres(), height));
        if (program == night) {
            program.heavens(sky, moonlight);
        }
        shown.bind(TextureUnit.COLOURS);
        program.draw(frame.surface());
    }

    private void follow(SkyTextures shown, Environment now) {
        Sky.Atmosphere sky = skyShown;
        shown.sun().follow(towardsSun.y(), seconds -> Daylight.sunSineAfter(now, seconds));
        if (moonlight.shines()) {
            shown.moon().follow(moonlight.towardsMoon().y(), seconds -> Moonlight.sineAfter(sky, seconds));
        }
    }

    private void show(SkyTextures shown) {
        shown.sun().show(towardsSun.y());
        if (moonlight.shines()) {
            shown.moon().show(moonlight.towardsMoon().y());
        }
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
            byHeight.clear();
        }
        sunShown = sun;
        towardsSun = Directions.unit(sun.directionTowardsSun());
        moonlight = Moonlight.of(sky, sun);
    }
}

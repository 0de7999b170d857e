package nephele.engine.render.frame;

import java.util.HashMap;
import java.util.Map;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.scene.ViewTree;

/** The preprocessor definitions with which a pass compiles its shaders. */
public final class Defines {
    /** The level of detail of textures below that of the picture, in which several frames are averaged. */
    private static final double FINER_LEVELS = 1;

    private final Map<String, String> values = new HashMap<>();

    /**
     * Returns the output, tone curve, fog and air of {@code context}, which {@code output.glsl} needs, and whether there may
     * be openings.
     */
    public static Defines of(LoadContext context) {
        Environment environment = context.scene().level().environment();
        Defines defines = new Defines();
        if (context.request().isAccumulated()) {
            double resolution = context.quality().pictureResolution();
            double textureBias = Math.log(resolution) / Math.log(2) - FINER_LEVELS;
            defines.with("TEXTURE_BIAS", textureBias);
        }
        return defines.withIf(context.quality().samples() > 1, "MULTISAMPLED")
                .with(context.output().define())
                .with(ToneMapping.define(environment.toneCurve()))
                .withIf(context.request().metersExposure(), "EXPOSURE_METERED")
                .withIf(context.request().storesDistance(), "DISTANCE_STORED")
                .withIf(FogTransmittance.of(environment).isPresent(), "FOG")
                .withIf(
                        FogTransmittance.of(environment).isPresent() && !FogTransmittance.hidesSky(environment),
                        "FOG_LAYER")
                .withIf(SunAndMoon.lightAir(environment), "AIR")
                .withIf(SunAndMoon.moonLightsAir(environment), "MOONLIT_AIR")
                .withIf(ShaftLight.isIn(environment), "SHAFTS")
                .withIf(ViewTree.mayGrow(context.scene().level()), "PORTALS")
                .withIf(!context.scene().mirrors().isEmpty(), "MIRRORS");
    }

    public Defines with(String name) {
        return with(name, 1);
    }

    public Defines with(String name, int value) {
        values.put(name, Integer.toString(value));
        return this;
    }

    public Defines with(String name, double value) {
        values.put(name, Double.toString(value));
        return this;
    }

    public Defines withIf(boolean wanted, String name) {
        return wanted ? with(name) : this;
    }

    public Map<String, String> values() {
        return Map.copyOf(values);
    }
}

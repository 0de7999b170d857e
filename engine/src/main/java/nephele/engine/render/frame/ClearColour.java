package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The colour behind everything, computed once on the CPU: a constant sky and fog without end need no pass. */
public record ClearColour(float red, float green, float blue) {
    public static ClearColour of(Environment environment, Output output) {
        return of(environment, output, new Vector3d(1));
    }

    /** Returns the clear colour of a view that mirrors tint; {@code this} for others. */
    public ClearColour in(View view, Environment environment, Output output) {
        return view.isTinted() ? of(environment, output, view.tint()) : this;
    }

    private static ClearColour of(Environment environment, Output output, Vector3dc tint) {
        Vec3 sky = environment.sky() instanceof Sky.Constant constant ? constant.radiance() : Vec3.ZERO;
        Vec3 radiance =
                FogTransmittance.hidesSky(environment) ? environment.fog().radiance() : sky;
        return new ClearColour(
                value(radiance.x() * tint.x(), environment, output),
                value(radiance.y() * tint.y(), environment, output),
                value(radiance.z() * tint.z(), environment, output));
    }

    /**
     * Returns a colour.
     *
     * @param rgb 0xRRGGBB, as stored
     */
    public static ClearColour of(int rgb) {
        return new ClearColour((rgb >> 16) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f);
    }

    private static float value(double radiance, Environment environment, Output output) {
        return switch (output) {
            case PLAIN -> (float) radiance;
            case HDR -> (float) Math.min(radiance, LuminanceHistogram.LARGEST_HALF);
            case DIRECT -> (float) ToneMapping.displayValue(radiance, exposure(environment), environment.toneCurve());
        };
    }

    /** Returns the factor on radiance; 1 for auto, which no other output than HDR can meter. */
    public static double exposure(Environment environment) {
        return Math.pow(2, environment.exposureStops().stopsOr(0));
    }
}
